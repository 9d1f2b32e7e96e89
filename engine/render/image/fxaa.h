#pragma once

#include "engine/render/image/image.h"

namespace campuswalk::engine::render {

/// Half as wide and high: each pixel is the mean of four, in linear light. Width and height are even.
Image halved(const Image& image);

/// Smooths stairs along edges: where brightness changes across a pixel, it is mixed with its neighbour across
/// the edge, by how near it is to a step of the edge. Flat parts and fine texture keep their pixels. After
/// the idea of FXAA (Lottes 2009): from the finished image alone, so no sharper than that.
Image apply_fxaa(const Image& image);

}  // namespace campuswalk::engine::render

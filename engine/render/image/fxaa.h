#pragma once

#include "engine/render/image/image.h"

namespace campuswalk::engine::render {

/// Box-filters 2x2 pixels in linear light. Width and height must be even.
Image downsampled_by_two(const Image& image);

/// Anti-aliases a finished image like FXAA (Lottes 2009): a pixel on an edge is blended with its neighbour
/// across the edge, by its distance to the end of the edge. Flat areas and fine texture keep their pixels.
Image apply_fxaa(const Image& image);

}  // namespace campuswalk::engine::render

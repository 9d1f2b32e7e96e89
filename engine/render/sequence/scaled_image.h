#pragma once

#include "engine/render/image/image.h"

namespace campuswalk::engine::render {

/// Downsamples the image to `width` pixels, keeping its aspect ratio: each pixel is the mean of those that it
/// covers, in linear light. Images that aren't wider are returned unchanged.
Image scaled_down(const Image& image, int width);

}  // namespace campuswalk::engine::render

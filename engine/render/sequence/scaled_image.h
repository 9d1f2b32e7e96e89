#pragma once

#include "engine/render/image/image.h"

namespace campuswalk::engine::render {

/// The image made smaller to `width` pixels, its height in proportion and 1 at least: each pixel is the
/// mean of those that it covers, in linear light. One that isn't wider stays as it is.
Image scaled_down(const Image& image, int width);

}  // namespace campuswalk::engine::render

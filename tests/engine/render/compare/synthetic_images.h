#pragma once

#include <random>

#include "engine/render/image/image.h"

namespace campuswalk::engine::render::test {

/// Uniform noise.
Image noise(int width, int height, std::mt19937& random);

/// Changes the channels of a number of pixels by at most `levels`.
Image disturbed(const Image& image, double share, int levels, std::mt19937& random);

}  // namespace campuswalk::engine::render::test

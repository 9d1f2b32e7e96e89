#pragma once

#include <random>

#include "engine/render/image/image.h"

namespace campuswalk::engine::render::test {

/// Every channel of every pixel any value.
Image noise(int width, int height, std::mt19937& random);

/// So many of the pixels, each of their channels moved by `levels` at most, up or down.
Image disturbed(const Image& image, double share, int levels, std::mt19937& random);

}  // namespace campuswalk::engine::render::test

#pragma once

#include <random>

#include "engine/render/image/image.h"

namespace campuswalk::engine::render::test {

/// Every channel of every pixel any value.
Picture noise(int width, int height, std::mt19937& random);

/// So many of the pixels, each of their channels moved by `levels` at most, up or down.
Picture disturbed(const Picture& picture, double share, int levels, std::mt19937& random);

}  // namespace campuswalk::engine::render::test

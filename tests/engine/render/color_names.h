#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "engine/render/image/image.h"

namespace campuswalk::engine::render::test {

/// "red", "green", "blue", "yellow" or "grey" by which channels stand out, whatever the light; else "mixed".
std::string color_name(const std::array<std::uint8_t, 3>& rgb);
/// Of the pixel nearest to (x, y); "outside" when that is not in the picture.
std::string color_name(const Picture& picture, double x, double y);

/// The mean of the three channels, 0 to 255.
double brightness(const Picture& picture, int x, int y);
/// Of all pixels in the columns [left, right) and rows [top, bottom).
double mean_brightness(const Picture& picture, int left, int top, int right, int bottom);

/// How many pixels differ in any channel. The pictures have the same size.
std::size_t differing_pixels(const Picture& a, const Picture& b);

Picture plain_picture(int width, int height, const std::array<std::uint8_t, 3>& rgb);

}  // namespace campuswalk::engine::render::test

#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "engine/render/image/image.h"

namespace campuswalk::engine::render::test {

/// "red", "green", "blue", "yellow" or "grey" by the dominant channels, independent of brightness; else
/// "mixed".
std::string color_name(const std::array<std::uint8_t, 3>& rgb);
/// Of the pixel that contains (x, y); "outside" if that is not in the image.
std::string color_name(const Image& image, double x, double y);

/// The mean of the three channels, 0 to 255.
double brightness(const Image& image, int x, int y);
/// Of all pixels in the columns [left, right) and rows [top, bottom).
double mean_brightness(const Image& image, int left, int top, int right, int bottom);

/// How many pixels differ in any channel. The images have the same size.
std::size_t differing_pixels(const Image& a, const Image& b);

Image plain_image(int width, int height, const std::array<std::uint8_t, 3>& rgb);

}  // namespace campuswalk::engine::render::test

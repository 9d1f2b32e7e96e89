#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace campuswalk::scene {

/// 8-bit RGBA, top row first.
struct PixelView {
    int width = 0;
    int height = 0;
    std::span<const std::uint8_t> rgba;  ///< 4 * width * height bytes
};

/// Pixels that belong to nobody else.
struct Pixels {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;

    PixelView view() const { return {width, height, rgba}; }
};

/// The image, or a smaller copy of at most `width` x `height` pixels with the same proportions, each the mean
/// of those that it covers.
Pixels shrunk_to_fit(const PixelView& image, int width, int height);

/// The bytes of a WebP file. `quality` is from 0 to 100. Throws std::runtime_error for an image that is
/// larger than the format allows (16,383 pixels a side).
std::string encode_webp(const PixelView& image, float quality);
std::string encode_webp_lossless(const PixelView& image);

}  // namespace campuswalk::scene

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace campuswalk::engine::render {

/// A finished, opaque image: 8-bit sRGB, rows from top to bottom, 4 bytes per pixel (R, G, B, 255).
struct Image {
    int width = 0;   ///< pixels
    int height = 0;  ///< pixels
    std::vector<std::uint8_t> rgba;

    /// All bytes are `value`, but alpha.
    static Image filled(int width, int height, std::uint8_t value = 0) {
        Image image{width, height, {}};
        image.rgba.assign(image.offset(0, height), value);
        image.make_opaque();
        return image;
    }

    void make_opaque() {
        for (std::size_t i = 3; i < rgba.size(); i += 4) {
            rgba[i] = 255;
        }
    }

    /// Index into `rgba` of the pixel in column x and row y.
    std::size_t offset(int x, int y) const {
        return 4 *
               (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
    }
    /// Red, green, blue of the pixel in column x and row y.
    std::array<std::uint8_t, 3> pixel(int x, int y) const {
        const std::size_t i = offset(x, y);
        return {rgba[i], rgba[i + 1], rgba[i + 2]};
    }
};

}  // namespace campuswalk::engine::render

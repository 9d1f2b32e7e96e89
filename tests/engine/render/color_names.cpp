#include "tests/engine/render/color_names.h"

#include <algorithm>
#include <cmath>

namespace campuswalk::engine::render::test {

std::string color_name(const std::array<std::uint8_t, 3>& rgb) {
    const auto [r, g, b] = rgb;
    const int strongest = std::max({r, g, b});
    const auto strong = [strongest](int channel) { return channel > 0.7 * strongest; };
    const auto weak = [strongest](int channel) { return channel < 0.6 * strongest; };
    if (strong(r) && weak(g) && weak(b)) {
        return "red";
    }
    if (weak(r) && strong(g) && weak(b)) {
        return "green";
    }
    if (weak(r) && weak(g) && strong(b)) {
        return "blue";
    }
    if (strong(r) && strong(g) && weak(b)) {
        return "yellow";
    }
    const bool even = std::min({r, g, b}) > 0.85 * strongest;
    return even ? "grey" : "mixed";
}

std::string color_name(const Image& image, double x, double y) {
    const auto column = static_cast<int>(std::floor(x));
    const auto row = static_cast<int>(std::floor(y));
    if (column < 0 || row < 0 || column >= image.width || row >= image.height) {
        return "outside";
    }
    return color_name(image.pixel(column, row));
}

double brightness(const Image& image, int x, int y) {
    const auto [r, g, b] = image.pixel(x, y);
    return (r + g + b) / 3.0;
}

double mean_brightness(const Image& image, int left, int top, int right, int bottom) {
    double sum = 0.0;
    for (int y = top; y < bottom; ++y) {
        for (int x = left; x < right; ++x) {
            sum += brightness(image, x, y);
        }
    }
    return sum / ((right - left) * (bottom - top));
}

std::size_t differing_pixels(const Image& a, const Image& b) {
    std::size_t count = 0;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            count += a.pixel(x, y) != b.pixel(x, y) ? 1U : 0U;
        }
    }
    return count;
}

Image plain_image(int width, int height, const std::array<std::uint8_t, 3>& rgb) {
    Image image{width, height, {}};
    image.rgba.assign(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 255);
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        std::copy(rgb.begin(), rgb.end(), image.rgba.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return image;
}

}  // namespace campuswalk::engine::render::test

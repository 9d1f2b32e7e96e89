#include "tests/engine/render/compare/synthetic_images.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace campuswalk::engine::render::test {

Image noise(int width, int height, std::mt19937& random) {
    Image image{width, height, {}};
    image.rgba.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
        image.rgba[i] = static_cast<std::uint8_t>(i % 4 == 3 ? 255U : random() % 256U);
    }
    return image;
}

Image disturbed(const Image& image, double share, int levels, std::mt19937& random) {
    Image other = image;
    std::vector<std::size_t> pixels(image.rgba.size() / 4);
    std::iota(pixels.begin(), pixels.end(), std::size_t{0});
    std::shuffle(pixels.begin(), pixels.end(), random);
    pixels.resize(static_cast<std::size_t>(std::lround(share * static_cast<double>(pixels.size()))));
    const auto range = static_cast<unsigned>(2 * levels + 1);
    for (const std::size_t pixel : pixels) {
        for (std::size_t i = 4 * pixel; i < 4 * pixel + 3; ++i) {
            const int moved = other.rgba[i] + static_cast<int>(random() % range) - levels;
            other.rgba[i] = static_cast<std::uint8_t>(std::clamp(moved, 0, 255));
        }
    }
    return other;
}

}  // namespace campuswalk::engine::render::test

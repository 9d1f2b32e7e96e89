#include "tests/engine/render/compare/made_pictures.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace campuswalk::engine::render::test {

Picture noise(int width, int height, std::mt19937& random) {
    Picture picture{width, height, {}};
    picture.rgba.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (std::size_t i = 0; i < picture.rgba.size(); ++i) {
        picture.rgba[i] = static_cast<std::uint8_t>(i % 4 == 3 ? 255U : random() % 256U);
    }
    return picture;
}

Picture disturbed(const Picture& picture, double share, int levels, std::mt19937& random) {
    Picture other = picture;
    std::vector<std::size_t> pixels(picture.rgba.size() / 4);
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

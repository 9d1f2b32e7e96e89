#include "engine/render/sequence/scaled_image.h"

#include <algorithm>
#include <array>

#include "engine/render/image/srgb.h"

namespace campuswalk::engine::render {
namespace {

const std::array<float, 256>& linear_table() {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> values{};
        std::ranges::transform(linear_by_srgb_byte(), values.begin(),
                               [](double linear) { return static_cast<float>(linear); });
        return values;
    }();
    return table;
}

/// The nearest 8-bit sRGB value, by binary search in the table.
std::uint8_t nearest_srgb_byte(float value) {
    const auto& table = linear_table();
    const auto above = std::lower_bound(table.begin(), table.end(), value);
    if (above == table.begin()) {
        return 0;
    }
    if (above == table.end()) {
        return 255;
    }
    const bool upper = *above - value < value - *(above - 1);
    return static_cast<std::uint8_t>(above - table.begin() - (upper ? 0 : 1));
}

/// The source pixels [from, to) of a target pixel, at least one.
std::array<int, 2> covered(int index, int count, int size) {
    const int from = static_cast<int>(std::int64_t{index} * size / count);
    const int to = static_cast<int>(std::int64_t{index + 1} * size / count);
    return {from, std::max(to, from + 1)};
}

void mean(const Image& image, const std::array<int, 2>& columns, const std::array<int, 2>& rows,
          std::uint8_t* out) {
    std::array<float, 3> sums = {0, 0, 0};
    for (int y = rows[0]; y < rows[1]; ++y) {
        const std::uint8_t* pixel = &image.rgba[image.offset(columns[0], y)];
        for (int x = columns[0]; x < columns[1]; ++x, pixel += 4) {
            for (std::size_t c = 0; c < 3; ++c) {
                sums[c] += linear_table()[pixel[c]];
            }
        }
    }
    const auto count = static_cast<float>((columns[1] - columns[0]) * (rows[1] - rows[0]));
    for (std::size_t c = 0; c < 3; ++c) {
        out[c] = nearest_srgb_byte(sums[c] / count);
    }
}

}  // namespace

Image scaled_down(const Image& image, int width) {
    if (image.width <= width) {
        return image;
    }
    const int height =
        std::max(1, static_cast<int>((std::int64_t{image.height} * width + image.width / 2) / image.width));
    Image small = Image::filled(width, height);
    for (int y = 0; y < height; ++y) {
        const std::array<int, 2> rows = covered(y, height, image.height);
        for (int x = 0; x < width; ++x) {
            mean(image, covered(x, width, image.width), rows, &small.rgba[small.offset(x, y)]);
        }
    }
    return small;
}

}  // namespace campuswalk::engine::render

#include "engine/render/compare/image_mask.h"

#include <algorithm>

namespace campuswalk::engine::render {
namespace {

/// The end of a box, clamped to `size`. In 64 bits against overflow.
int end_of(int start, int length, int size) {
    return static_cast<int>(std::clamp<std::int64_t>(std::int64_t{start} + length, 0, size));
}

}  // namespace

ImageMask::ImageMask(int width, int height, std::span<const PixelBox> boxes) : width_(width) {
    if (boxes.empty()) {
        return;
    }
    hidden_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
    for (const PixelBox& box : boxes) {
        const int left = std::clamp(box.x, 0, width);
        const int right = std::max(left, end_of(box.x, box.width, width));
        for (int y = std::max(box.y, 0); y < end_of(box.y, box.height, height); ++y) {
            const auto row = hidden_.begin() + std::ptrdiff_t{y} * width;
            std::fill(row + left, row + right, std::uint8_t{1});
        }
    }
}

}  // namespace campuswalk::engine::render

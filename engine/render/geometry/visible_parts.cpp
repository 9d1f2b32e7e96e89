#include "engine/render/geometry/visible_parts.h"

#include <algorithm>

namespace campuswalk::engine::render {
namespace {

constexpr std::uint32_t kAcross = 1;
constexpr std::uint32_t kUpOrDown = 4;

/// For each pixel the length of the shortest way to one of another owner, in two sweeps (Rosenfeld and
/// Pfaltz, "Sequential Operations in Digital Image Processing", 1966).
std::vector<std::uint32_t> depths_inside(std::span<const std::uint32_t> owners, std::size_t width) {
    const std::size_t height = owners.size() / width;
    std::vector<std::uint32_t> depths(owners.size());
    const auto through = [&](std::size_t from, std::size_t to, std::uint32_t step) {
        return owners[from] == owners[to] ? depths[from] + step : step;
    };
    for (std::size_t i = 0; i < owners.size(); ++i) {
        const std::size_t x = i % width;
        const std::uint32_t left = x > 0 ? through(i - 1, i, kAcross) : kAcross;
        const std::uint32_t above = i >= width ? through(i - width, i, kUpOrDown) : kUpOrDown;
        depths[i] = std::min(left, above);
    }
    for (std::size_t i = owners.size(); i-- > 0;) {
        const std::size_t x = i % width;
        const std::uint32_t right = x + 1 < width ? through(i + 1, i, kAcross) : kAcross;
        const std::uint32_t below = i / width + 1 < height ? through(i + width, i, kUpOrDown) : kUpOrDown;
        depths[i] = std::min({depths[i], right, below});
    }
    return depths;
}

}  // namespace

std::vector<VisiblePart> visible_parts(std::span<const std::uint32_t> owners, std::size_t width,
                                       std::uint32_t count) {
    const std::vector<std::uint32_t> depths = depths_inside(owners, width);
    std::vector<VisiblePart> parts(count);
    std::vector<std::uint32_t> deepest(count, 0);
    for (std::size_t i = 0; i < owners.size(); ++i) {
        const std::uint32_t owner = owners[i];
        if (owner >= count) {
            continue;
        }
        parts[owner].owner = owner;
        ++parts[owner].pixels;
        if (depths[i] > deepest[owner]) {
            deepest[owner] = depths[i];
            const std::size_t row = i / width;
            parts[owner].deepest = {static_cast<double>(i % width), static_cast<double>(row)};
        }
    }
    std::erase_if(parts, [](const VisiblePart& part) { return part.pixels == 0; });
    return parts;
}

}  // namespace campuswalk::engine::render

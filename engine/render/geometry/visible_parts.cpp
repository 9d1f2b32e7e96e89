#include "engine/render/geometry/visible_parts.h"

#include <algorithm>

namespace campuswalk::engine::render {
namespace {

constexpr std::uint32_t kHorizontalStep = 1;
constexpr std::uint32_t kVerticalStep = 4;

/// For each pixel its distance to the nearest one of another owner: a distance transform in two sweeps
/// (Rosenfeld and Pfaltz, "Sequential Operations in Digital Image Processing", 1966).
std::vector<std::uint32_t> distances_to_border(std::span<const std::uint32_t> owners, std::size_t width) {
    const std::size_t height = owners.size() / width;
    std::vector<std::uint32_t> distances(owners.size());
    const auto via = [&](std::size_t from, std::size_t to, std::uint32_t step) {
        return owners[from] == owners[to] ? distances[from] + step : step;
    };
    for (std::size_t i = 0; i < owners.size(); ++i) {
        const std::size_t x = i % width;
        const std::uint32_t left = x > 0 ? via(i - 1, i, kHorizontalStep) : kHorizontalStep;
        const std::uint32_t above = i >= width ? via(i - width, i, kVerticalStep) : kVerticalStep;
        distances[i] = std::min(left, above);
    }
    for (std::size_t i = owners.size(); i-- > 0;) {
        const std::size_t x = i % width;
        const std::uint32_t right = x + 1 < width ? via(i + 1, i, kHorizontalStep) : kHorizontalStep;
        const std::uint32_t below = i / width + 1 < height ? via(i + width, i, kVerticalStep) : kVerticalStep;
        distances[i] = std::min({distances[i], right, below});
    }
    return distances;
}

}  // namespace

std::vector<VisiblePart> visible_parts(std::span<const std::uint32_t> owners, std::size_t width,
                                       std::uint32_t count) {
    const std::vector<std::uint32_t> distances = distances_to_border(owners, width);
    std::vector<VisiblePart> parts(count);
    std::vector<std::uint32_t> deepest(count, 0);
    for (std::size_t i = 0; i < owners.size(); ++i) {
        const std::uint32_t owner = owners[i];
        if (owner >= count) {
            continue;
        }
        parts[owner].owner = owner;
        ++parts[owner].pixels;
        if (distances[i] > deepest[owner]) {
            deepest[owner] = distances[i];
            const std::size_t row = i / width;
            parts[owner].deepest = {static_cast<double>(i % width), static_cast<double>(row)};
        }
    }
    std::erase_if(parts, [](const VisiblePart& part) { return part.pixels == 0; });
    return parts;
}

}  // namespace campuswalk::engine::render

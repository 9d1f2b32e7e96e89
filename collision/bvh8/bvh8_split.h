#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "collision/base/simd_target.h"
#include "collision/bvh8/lane_bounds.h"

namespace campuswalk::collision {

/// A triangle on its way into a wide tree. Half a cache line, for splitting does little but move these.
struct alignas(32) SplitItem {
    /// The least coordinates, the bits of the triangle's number, the greatest coordinates with their signs
    /// turned, -1. So the bounds of two are the lesser of each, and upper less lower half is no denormal,
    /// which some processors are slow at.
    std::array<float, 8> ends{};

    SplitItem() = default;
    SplitItem(const LaneBounds& bounds, std::uint32_t triangle) {
        Eigen::Map<Lanes, Eigen::Aligned16>(ends.data()) = bounds.min;
        Eigen::Map<Lanes, Eigen::Aligned16>(ends.data() + 4) = -bounds.max;
        ends[3] = std::bit_cast<float>(triangle);
        ends[7] = -1.0F;
    }

    std::uint32_t triangle() const { return std::bit_cast<std::uint32_t>(ends[3]); }
    /// Twice the centre of the bounds: only compared.
    float center(std::size_t axis) const { return ends[axis] - ends[axis + 4]; }
};

/// Moves some of at least two items to the front, the left ones, and returns how many: at least one, and not
/// all. By the surface-area heuristic (kernels/area_split.h), unless that leaves too little on one side: then
/// half of them go. Triangles ascend on both sides if they did before. `spare` is room for as many items;
/// what is in it is lost. The same for all instructions.
std::size_t split(std::span<SplitItem> items, std::span<SplitItem> spare, SimdTarget simd_target);

}  // namespace campuswalk::collision

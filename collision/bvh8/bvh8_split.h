#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "collision/base/simd_target.h"
#include "collision/bvh8/lane_bounds.h"

namespace campuswalk::collision {

/// A triangle to be put into a BVH8. Half a cache line, because splitting mainly moves these.
struct alignas(32) SplitItem {
    /// The least coordinates, the bits of the triangle's index, the greatest coordinates negated, -1. So the
    /// bounds of two items are the minimum of each, and the difference of the halves isn't denormal, which
    /// some processors are slow at.
    std::array<float, 8> ends{};

    SplitItem() = default;
    SplitItem(const LaneBounds& bounds, std::uint32_t triangle) {
        Eigen::Map<Lanes, Eigen::Aligned16>(ends.data()) = bounds.min;
        Eigen::Map<Lanes, Eigen::Aligned16>(ends.data() + 4) = -bounds.max;
        ends[3] = std::bit_cast<float>(triangle);
        ends[7] = -1.0F;
    }

    std::uint32_t triangle() const { return std::bit_cast<std::uint32_t>(ends[3]); }
    /// Twice the centre of the bounds, only for comparison.
    float center(std::size_t axis) const { return ends[axis] - ends[axis + 4]; }
};

/// Divides two or more items: moves those of the left side to the front and returns how many they are, at
/// least one and not all. By the surface-area heuristic (kernels/area_split.h), unless that leaves too few on
/// one side: then by halves. Triangles ascend on both sides if they did before. `spare` has room for as many
/// items, and is overwritten. The result is the same for every `simd_target`.
std::size_t split(std::span<SplitItem> items, std::span<SplitItem> spare, SimdTarget simd_target);

}  // namespace campuswalk::collision

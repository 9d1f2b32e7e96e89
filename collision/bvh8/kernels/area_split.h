#pragma once

#include <span>

#include "collision/base/simd_target.h"
#include "collision/bvh8/bvh8_split.h"

namespace campuswalk::collision {

/// Moves the items of the left side to the front, preserving the order on both sides, and returns how many
/// they are; 0, with nothing moved, if a side would have fewer than `least`, or if all centres coincide. Uses
/// the surface-area heuristic (Goldsmith, Salmon 1987; MacDonald, Booth 1990) over sixteen bins of the
/// bounds' centres on each axis (Wald 2007), where a side costs its area times the number of leaves it will
/// need. `spare` has room for as many items.
///
/// The split is the same for every `simd_target`.
std::size_t split_by_area(std::span<SplitItem> items, std::span<SplitItem> spare, std::size_t least,
                          SimdTarget simd_target);

}  // namespace campuswalk::collision

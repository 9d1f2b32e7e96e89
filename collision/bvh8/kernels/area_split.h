#pragma once

#include <span>

#include "collision/base/simd_target.h"
#include "collision/bvh8/bvh8_split.h"

namespace campuswalk::collision {

/// Moves the items that go to the left to the front, keeps the order on both sides, and returns how many
/// there are; 0, and nothing moved, if fewer than `least` would be on a side, or all centres are at one
/// place. By the surface-area heuristic over sixteen bins of the bounds' centres on each axis (Wald 2007),
/// where a side costs its area times the leaves it will take. `spare` is room for as many items.
///
/// No operation here depends on the instructions: the same items go to the left with all of them.
std::size_t split_by_area(std::span<SplitItem> items, std::span<SplitItem> spare, std::size_t least,
                          SimdTarget simd_target);

}  // namespace campuswalk::collision

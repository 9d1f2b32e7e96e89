#include "collision/bvh8/bvh8_split.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "collision/bvh8/kernels/area_split.h"

namespace campuswalk::collision {

namespace {

/// A split must leave at least one item in so many on each side, so that the depth stays logarithmic.
constexpr std::size_t kMinSideDivisor = 16;

std::size_t longest_axis(std::span<const SplitItem> items) {
    std::size_t longest = 0;
    float most = -1.0F;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto [least, greatest] = std::minmax_element(
            items.begin(), items.end(),
            [&](const SplitItem& s, const SplitItem& t) { return s.center(axis) < t.center(axis); });
        const float length = greatest->center(axis) - least->center(axis);
        if (length > most) {
            most = length;
            longest = axis;
        }
    }
    return longest;
}

/// Puts half of the items on each side, along the axis where their centres differ most.
std::size_t halve(std::span<SplitItem> items, std::span<SplitItem> spare) {
    const std::size_t axis = longest_axis(items);
    using Key = std::pair<float, std::uint32_t>;
    const auto key = [&](const SplitItem& item) { return Key(item.center(axis), item.triangle()); };
    std::vector<Key> keys(items.size());
    std::transform(items.begin(), items.end(), keys.begin(), key);
    const std::size_t half = items.size() / 2;
    std::nth_element(keys.begin(), keys.begin() + static_cast<std::ptrdiff_t>(half), keys.end());
    const Key first_of_right = keys[half];

    std::size_t left = 0;
    std::size_t right = 0;
    for (const SplitItem& item : items) {
        (key(item) < first_of_right ? items[left++] : spare[right++]) = item;
    }
    std::copy_n(spare.begin(), right, items.begin() + static_cast<std::ptrdiff_t>(left));
    return half;
}

}  // namespace

std::size_t split(std::span<SplitItem> items, std::span<SplitItem> spare, SimdTarget simd_target) {
    const std::size_t least = std::max<std::size_t>(1, items.size() / kMinSideDivisor);
    const std::size_t left = split_by_area(items, spare, least, simd_target);
    return left > 0 ? left : halve(items, spare);
}

}  // namespace campuswalk::collision

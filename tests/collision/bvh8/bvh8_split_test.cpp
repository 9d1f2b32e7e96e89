#include "collision/bvh8/bvh8_split.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "collision/geometry/shapes.h"
#include "tests/support/dice.h"

namespace campuswalk::collision {
namespace {

using support::Dice;

SplitItem item(std::uint32_t triangle, const Vec3& center, const Vec3& size) {
    const Eigen::Array3f c = center.cast<float>().array();
    const Eigen::Array3f s = size.cast<float>().array();
    LaneBounds bounds;
    bounds.min << c - s, 0.0F;
    bounds.max << c + s, 0.0F;
    return {bounds, triangle};
}

/// Some small and some large, all over a cube.
std::vector<SplitItem> crowd(Dice& dice, int count) {
    std::vector<SplitItem> items;
    for (int i = 0; i < count; ++i) {
        const Vec3 size(dice.between(0.0, 0.5), dice.between(0.0, 0.1), dice.between(0.0, 2.0));
        items.push_back(item(static_cast<std::uint32_t>(i), dice.in_cube(10.0), size));
    }
    return items;
}

std::size_t split(std::vector<SplitItem>& items, SimdTarget simd_target) {
    std::vector<SplitItem> spare(items.size());
    return split(items, spare, simd_target);
}

std::vector<std::uint32_t> triangles(const std::vector<SplitItem>& items) {
    std::vector<std::uint32_t> numbers;
    numbers.reserve(items.size());
    for (const SplitItem& one : items) {
        numbers.push_back(one.triangle());
    }
    return numbers;
}

/// All items are still there, in ascending order on each side, and neither side is empty.
void expect_split(const std::vector<SplitItem>& items, std::size_t left) {
    ASSERT_GE(left, 1U);
    ASSERT_LT(left, items.size());
    std::vector<std::uint32_t> all = triangles(items);
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(left);
    EXPECT_TRUE(std::is_sorted(all.begin(), middle));
    EXPECT_TRUE(std::is_sorted(middle, all.end()));
    std::sort(all.begin(), all.end());
    for (std::uint32_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(all[i], i);
    }
}

TEST(Bvh8Split, IsTheSameForAllSimdTargets) {
    Dice dice(450);
    for (int i = 0; i < 300; ++i) {
        SCOPED_TRACE(i);
        const std::vector<SplitItem> items = crowd(dice, 2 + dice.below(i < 250 ? 60 : 3000));
        std::vector<SplitItem> expected = items;
        const std::size_t left = split(expected, SimdTarget::sse42);
        expect_split(expected, left);
        for (const SimdTarget simd_target : {SimdTarget::avx2, SimdTarget::avx512}) {
            if (!can_run(simd_target)) {
                continue;
            }
            std::vector<SplitItem> actual = items;
            EXPECT_EQ(split(actual, simd_target), left);
            EXPECT_EQ(triangles(actual), triangles(expected));
        }
    }
}

TEST(Bvh8Split, SeparatesTwoClusters) {
    std::vector<SplitItem> items;
    for (std::uint32_t i = 0; i < 40; ++i) {
        items.push_back(item(i, Vec3(0.1 * i, i % 3 == 0 ? 5.0 : -5.0, 0.0), Vec3(0.1, 0.1, 0.1)));
    }
    const std::size_t left = split(items, default_simd_target());
    EXPECT_EQ(left, 26U);
    expect_split(items, left);
    EXPECT_LT(items[left - 1].center(1), 0.0F);
    EXPECT_GT(items[left].center(1), 0.0F);
}

TEST(Bvh8Split, HalvesCoincidentTriangles) {
    std::vector<SplitItem> items;
    for (std::uint32_t i = 0; i < 101; ++i) {
        items.push_back(item(i, Vec3(1, 2, 3), Vec3(1, 1, 1)));
    }
    EXPECT_EQ(split(items, default_simd_target()), 50U);
    expect_split(items, 50);
}

TEST(Bvh8Split, HalvesIfOnlyAFewLieFarAway) {
    std::vector<SplitItem> items;
    for (std::uint32_t i = 0; i < 100; ++i) {
        const double x = i == 40 ? 1e6 : 0.01 * (i * 37 % 100);
        items.push_back(item(i, Vec3(x, 0.0, 0.0), Vec3(0.1, 0.1, 0.1)));
    }
    const std::size_t left = split(items, default_simd_target());
    EXPECT_EQ(left, 50U) << "one in a hundred is less than a sixteenth";
    expect_split(items, left);
    float most = items[0].center(0);
    float least = items[left].center(0);
    for (std::size_t i = 0; i < items.size(); ++i) {
        float& edge = i < left ? most : least;
        edge = i < left ? std::max(edge, items[i].center(0)) : std::min(edge, items[i].center(0));
    }
    EXPECT_LE(most, least);
}

}  // namespace
}  // namespace campuswalk::collision

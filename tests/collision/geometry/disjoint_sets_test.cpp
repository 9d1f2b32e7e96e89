#include "collision/geometry/disjoint_sets.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/dice.h"

namespace campuswalk::collision {
namespace {

/// Against a list of sets that are renamed one by one.
TEST(DisjointSets, AreKnownByTheirLowestNumber) {
    constexpr int kCount = 200;
    support::Dice dice(5);
    DisjointSets sets(kCount);
    std::vector<std::uint32_t> lowest(kCount);
    for (std::uint32_t i = 0; i < kCount; ++i) {
        lowest[i] = i;
    }
    for (int joins = 0; joins < 150; ++joins) {
        const auto a = static_cast<std::size_t>(dice.below(kCount));
        const auto b = static_cast<std::size_t>(dice.below(kCount));
        sets.join(a, b);
        const auto [low, high] = std::minmax({lowest[a], lowest[b]});
        std::ranges::replace(lowest, high, low);
        ASSERT_EQ(sets.root(b), low);
    }
    EXPECT_EQ(std::move(sets).roots(), lowest);
}

}  // namespace
}  // namespace campuswalk::collision

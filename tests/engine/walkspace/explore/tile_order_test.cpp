#include "engine/walkspace/explore/tile_order.h"

#include <algorithm>
#include <cstdlib>
#include <set>

#include <gtest/gtest.h>

#include "tests/support/dice.h"

namespace campuswalk::engine {
namespace {

/// About half of the tiles of a square around the origin, in any order.
WalkSpace scattered_tiles(std::uint32_t seed) {
    constexpr int kSide = 15;
    support::Dice dice(seed);
    const auto coordinate = [&] { return (dice.below(kSide) - kSide / 2) * WalkTile::kCells; };
    WalkSpace space(WalkGrid{0.25});
    while (space.tiles.size() < kSide * kSide / 2) {
        const int x = coordinate();
        space.add_tile_at({x, coordinate()});
    }
    return space;
}

bool are_side_by_side(const WalkTile& a, const WalkTile& b) {
    const int x = std::abs(a.first_cell.x - b.first_cell.x);
    const int z = std::abs(a.first_cell.z - b.first_cell.z);
    return std::max(x, z) == WalkTile::kCells;
}

TEST(TileOrder, PutsOneOfTwoSideBySideAfterTheOther) {
    const WalkSpace space = scattered_tiles(22);
    const TileOrder order =
        order_around({3, 9, 40, 41, 60}, space, [](std::uint32_t tile) { return tile * 37 % 11; });
    ASSERT_EQ(order.after.size(), order.tiles.size());
    for (std::size_t i = 0; i < order.tiles.size(); ++i) {
        const std::set<std::size_t> after(order.after[i].begin(), order.after[i].end());
        EXPECT_EQ(after.size(), order.after[i].size());
        for (std::size_t earlier = 0; earlier < order.tiles.size(); ++earlier) {
            const bool beside =
                are_side_by_side(space.tiles[order.tiles[i]], space.tiles[order.tiles[earlier]]);
            EXPECT_EQ(after.contains(earlier), beside && earlier < i) << i << " " << earlier;
        }
    }
}

TEST(TileOrder, HasTheTilesAndThoseBesideThemOnce) {
    const WalkSpace space = scattered_tiles(7);
    const std::vector<std::uint32_t> active{0, 5, 17, 90};
    std::set<std::uint32_t> expected;
    for (std::uint32_t tile = 0; tile < space.tiles.size(); ++tile) {
        for (const std::uint32_t one : active) {
            if (tile == one || are_side_by_side(space.tiles[tile], space.tiles[one])) {
                expected.insert(tile);
            }
        }
    }
    const auto rank_of = [](std::uint32_t tile) {
        return tile == 17 ? 0U : tile == 5 || tile == 90 ? 20U : tile == 0 ? 30U : 1000U;
    };
    const TileOrder order = order_around(active, space, rank_of);
    EXPECT_EQ(std::set<std::uint32_t>(order.tiles.begin(), order.tiles.end()), expected);
    EXPECT_EQ(order.tiles.size(), expected.size());
    EXPECT_GT(expected.size(), active.size());
    const std::vector<std::uint32_t> first(order.tiles.begin(), order.tiles.begin() + 4);
    EXPECT_EQ(first, (std::vector<std::uint32_t>{17, 5, 90, 0})) << "the lowest ranks first";
}

TEST(TileOrder, IsEmptyWithoutTiles) {
    const WalkSpace space(WalkGrid{0.25});
    EXPECT_TRUE(order_around({}, space, [](std::uint32_t) { return 0U; }).tiles.empty());
}

}  // namespace
}  // namespace campuswalk::engine

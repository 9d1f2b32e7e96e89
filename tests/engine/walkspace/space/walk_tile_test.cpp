#include "engine/walkspace/space/walk_tile.h"

#include <gtest/gtest.h>

#include "engine/walkspace/space/walk_space.h"

namespace campuswalk::engine {
namespace {

WalkNode node_at(std::uint32_t cell, float y) {
    WalkNode node;
    node.cell = cell & 255U;
    node.y = y;
    return node;
}

TEST(WalkTile, FindsTheNearestNodeOfACell) {
    WalkTile tile({0, 0}, 0);
    const std::uint16_t floor = tile.add(node_at(5, 0.0F));
    const std::uint16_t sill = tile.add(node_at(5, 0.25F));
    const std::uint16_t gallery = tile.add(node_at(5, 3.0F));
    tile.add(node_at(6, 1.0F));
    EXPECT_EQ(tile.find(5, 0.1), floor);
    EXPECT_EQ(tile.find(5, 0.14), sill) << "the nearer of two in reach";
    EXPECT_EQ(tile.find(5, 3.14), gallery);
    EXPECT_EQ(tile.find(5, 3.16), std::nullopt);
    EXPECT_EQ(tile.find(5, 1.0), std::nullopt) << "another cell's";
    EXPECT_EQ(tile.find(5, 1.0, 0.8), sill);
    EXPECT_EQ(tile.find(7, 0.0), std::nullopt);
}

TEST(WalkTile, TellsBodiesThatHangOverAnEdgeApart) {
    WalkTile tile({0, 0}, 0);
    tile.add(node_at(5, 0.0F));
    EXPECT_TRUE(tile.has(5, 0.14, false));
    EXPECT_FALSE(tile.has(5, 0.16, false));
    EXPECT_FALSE(tile.has(5, 0.03, true));
    EXPECT_TRUE(tile.has(5, 0.01, true));
    EXPECT_FALSE(tile.has(6, 0.0, false)) << "another cell";
    WalkNode hanging = node_at(7, 1.0F);
    hanging.hangs = 1;
    tile.add(hanging);
    EXPECT_TRUE(tile.has(7, 1.01, false));
    EXPECT_FALSE(tile.has(7, 1.03, false)) << "who stands there is somewhere else";
}

TEST(WalkTile, NumbersItsCells) {
    const WalkTile tile({-16, 32}, 0);
    for (const GridCell cell : {GridCell{-16, 32}, GridCell{-1, 32}, GridCell{-16, 47}, GridCell{-1, 47}}) {
        EXPECT_EQ(tile.cell_of(node_at(tile.index_of(cell), 0.0F)), cell);
        EXPECT_LT(tile.index_of(cell), 256U);
    }
    EXPECT_NE(tile.index_of({-1, 32}), tile.index_of({-16, 33}));
}

TEST(WalkTile, KeepsSomeStates) {
    WalkTile tile({0, 0}, 0);
    tile.keyframes.push_back({2, {{1, 2, 3}, 2.5}});
    tile.keyframes.push_back({9, {{4, 5, 6}, 5.5}});
    EXPECT_EQ(tile.keyframe(3), nullptr);
    ASSERT_NE(tile.keyframe(9), nullptr);
    EXPECT_EQ(*tile.keyframe(9), (GroundState{{4, 5, 6}, 5.5}));
    EXPECT_EQ(tile.keyframe(10), nullptr);
}

TEST(WalkSpace, FindsTilesOnBothSidesOfTheOrigin) {
    WalkSpace space(WalkGrid{0.25});
    const std::uint32_t east = space.add_tile_at({0, 0});
    const std::uint32_t west = space.add_tile_at({-1, 0});
    const std::uint32_t far = space.add_tile_at({-17, -38});
    EXPECT_EQ(space.tiles[west].first_cell, (GridCell{-16, 0}));
    EXPECT_EQ(space.tiles[far].first_cell, (GridCell{-32, -48}));
    EXPECT_EQ(space.add_tile_at({15, 15}), east) << "a tile is added once";
    EXPECT_EQ(space.tile_at({-16, 15}), west);
    EXPECT_EQ(space.tile_at({16, 0}), std::nullopt);
    EXPECT_EQ(space.tile_at({0, -1}), std::nullopt);
}

TEST(WalkSpace, KnowsTheTilesAround) {
    WalkSpace space(WalkGrid{0.25});
    const std::uint32_t middle = space.add_tile_at({0, 0});
    EXPECT_EQ(space.tiles[middle].neighbours[4], middle);
    for (int i = 0; i < 9; ++i) {
        const GridCell beside{16 * (i % 3 - 1), 16 * (i / 3 - 1)};
        const std::uint32_t tile = space.add_tile_at(beside);
        EXPECT_EQ(space.tiles[middle].neighbours[static_cast<std::size_t>(i)], tile);
        EXPECT_EQ(space.tiles[tile].neighbours[static_cast<std::size_t>(8 - i)], middle);
    }
    const std::uint32_t apart = space.add_tile_at({64, 0});
    for (const std::uint32_t beside : space.tiles[middle].neighbours) {
        EXPECT_NE(beside, apart);
    }
}

}  // namespace
}  // namespace campuswalk::engine

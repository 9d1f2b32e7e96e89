// The result is the same for any number of workers.

#include <memory>
#include <stdexcept>
#include <tuple>

#include <gtest/gtest.h>

#include "tests/engine/small_campus.h"
#include "tests/engine/walkspace/explore/explored_ground.h"
#include "tests/support/dice.h"
#include "tests/support/mesh_pieces.h"
#include "tests/support/random_scene.h"
#include "tests/support/village.h"

namespace campuswalk::engine {
namespace {

using collision::Vec3;

auto fields_of(const WalkNode& n) {
    return std::tuple(n.y, n.next, n.parent, +n.cell, +n.direction, +n.gait, +n.steering, +n.parent_tile,
                      +n.returns, +n.steers_after, +n.hangs);
}

void expect_same(const WalkTile& a, const WalkTile& b) {
    EXPECT_EQ(a.first_cell, b.first_cell);
    EXPECT_EQ(a.newest, b.newest);
    EXPECT_EQ(a.neighbours, b.neighbours);
    ASSERT_EQ(a.nodes.size(), b.nodes.size());
    for (std::size_t i = 0; i < a.nodes.size(); ++i) {
        EXPECT_EQ(fields_of(a.nodes[i]), fields_of(b.nodes[i]));
    }
    ASSERT_EQ(a.keyframes.size(), b.keyframes.size());
    for (std::size_t i = 0; i < a.keyframes.size(); ++i) {
        EXPECT_EQ(a.keyframes[i].node, b.keyframes[i].node);
        EXPECT_EQ(a.keyframes[i].at, b.keyframes[i].at);
    }
    ASSERT_EQ(a.far_parents.size(), b.far_parents.size());
    for (std::size_t i = 0; i < a.far_parents.size(); ++i) {
        EXPECT_EQ(a.far_parents[i].node, b.far_parents[i].node);
        EXPECT_EQ(a.far_parents[i].tile, b.far_parents[i].tile);
    }
    ASSERT_EQ(a.drops.size(), b.drops.size());
    for (std::size_t i = 0; i < a.drops.size(); ++i) {
        EXPECT_EQ(a.drops[i].node, b.drops[i].node);
        EXPECT_EQ(a.drops[i].stride, b.drops[i].stride);
        EXPECT_EQ(a.drops[i].edge, b.drops[i].edge);
    }
}

void expect_same(const WalkSpace& a, const WalkSpace& b) {
    ASSERT_EQ(a.tiles.size(), b.tiles.size());
    for (std::size_t i = 0; i < a.tiles.size() && !testing::Test::HasFailure(); ++i) {
        expect_same(a.tiles[i], b.tiles[i]);
    }
    EXPECT_EQ(a.starts, b.starts);
    EXPECT_EQ(a.start_of, b.start_of);
    EXPECT_EQ(a.touched, b.touched);
    EXPECT_EQ(a.bounds, b.bounds);
    EXPECT_EQ(a.ticks, b.ticks);
    EXPECT_EQ(a.strides, b.strides);
}

void expect_same_for_all_workers(const collision::World& world, const ExploreSettings& settings) {
    const WalkSpace alone = explored(world, settings);
    EXPECT_GT(alone.tiles.size(), 4U) << "else there is nothing to share";
    for (const std::size_t workers : {2U, 3U}) {
        expect_same(alone, explored(world, settings, workers));
    }
}

TEST(ExploreByWorkers, ReachesTheSameOnVariedGround) {
    const scene::Campus campus = varied_ground();
    ExploreSettings settings = explore_from(kOnVariedGround);
    expect_same_for_all_workers(campus.world, settings);
    settings.run = true;
    settings.jump = true;
    settings.starts.push_back({8, 1.2, 5});
    expect_same_for_all_workers(campus.world, settings);
}

TEST(ExploreByWorkers, ReachesTheSameInAVillage) {
    const auto world = support::make_village();
    expect_same_for_all_workers(*world, explore_from({0, 1, 0}));
}

TEST(ExploreByWorkers, ReachesTheSameInRandomVillages) {
    for (const std::uint32_t seed : {1U, 2U, 3U}) {
        support::Dice dice(seed);
        const auto world = support::make_random_village(dice);
        ExploreSettings settings =
            explore_from(support::random_free_place(*world, dice, support::kRandomVillageHalf));
        settings.starts.push_back(support::random_free_place(*world, dice, support::kRandomVillageHalf));
        expect_same_for_all_workers(*world, settings);
    }
}

/// Edges over which falls go far, into other tiles.
TEST(ExploreByWorkers, ReachesTheSameBelowTowers) {
    collision::TriangleMesh mesh;
    support::add_floor(mesh, 12.0);
    for (int i = 0; i < 4; ++i) {
        const double x = -8.0 + 4.0 * i;
        support::add_box(mesh, {x, 0, -8}, {x + 2, 6.0 + i, 8});
    }
    const scene::Campus campus = campus_of(std::move(mesh));
    ExploreSettings settings = explore_from({-7, 6, 0});
    settings.starts.push_back({5, 9, 0});
    settings.run = true;
    expect_same_for_all_workers(campus.world, settings);
}

TEST(ExploreByWorkers, GoesTowardsAPointByOneOnly) {
    const scene::Campus campus = varied_ground();
    const ExploreSettings settings = explore_from(kOnVariedGround);
    const TowardsPoint goal{Vec3(0, 0, 0), [](const GroundState& at) { return at.foot.z() < 1.0; }};
    const auto make_broad_phase = [] { return std::make_unique<collision::LinearBroadPhase>(); };
    EXPECT_TRUE(explore(WorkerWorlds(campus.world, 1, make_broad_phase), settings, goal).goal);
    EXPECT_THROW(explore(WorkerWorlds(campus.world, 2, make_broad_phase), settings, goal),
                 std::invalid_argument);
}

}  // namespace
}  // namespace campuswalk::engine

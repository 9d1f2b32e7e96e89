#include "tools/campuswalk_bench/explore/adversary.h"

#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/effort.h"
#include "tests/support/mesh_pieces.h"
#include "tests/support/village.h"
#include "tools/campuswalk_bench/procedural/walkable_campus.h"

namespace campuswalk::tools::bench {
namespace {

using collision::Vec3;

engine::ExploreSettings explored_from(const Vec3& start) {
    engine::ExploreSettings settings;
    settings.starts = {start};
    return settings;
}

engine::WorkerWorlds worlds_of(const collision::World& world, std::size_t workers = 2) {
    return {world, workers, [] { return std::make_unique<collision::LinearBroadPhase>(); }};
}

/// Walks on what is explored from there that got outside of it.
std::vector<Escape> escapes_of(const collision::World& world, const Vec3& start, bool steers_in_falls) {
    const engine::ExploreSettings explored = explored_from(start);
    const engine::WalkSpace space = explore(worlds_of(world), explored);
    AdversarySettings settings;
    settings.walks = static_cast<std::size_t>(support::repeats(200));
    settings.steers_in_falls = steers_in_falls;
    const AdversaryResult result = attack(space, worlds_of(world), explored, settings);
    EXPECT_EQ(result.walks, settings.walks);
    EXPECT_GT(result.ticks, 1000U * settings.walks);
    return result.escapes;
}

void expect_none(const std::vector<Escape>& escapes) {
    for (const Escape& escape : escapes) {
        ADD_FAILURE() << "seed " << escape.seed << " from " << escape.start.transpose() << " is outside at "
                      << escape.at.transpose() << " in tick " << escape.tick;
    }
}

TEST(Adversary, StaysInsideInAVillage) {
    const auto world = support::make_village();
    expect_none(escapes_of(*world, {0, 1, 0}, false));
    expect_none(escapes_of(*world, {0, 1, 0}, true));
}

TEST(Adversary, StaysInsideOnACourse) {
    WalkableCampus campus = walkable_campus(1);
    collision::World world(std::make_unique<collision::LinearBroadPhase>());
    support::add_object(world, std::move(campus.mesh));
    expect_none(escapes_of(world, campus.paths.front().start, false));
}

/// A floor of 20 m by 20 m, cut in two by a gate.
struct GatedFloor {
    GatedFloor() : world(std::make_unique<collision::LinearBroadPhase>()) {
        collision::TriangleMesh mesh;
        support::add_floor(mesh, 10.0);
        support::add_object(world, std::move(mesh));
        support::add_object(world, collision::Box{{0.1, 2, 12}}, {3, 0, 0});
    }
    collision::World world;
};

TEST(Adversary, FindsGroundThatWasLeftOut) {
    const GatedFloor floor;
    engine::ExploreSettings explored = explored_from({0, 0, 0});
    const engine::WalkSpace space = explore(worlds_of(floor.world), explored);
    const std::vector<bool> open{false, true};
    explored.solids.disabled = &open;
    AdversarySettings settings;
    settings.walks = 40;
    const AdversaryResult result = attack(space, worlds_of(floor.world), explored, settings);
    ASSERT_FALSE(result.escapes.empty());
    for (const Escape& escape : result.escapes) {
        EXPECT_GT(escape.at.x(), 2.7);
        EXPECT_LT(escape.at.x(), 3.3) << "the first position outside";
        EXPECT_GT(escape.ticks_outside, 0U);
        EXPECT_GT(escape.apart, 0.25);
    }
    EXPECT_GE(result.escapes.front().apart, result.escapes.back().apart) << "the farthest first";
}

TEST(Adversary, WalksTheSameOnAnyNumberOfThreads) {
    const GatedFloor floor;
    engine::ExploreSettings explored = explored_from({0, 0, 0});
    const engine::WalkSpace space = explore(worlds_of(floor.world), explored);
    const std::vector<bool> open{false, true};
    explored.solids.disabled = &open;
    AdversarySettings settings;
    settings.walks = 20;
    const AdversaryResult together = attack(space, worlds_of(floor.world), explored, settings);
    const AdversaryResult alone = attack(space, worlds_of(floor.world, 1), explored, settings);
    EXPECT_EQ(alone.ticks, together.ticks);
    ASSERT_EQ(alone.escapes.size(), together.escapes.size());
    for (std::size_t i = 0; i < alone.escapes.size(); ++i) {
        EXPECT_EQ(alone.escapes[i].seed, together.escapes[i].seed);
        EXPECT_EQ(alone.escapes[i].at, together.escapes[i].at);
    }
}

}  // namespace
}  // namespace campuswalk::tools::bench

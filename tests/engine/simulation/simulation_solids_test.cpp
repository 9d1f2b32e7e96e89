#include <cmath>

#include <gtest/gtest.h>

#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"

// Collisions with solids. The avatar keeps 0.02 m away from walls; a contact begins one millimetre beyond
// that and ends five millimetres beyond.

namespace campuswalk::engine {
namespace {

using Eigen::Vector3d;

constexpr double kSkin = 0.02;
constexpr double kWalkerRadius = 0.3;
constexpr double kWalkerTick = 1.4 / 60.0;

TEST(Solids, AreTouchedAtTheSkinsWidthAndLeftOnTheReturn) {
    const RecordedRun result = run(
        walled_campus(), walk_of({spawn_at({0, 0, 0}), walk_to_or_proceed(0, -10), walk_to(0, 0, "home")}));
    EXPECT_EQ(result.recorder.event_lines(),
              std::vector<std::string>({"collision.enter wall", "avatar.stuck stroll", "collision.stay wall",
                                        "avatar.blocked goal", "collision.exit wall", "avatar.arrive home"}));
    const double distance = 3.0 - kWalkerRadius;
    const Event enter = result.recorder.events("collision.enter")[0];
    EXPECT_EQ(enter.tick, static_cast<Tick>(std::ceil((distance - kSkin - 1e-3) / kWalkerTick)));
    EXPECT_EQ(enter.at, 1.0);
    EXPECT_FALSE(has_field(enter, "at"));
    const Event blocked = result.recorder.events("avatar.blocked")[0];
    EXPECT_NEAR(field<Vector3d>(blocked, "pos").z(), -(distance - kSkin), 1e-6);
    EXPECT_EQ(field<std::string>(blocked, "by"), "wall");
    // It gives up a second and a half after its last progress.
    EXPECT_NEAR(static_cast<double>(blocked.tick), static_cast<double>(enter.tick) + 90, 3);
    const Event exit = result.recorder.events("collision.exit")[0];
    EXPECT_EQ(exit.tick, blocked.tick + 1) << "the motion of one tick exceeds five millimetres";
    EXPECT_EQ(field<std::int64_t>(exit, "ticks"), exit.tick - enter.tick);
}

TEST(Solids, AreTouchedCloserThanTheyAreLeft) {
    // 0.7 mm per tick, from 10 mm away to where contact begins, and back.
    constexpr double kCreep = 0.0007;
    const double stop = 3.0 - kWalkerRadius - kSkin;
    const RecordedRun result = run(
        walled_campus(), walk_of({spawn_at({0, 0, -stop + 0.010}), walk_to_or_proceed(0, -10, kCreep * 60),
                                  walk_to_or_proceed(0, 0, kCreep * 60)}));
    const auto enters = result.recorder.events("collision.enter");
    const auto exits = result.recorder.events("collision.exit");
    ASSERT_EQ(enters.size(), 1U);
    ASSERT_EQ(exits.size(), 1U);
    EXPECT_EQ(enters[0].tick, static_cast<Tick>(std::ceil((0.010 - 0.001) / kCreep)));
    const Tick turned = result.recorder.events("avatar.blocked")[0].tick;
    const double left = std::ceil(0.005 / kCreep);
    EXPECT_EQ(exits[0].tick - turned, static_cast<Tick>(left));
    EXPECT_NEAR(field<Vector3d>(exits[0], "pos").z(), -stop + left * kCreep, 1e-6);
}

TEST(Solids, AreOneContactAlongTheWholeWall) {
    const RecordedRun result =
        run(walled_campus(), walk_of({spawn_at({-4, 0, -2}), walk_to_or_proceed(9, -4.5)}));
    ASSERT_EQ(result.recorder.events("collision.enter wall").size(), 1U);
    ASSERT_EQ(result.recorder.events("collision.exit wall").size(), 1U);
    EXPECT_EQ(result.recorder.events("avatar.arrive").size(), 1U);
    const Event enter = result.recorder.events("collision.enter wall")[0];
    const Event exit = result.recorder.events("collision.exit wall")[0];
    for (const Recorder::TickState& state : result.recorder.states()) {
        const Vector3d foot = state.avatar.position;
        if (state.tick > enter.tick && state.tick < exit.tick && foot.x() < 5.0) {
            ASSERT_NEAR(foot.z(), -(3.0 - kWalkerRadius - kSkin), 1.1e-3) << "tick " << state.tick;
        }
    }
}

TEST(Solids, ExcludeTheGroundAndKerbs) {
    scene::Campus campus = level_campus();
    add_box(campus, "kerb", {-5, 0, -20}, {5, 0.15, -3});
    const RecordedRun result = run(campus, walk_of({spawn_at({0, 0, 0}), walk_to(0, -6)}));
    EXPECT_EQ(result.recorder.event_lines(), std::vector<std::string>({"avatar.arrive goal"}));
    EXPECT_NEAR(result.recorder.states().back().avatar.position.y(), 0.15, 1e-3);
    EXPECT_TRUE(result.recorder.states().back().avatar.grounded);
}

TEST(Solids, AreWalkedThroughInIgnoredLayers) {
    scene::Campus campus = level_campus();
    add_box(campus, "wall", {-5, 0, -4}, {5, 3, -3}, {collision::Detection::solid, "", true, "buildings"});
    Walk walk = walk_of({spawn_at({0, 0, 0}), walk_to(0, -8)});
    EXPECT_FALSE(run(campus, walk).summary.passed);
    walk.avatar.ignore_layers = {"buildings"};
    const RecordedRun result = run(campus, walk);
    EXPECT_TRUE(result.summary.passed);
    EXPECT_EQ(result.recorder.event_lines(), std::vector<std::string>({"avatar.arrive goal"}));
}

TEST(Solids, AreLeftOnATeleport) {
    const RecordedRun result =
        run(walled_campus(),
            walk_of({spawn_at({0, 0, -2.68}), wait_for(0.1), teleport_to({20, 0, 0}), wait_for(0.1)}));
    EXPECT_EQ(result.recorder.event_lines(),
              std::vector<std::string>(
                  {"collision.enter wall", "collision.exit wall", "avatar.teleport elsewhere"}));
    EXPECT_EQ(field<std::string>(result.recorder.events("collision.enter")[0], "cause"), "spawn");
    const Event exit = result.recorder.events("collision.exit")[0];
    EXPECT_EQ(field<std::string>(exit, "cause"), "teleport");
    EXPECT_NEAR(field<Vector3d>(exit, "pos").z(), -2.68, 1e-12);
}

}  // namespace
}  // namespace campuswalk::engine

#include <cmath>

#include <gtest/gtest.h>

#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"

// What the avatar bumps into. It keeps 0.02 m to walls; contact begins a millimetre beyond and ends five
// millimetres beyond.

namespace campuswalk::engine {
namespace {

using Eigen::Vector3d;

constexpr double kSkin = 0.02;
constexpr double kRadius = 0.3;
constexpr double kTickLength = 1.4 / 60.0;

WalkToStep persistently(double x, double z, double speed = 1.4) {
    WalkToStep step = walk_to(x, z);
    step.if_blocked = IfBlocked::proceed;
    step.speed = speed;
    return step;
}

scene::Campus walled_campus() {
    scene::Campus campus = level_campus();
    add_box(campus, "wall", {-5, 0, -4}, {5, 3, -3});
    return campus;
}

TEST(Solids, AreMetASkinAwayAndLeftOnTheWayBack) {
    const Outing outing =
        run(walled_campus(), walk_of({spawn_at({0, 0, 0}), persistently(0, -10), walk_to(0, 0, "home")}));
    EXPECT_EQ(outing.recorder.story(),
              std::vector<std::string>({"collision.enter wall", "avatar.stuck stroll", "collision.stay wall",
                                        "avatar.blocked goal", "collision.exit wall", "avatar.arrive home"}));
    const double way = 3.0 - kRadius;
    const Event enter = outing.recorder.of("collision.enter")[0];
    EXPECT_EQ(enter.tick, static_cast<Tick>(std::ceil((way - kSkin - 1e-3) / kTickLength)));
    EXPECT_EQ(enter.at, 1.0);
    EXPECT_FALSE(has_field(enter, "at"));
    const Event blocked = outing.recorder.of("avatar.blocked")[0];
    EXPECT_NEAR(field<Vector3d>(blocked, "pos").z(), -(way - kSkin), 1e-6);
    EXPECT_EQ(field<std::string>(blocked, "by"), "wall");
    // It gives up a second and a half after it came nearer for the last time.
    EXPECT_NEAR(static_cast<double>(blocked.tick), static_cast<double>(enter.tick) + 90, 3);
    const Event exit = outing.recorder.of("collision.exit")[0];
    EXPECT_EQ(exit.tick, blocked.tick + 1) << "a tick's walk is more than five millimetres";
    EXPECT_EQ(field<std::int64_t>(exit, "ticks"), exit.tick - enter.tick);
}

TEST(Solids, BeginCloserThanTheyEnd) {
    // 0.7 mm a tick, from 10 mm to where contact begins and back.
    constexpr double kCreep = 0.0007;
    const double stop = 3.0 - kRadius - kSkin;
    const Outing outing =
        run(walled_campus(), walk_of({spawn_at({0, 0, -stop + 0.010}), persistently(0, -10, kCreep * 60),
                                      persistently(0, 0, kCreep * 60)}));
    const auto enters = outing.recorder.of("collision.enter");
    const auto exits = outing.recorder.of("collision.exit");
    ASSERT_EQ(enters.size(), 1U);
    ASSERT_EQ(exits.size(), 1U);
    EXPECT_EQ(enters[0].tick, static_cast<Tick>(std::ceil((0.010 - 0.001) / kCreep)));
    const Tick turned = outing.recorder.of("avatar.blocked")[0].tick;
    const double left = std::ceil(0.005 / kCreep);
    EXPECT_EQ(exits[0].tick - turned, static_cast<Tick>(left));
    EXPECT_NEAR(field<Vector3d>(exits[0], "pos").z(), -stop + left * kCreep, 1e-6);
}

TEST(Solids, AreOneContactAllAlongAWall) {
    const Outing outing = run(walled_campus(), walk_of({spawn_at({-4, 0, -2}), persistently(9, -4.5)}));
    ASSERT_EQ(outing.recorder.of("collision.enter wall").size(), 1U);
    ASSERT_EQ(outing.recorder.of("collision.exit wall").size(), 1U);
    EXPECT_EQ(outing.recorder.of("avatar.arrive").size(), 1U);
    const Event enter = outing.recorder.of("collision.enter wall")[0];
    const Event exit = outing.recorder.of("collision.exit wall")[0];
    for (const Recorder::Frame& frame : outing.recorder.frames()) {
        const Vector3d foot = frame.avatar.position;
        if (frame.tick > enter.tick && frame.tick < exit.tick && foot.x() < 5.0) {
            ASSERT_NEAR(foot.z(), -(3.0 - kRadius - kSkin), 1.1e-3) << "tick " << frame.tick;
        }
    }
}

TEST(Solids, AreNotTheGroundNorAKerb) {
    scene::Campus campus = level_campus();
    add_box(campus, "kerb", {-5, 0, -20}, {5, 0.15, -3});
    const Outing outing = run(campus, walk_of({spawn_at({0, 0, 0}), walk_to(0, -6)}));
    EXPECT_EQ(outing.recorder.story(), std::vector<std::string>({"avatar.arrive goal"}));
    EXPECT_NEAR(outing.recorder.frames().back().avatar.position.y(), 0.15, 1e-3);
    EXPECT_TRUE(outing.recorder.frames().back().avatar.grounded);
}

TEST(Solids, OfIgnoredLayersAreWalkedThrough) {
    scene::Campus campus = level_campus();
    add_box(campus, "wall", {-5, 0, -4}, {5, 3, -3}, {collision::Detection::solid, "", true, "buildings"});
    Walk walk = walk_of({spawn_at({0, 0, 0}), walk_to(0, -8)});
    EXPECT_FALSE(run(campus, walk).summary.passed);
    walk.avatar.ignore_layers = {"buildings"};
    const Outing outing = run(campus, walk);
    EXPECT_TRUE(outing.summary.passed);
    EXPECT_EQ(outing.recorder.story(), std::vector<std::string>({"avatar.arrive goal"}));
}

TEST(Solids, EndWithATeleport) {
    const Outing outing =
        run(walled_campus(),
            walk_of({spawn_at({0, 0, -2.68}), wait_for(0.1), teleport_to({20, 0, 0}), wait_for(0.1)}));
    EXPECT_EQ(outing.recorder.story(),
              std::vector<std::string>(
                  {"collision.enter wall", "collision.exit wall", "avatar.teleport elsewhere"}));
    EXPECT_EQ(field<std::string>(outing.recorder.of("collision.enter")[0], "cause"), "spawn");
    const Event exit = outing.recorder.of("collision.exit")[0];
    EXPECT_EQ(field<std::string>(exit, "cause"), "teleport");
    EXPECT_NEAR(field<Vector3d>(exit, "pos").z(), -2.68, 1e-12);
}

}  // namespace
}  // namespace campuswalk::engine

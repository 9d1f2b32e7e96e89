#include <cmath>

#include <gtest/gtest.h>

#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"
#include "tests/support/angles.h"

// What the avatar looks at: one ray from its eyes, 1.65 m up, reaching 10 m.

namespace campuswalk::engine {
namespace {

using collision::Detection;
using Eigen::Vector3d;
using support::radians;

const ObjectTraits kSeen{Detection::ray, "", true, ""};
const ObjectTraits kSolid{Detection::solid, "", true, ""};

RecordedRun look_ahead(const scene::Campus& campus, const AvatarProfile& avatar = {}) {
    Walk walk = walk_of({spawn_at({0, 0, 0}), wait_for(0.1)});
    walk.avatar = avatar;
    return run(campus, walk);
}

/// An object that the gaze leaves is exited at once.
Walk without_gaze_hold(Walk walk) {
    walk.sim.gaze_hold = 0.0;
    return walk;
}

double distance_of(const Event& event) {
    return field<Decimal>(event, "distance").value;
}

Vector3d eye_of(const AvatarState& avatar) {
    return avatar.position + Vector3d(0, 1.65, 0);
}

TEST(Rays, MeasureTheDistanceToAFace) {
    scene::Campus campus = level_campus();
    add_box(campus, "wall", {-1, 0, -8}, {1, 3, -6}, kSeen);
    const RecordedRun result = look_ahead(campus);
    const auto enters = result.recorder.events("ray.enter wall");
    ASSERT_EQ(enters.size(), 1U);
    EXPECT_NEAR(distance_of(enters[0]), 6.0, 1e-12);
    EXPECT_EQ(enters[0].tick, 0);
    EXPECT_EQ(field<std::string>(enters[0], "cause"), "spawn");
    const auto exits = result.recorder.events("ray.exit wall");
    ASSERT_EQ(exits.size(), 1U);
    EXPECT_EQ(field<std::string>(exits[0], "cause"), "end");
    EXPECT_FALSE(has_field(exits[0], "distance"));
    EXPECT_FALSE(has_field(enters[0], "at"));
}

TEST(Rays, MeasureTheDistanceInTheDirectionOfTheGaze) {
    scene::Campus campus = level_campus();
    const Vector3d center(-3, 4, 5);
    add_object(campus, "ball", collision::Sphere{0.5}, center, kSeen);
    const RecordedRun result =
        run(campus, walk_of({spawn_at({0, 0, 0}), look_at({"ball", center, true}), wait_for(1.0)}));
    const auto stays = result.recorder.events("ray.stay ball");
    ASSERT_EQ(stays.size(), 1U);
    const Vector3d eye = eye_of(result.recorder.at(stays[0].tick));
    EXPECT_NEAR(distance_of(stays[0]), (center - eye).norm() - 0.5, 1e-9);
    EXPECT_EQ(field<std::int64_t>(stays[0], "ticks"), 60);
}

TEST(Rays, PointDownAtTheFeet) {
    scene::Campus campus = level_campus();
    add_box(campus, "carpet", {-1, 0, -3}, {1, 0.01, 1}, kSeen);
    const RecordedRun result =
        run(campus, walk_of({spawn_at({0, 0, 0}), look_at({"kerb", {0, 0.01, -1}, true}), wait_for(0.1)}));
    const AvatarState last = result.recorder.states().back().avatar;
    const Vector3d eye = eye_of(last);
    EXPECT_NEAR(last.pitch, -std::atan2(eye.y() - 0.01, 1.0), 1e-12);
    const auto enters = result.recorder.events("ray.enter carpet");
    ASSERT_EQ(enters.size(), 1U);
    // Seen from the first tick in which the ray, 3 degrees lower every tick, comes down within the carpet's 3
    // m.
    const double first = std::ceil(std::atan2(eye.y() - 0.01, 3.0) / radians(3.0));
    EXPECT_EQ(enters[0].tick, static_cast<Tick>(first));
    EXPECT_NEAR(distance_of(enters[0]), (eye.y() - 0.01) / std::sin(first * radians(3.0)), 1e-9);
}

TEST(Rays, ReachAsFarAsTheLookDistance) {
    scene::Campus campus = level_campus();
    add_box(campus, "wall", {-1, 0, -16}, {1, 3, -15}, kSeen);
    const RecordedRun result = run(campus, walk_of({spawn_at({0, 0, 0}), walk_to(0, -8)}));
    const auto enters = result.recorder.events("ray.enter wall");
    ASSERT_EQ(enters.size(), 1U);
    const double walked = std::ceil(5.0 / (1.4 / 60.0)) * 1.4 / 60.0;
    EXPECT_EQ(enters[0].tick, static_cast<Tick>(std::ceil(5.0 / (1.4 / 60.0))));
    EXPECT_NEAR(distance_of(enters[0]), 15.0 - walked, 1e-9);
    EXPECT_FALSE(has_field(enters[0], "cause"));

    AvatarProfile short_sighted;
    short_sighted.look_distance = 5.99;
    scene::Campus near = level_campus();
    add_box(near, "wall", {-1, 0, -8}, {1, 3, -6}, kSeen);
    EXPECT_TRUE(look_ahead(near, short_sighted).recorder.events("ray.*").empty());
    short_sighted.look_distance = 6.01;
    EXPECT_EQ(look_ahead(near, short_sighted).recorder.events("ray.enter").size(), 1U);
    short_sighted.look_distance = 0.0;
    EXPECT_TRUE(look_ahead(near, short_sighted).recorder.events("ray.*").empty());
}

TEST(Rays, HitTheNearestObjectOnly) {
    scene::Campus campus = level_campus();
    add_box(campus, "far", {-1, 0, -8}, {1, 3, -7}, kSeen);
    add_box(campus, "near", {-1, 0, -5}, {1, 3, -4}, kSeen);
    const RecordedRun result = look_ahead(campus);
    EXPECT_EQ(result.recorder.events("ray.enter near").size(), 1U);
    EXPECT_TRUE(result.recorder.events("ray.* far").empty());
}

TEST(Rays, EndAtASolidObstacle) {
    scene::Campus campus = level_campus();
    add_box(campus, "wall", {-1, 0, -8}, {1, 3, -6}, kSeen);
    add_box(campus, "hedge", {-1, 0, -4}, {1, 1.8, -3}, kSolid);
    EXPECT_TRUE(look_ahead(campus).recorder.events("ray.*").empty());
}

TEST(Rays, PassOverALowSolidAndThroughATrigger) {
    scene::Campus campus = level_campus();
    add_box(campus, "wall", {-1, 0, -8}, {1, 3, -6}, kSeen);
    add_box(campus, "bench", {-1, 0, -4}, {1, 1.6, -3}, kSolid);
    add_box(campus, "zone", {-1, 0, -4}, {1, 3, -3}, {Detection::trigger, "", true, ""});
    EXPECT_EQ(look_ahead(campus).recorder.events("ray.enter wall").size(), 1U);
}

TEST(Rays, HitAnObjectWithSolidAndRayDetection) {
    scene::Campus campus = level_campus();
    add_box(campus, "wall", {-1, 0, -8}, {1, 3, -6}, {Detection::solid | Detection::ray, "", true, ""});
    EXPECT_NEAR(distance_of(look_ahead(campus).recorder.events("ray.enter wall").at(0)), 6.0, 1e-12);
}

TEST(Rays, PassThroughIgnoredLayers) {
    scene::Campus campus = level_campus();
    add_box(campus, "wall", {-1, 0, -8}, {1, 3, -6}, kSeen);
    add_box(campus, "hedge", {-1, 0, -4}, {1, 1.8, -3}, {Detection::solid, "", true, "trees"});
    add_box(campus, "tree", {-1, 0, -3}, {1, 1.8, -2}, {Detection::ray, "", true, "trees"});
    AvatarProfile avatar;
    avatar.ignore_layers = {"trees"};
    const RecordedRun result = look_ahead(campus, avatar);
    EXPECT_EQ(result.recorder.events("ray.enter wall").size(), 1U);
    EXPECT_TRUE(result.recorder.events("ray.* tree").empty());
}

TEST(Rays, LeaveAnObjectWhenTheAvatarTurnsAway) {
    scene::Campus campus = level_campus();
    // Its edges are 11.3 degrees left and right; the avatar turns by 3 per tick.
    add_box(campus, "wall", {-1, 0, -6}, {1, 3, -5}, kSeen);
    const RecordedRun result = run(campus, without_gaze_hold(walk_of({spawn_at({0, 0, 0}), turn_by(90)})));
    const auto exits = result.recorder.events("ray.exit wall");
    ASSERT_EQ(exits.size(), 1U);
    EXPECT_EQ(exits[0].tick, 4);
    EXPECT_EQ(field<std::int64_t>(exits[0], "ticks"), 4);
    EXPECT_FALSE(has_field(exits[0], "cause"));
}

TEST(Rays, KeepAnObjectThatPassesBehindColumns) {
    // Sixty columns 6 cm wide, 20 cm apart, between the eyes and the building.
    scene::Campus campus = level_campus();
    add_building(campus, "hall");
    add_box(campus, "hall/front", {-20, 0, -6}, {20, 3, -5}, {Detection::ray, "hall", true, ""});
    for (int i = -30; i < 30; ++i) {
        add_box(campus, "column/" + std::to_string(i), {0.2 * i, 0, -3}, {0.2 * i + 0.06, 3, -2.94}, kSolid);
    }
    Walk walk =
        walk_of({spawn_at({-4, 0, 0}, radians(-90)), turn_to(0), turn_by(5), turn_by(-10), wait_for(1)});
    walk.avatar.turn_speed = radians(30);
    const RecordedRun held = run(campus, walk);
    EXPECT_EQ(held.recorder.events("popup.open hall").size(), 1U);
    EXPECT_EQ(held.recorder.events("popup.close hall").size(), 1U);
    const RecordedRun flickering = run(campus, without_gaze_hold(walk));
    EXPECT_GT(flickering.recorder.events("popup.open hall").size(), 3U);
}

TEST(Rays, LeaveAnObjectAfterTheHoldTime) {
    scene::Campus campus = level_campus();
    add_box(campus, "wall", {-1, 0, -6}, {1, 3, -5}, kSeen);
    const RecordedRun result = run(campus, walk_of({spawn_at({0, 0, 0}), turn_by(90)}));
    const auto exits = result.recorder.events("ray.exit wall");
    ASSERT_EQ(exits.size(), 1U);
    EXPECT_EQ(exits[0].tick, 3 + 12) << "last hit in tick 3";
    EXPECT_FALSE(has_field(exits[0], "cause"));
}

TEST(Rays, GoFromOneObjectToTheNextWithinATick) {
    scene::Campus campus = level_campus();
    add_box(campus, "left", {-5, 0, -6}, {-1, 3, -5}, kSeen);  // the lower id, but exits precede enters
    add_box(campus, "right", {-1, 0, -6}, {1, 3, -5}, kSeen);
    const RecordedRun result = run(campus, without_gaze_hold(walk_of({spawn_at({0, 0, 0}), turn_by(30)})));
    EXPECT_EQ(result.recorder.event_lines(), std::vector<std::string>({"ray.enter right", "ray.exit right",
                                                                       "ray.enter left", "ray.exit left"}));
    EXPECT_EQ(result.recorder.events("ray.exit right")[0].tick, 4);
    const Event enter = result.recorder.events("ray.enter left")[0];
    EXPECT_EQ(enter.tick, 4);
    EXPECT_NEAR(distance_of(enter), 5.0 / std::cos(radians(12)), 1e-9);
}

}  // namespace
}  // namespace campuswalk::engine

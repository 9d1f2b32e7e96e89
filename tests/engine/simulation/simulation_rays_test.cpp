#include <cmath>

#include <gtest/gtest.h>

#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"

// What the avatar looks at: one ray from its eyes, 1.65 m up, reaching 10 m.

namespace campuswalk::engine {
namespace {

using collision::Detection;
using Eigen::Vector3d;

const ObjectTraits kSeen{Detection::ray, "", true, ""};
const ObjectTraits kSolid{Detection::solid, "", true, ""};

Outing look_ahead(const scene::Campus& campus, const AvatarProfile& avatar = {}) {
    Walk walk = walk_of({spawn_at({0, 0, 0}), wait_for(0.1)});
    walk.avatar = avatar;
    return run(campus, walk);
}

/// With a gaze that forgets at once what it leaves.
Walk at_once(Walk walk) {
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
    const Outing outing = look_ahead(campus);
    const auto enters = outing.recorder.of("ray.enter wall");
    ASSERT_EQ(enters.size(), 1U);
    EXPECT_NEAR(distance_of(enters[0]), 6.0, 1e-12);
    EXPECT_EQ(enters[0].tick, 0);
    EXPECT_EQ(field<std::string>(enters[0], "cause"), "spawn");
    const auto exits = outing.recorder.of("ray.exit wall");
    ASSERT_EQ(exits.size(), 1U);
    EXPECT_EQ(field<std::string>(exits[0], "cause"), "end");
    EXPECT_FALSE(has_field(exits[0], "distance"));
    EXPECT_FALSE(has_field(enters[0], "at"));
}

TEST(Rays, MeasureFromWhereTheAvatarLooksTo) {
    scene::Campus campus = level_campus();
    const Vector3d center(-3, 4, 5);
    add_object(campus, "ball", collision::Sphere{0.5}, center, kSeen);
    const Outing outing =
        run(campus, walk_of({spawn_at({0, 0, 0}), look_at({"ball", center, true}), wait_for(1.0)}));
    const auto stays = outing.recorder.of("ray.stay ball");
    ASSERT_EQ(stays.size(), 1U);
    const Vector3d eye = eye_of(outing.recorder.at(stays[0].tick));
    EXPECT_NEAR(distance_of(stays[0]), (center - eye).norm() - 0.5, 1e-9);
    EXPECT_EQ(field<std::int64_t>(stays[0], "ticks"), 60);
}

TEST(Rays, LookDownAtTheFeet) {
    scene::Campus campus = level_campus();
    add_box(campus, "carpet", {-1, 0, -3}, {1, 0.01, 1}, kSeen);
    const Outing outing =
        run(campus, walk_of({spawn_at({0, 0, 0}), look_at({"kerb", {0, 0.01, -1}, true}), wait_for(0.1)}));
    const AvatarState last = outing.recorder.frames().back().avatar;
    const Vector3d eye = eye_of(last);
    EXPECT_NEAR(last.pitch, -std::atan2(eye.y() - 0.01, 1.0), 1e-12);
    const auto enters = outing.recorder.of("ray.enter carpet");
    ASSERT_EQ(enters.size(), 1U);
    // Seen from the first tick in which the ray, 3 degrees lower every tick, comes down before 3 m and 10 m.
    const double first = std::ceil(std::atan2(eye.y() - 0.01, 3.0) / radians(3.0));
    EXPECT_EQ(enters[0].tick, static_cast<Tick>(first));
    EXPECT_NEAR(distance_of(enters[0]), (eye.y() - 0.01) / std::sin(first * radians(3.0)), 1e-9);
}

TEST(Rays, ReachAsFarAsTheAvatarLooks) {
    scene::Campus campus = level_campus();
    add_box(campus, "wall", {-1, 0, -16}, {1, 3, -15}, kSeen);
    const Outing outing = run(campus, walk_of({spawn_at({0, 0, 0}), walk_to(0, -8)}));
    const auto enters = outing.recorder.of("ray.enter wall");
    ASSERT_EQ(enters.size(), 1U);
    const double walked = std::ceil(5.0 / (1.4 / 60.0)) * 1.4 / 60.0;
    EXPECT_EQ(enters[0].tick, static_cast<Tick>(std::ceil(5.0 / (1.4 / 60.0))));
    EXPECT_NEAR(distance_of(enters[0]), 15.0 - walked, 1e-9);
    EXPECT_FALSE(has_field(enters[0], "cause"));

    AvatarProfile short_sighted;
    short_sighted.look_distance = 5.99;
    scene::Campus near = level_campus();
    add_box(near, "wall", {-1, 0, -8}, {1, 3, -6}, kSeen);
    EXPECT_TRUE(look_ahead(near, short_sighted).recorder.of("ray.*").empty());
    short_sighted.look_distance = 6.01;
    EXPECT_EQ(look_ahead(near, short_sighted).recorder.of("ray.enter").size(), 1U);
    short_sighted.look_distance = 0.0;
    EXPECT_TRUE(look_ahead(near, short_sighted).recorder.of("ray.*").empty());
}

TEST(Rays, SeeTheNearestOnly) {
    scene::Campus campus = level_campus();
    add_box(campus, "far", {-1, 0, -8}, {1, 3, -7}, kSeen);
    add_box(campus, "near", {-1, 0, -5}, {1, 3, -4}, kSeen);
    const Outing outing = look_ahead(campus);
    EXPECT_EQ(outing.recorder.of("ray.enter near").size(), 1U);
    EXPECT_TRUE(outing.recorder.of("ray.* far").empty());
}

TEST(Rays, EndAtASolidInTheWay) {
    scene::Campus campus = level_campus();
    add_box(campus, "wall", {-1, 0, -8}, {1, 3, -6}, kSeen);
    add_box(campus, "hedge", {-1, 0, -4}, {1, 1.8, -3}, kSolid);
    EXPECT_TRUE(look_ahead(campus).recorder.of("ray.*").empty());
}

TEST(Rays, PassOverALowSolidAndThroughATrigger) {
    scene::Campus campus = level_campus();
    add_box(campus, "wall", {-1, 0, -8}, {1, 3, -6}, kSeen);
    add_box(campus, "bench", {-1, 0, -4}, {1, 1.6, -3}, kSolid);
    add_box(campus, "zone", {-1, 0, -4}, {1, 3, -3}, {Detection::trigger, "", true, ""});
    EXPECT_EQ(look_ahead(campus).recorder.of("ray.enter wall").size(), 1U);
}

TEST(Rays, SeeAnObjectThatIsBothSolidAndSeen) {
    scene::Campus campus = level_campus();
    add_box(campus, "wall", {-1, 0, -8}, {1, 3, -6}, {Detection::solid | Detection::ray, "", true, ""});
    EXPECT_NEAR(distance_of(look_ahead(campus).recorder.of("ray.enter wall").at(0)), 6.0, 1e-12);
}

TEST(Rays, PassThroughIgnoredLayers) {
    scene::Campus campus = level_campus();
    add_box(campus, "wall", {-1, 0, -8}, {1, 3, -6}, kSeen);
    add_box(campus, "hedge", {-1, 0, -4}, {1, 1.8, -3}, {Detection::solid, "", true, "trees"});
    add_box(campus, "tree", {-1, 0, -3}, {1, 1.8, -2}, {Detection::ray, "", true, "trees"});
    AvatarProfile avatar;
    avatar.ignore_layers = {"trees"};
    const Outing outing = look_ahead(campus, avatar);
    EXPECT_EQ(outing.recorder.of("ray.enter wall").size(), 1U);
    EXPECT_TRUE(outing.recorder.of("ray.* tree").empty());
}

TEST(Rays, LeaveAnObjectWhenTheAvatarTurnsAway) {
    scene::Campus campus = level_campus();
    // Its edges are 11.3 degrees left and right; the avatar turns by 3 a tick.
    add_box(campus, "wall", {-1, 0, -6}, {1, 3, -5}, kSeen);
    const Outing outing = run(campus, at_once(walk_of({spawn_at({0, 0, 0}), turn_by(90)})));
    const auto exits = outing.recorder.of("ray.exit wall");
    ASSERT_EQ(exits.size(), 1U);
    EXPECT_EQ(exits[0].tick, 4);
    EXPECT_EQ(field<std::int64_t>(exits[0], "ticks"), 4);
    EXPECT_FALSE(has_field(exits[0], "cause"));
}

TEST(Rays, HoldWhatPassesBehindColumns) {
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
    const Outing held = run(campus, walk);
    EXPECT_EQ(held.recorder.of("popup.open hall").size(), 1U);
    EXPECT_EQ(held.recorder.of("popup.close hall").size(), 1U);
    const Outing flickering = run(campus, at_once(walk));
    EXPECT_GT(flickering.recorder.of("popup.open hall").size(), 3U);
}

TEST(Rays, LeaveWhatTheyHaveNotMetForTheHold) {
    scene::Campus campus = level_campus();
    add_box(campus, "wall", {-1, 0, -6}, {1, 3, -5}, kSeen);
    const Outing outing = run(campus, walk_of({spawn_at({0, 0, 0}), turn_by(90)}));
    const auto exits = outing.recorder.of("ray.exit wall");
    ASSERT_EQ(exits.size(), 1U);
    EXPECT_EQ(exits[0].tick, 3 + 12) << "last met in tick 3";
    EXPECT_FALSE(has_field(exits[0], "cause"));
}

TEST(Rays, GoFromOneObjectToTheNextInATick) {
    scene::Campus campus = level_campus();
    add_box(campus, "left", {-5, 0, -6}, {-1, 3, -5}, kSeen);  // lower ids would go first, but exits do
    add_box(campus, "right", {-1, 0, -6}, {1, 3, -5}, kSeen);
    const Outing outing = run(campus, at_once(walk_of({spawn_at({0, 0, 0}), turn_by(30)})));
    EXPECT_EQ(outing.recorder.story(), std::vector<std::string>({"ray.enter right", "ray.exit right",
                                                                 "ray.enter left", "ray.exit left"}));
    EXPECT_EQ(outing.recorder.of("ray.exit right")[0].tick, 4);
    const Event enter = outing.recorder.of("ray.enter left")[0];
    EXPECT_EQ(enter.tick, 4);
    EXPECT_NEAR(distance_of(enter), 5.0 / std::cos(radians(12)), 1e-9);
}

}  // namespace
}  // namespace campuswalk::engine

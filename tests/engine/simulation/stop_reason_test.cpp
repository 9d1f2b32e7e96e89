#include "engine/simulation/stop_reason.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"

// Why an avatar is blocked, in the log and in the failure's message.

namespace campuswalk::engine {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;

std::string why_blocked(const scene::Campus& campus) {
    WalkToStep step = walk_to(0, -10);
    step.if_blocked = IfBlocked::proceed;
    const RecordedRun result = run(campus, walk_of({spawn_at({0, 0, 0}), step}));
    const std::vector<Event> blocked = result.recorder.events("avatar.blocked");
    return blocked.size() == 1 && reason_of(blocked[0]) != nullptr ? text_of(*reason_of(blocked[0])) : "";
}

TEST(StopReason, AnObstacleThatOneCanWalkRound) {
    scene::Campus campus = level_campus();
    add_box(campus, "bench", {-0.8, 0, -4}, {0.8, 0.8, -3.5});
    EXPECT_THAT(
        why_blocked(campus),
        MatchesRegex("bench is in the way at 0\\.00, 0\\.[0-9]+, -3\\.50; [23]\\.[0-9] m lead round it"));
}

TEST(StopReason, ARiser) {
    scene::Campus campus = level_campus();
    add_box(campus, "stage", {-20, -0.1, -14}, {20, 0.45, -4});
    EXPECT_THAT(why_blocked(campus),
                MatchesRegex("riser of 0\\.45 m at stage, .*; the avatar steps 0\\.30 m"));
}

TEST(StopReason, AGateThatLeavesTooNarrowAnOpening) {
    scene::Campus campus = level_campus();
    add_box(campus, "left", {-20, 0, -4}, {-0.6, 3, -3.8});
    add_box(campus, "right", {0.6, 0, -4}, {20, 3, -3.8});
    add_box(campus, "gate-leaf", {-0.6, 0, -3.93}, {0.1, 2, -3.87});
    EXPECT_THAT(why_blocked(campus), HasSubstr("gate-leaf stands in the way"));
    EXPECT_THAT(why_blocked(campus),
                HasSubstr("the opening beside it is 0.50 m wide, the body needs 0.60 m"));
}

TEST(StopReason, AWallWithoutEnd) {
    scene::Campus campus = level_campus();
    add_box(campus, "wall", {-20, 0, -4}, {20, 6, -3.8});
    EXPECT_THAT(why_blocked(campus), MatchesRegex("wall .*at 0\\.00, [0-9.]+, -3\\.80"));
}

TEST(StopReason, TheFailureNamesARouteToTheTarget) {
    scene::Campus campus = level_campus();
    add_box(campus, "wall", {-20, 0, -4}, {6, 6, -3.8});
    const RecordedRun result = run(campus, walk_of({spawn_at({0, 0, 0}), walk_to(0, -10)}));
    ASSERT_EQ(result.summary.failures.size(), 1U);
    // To the corner at 6.3, -4 and back: 6.3 + 8.7 m.
    EXPECT_THAT(
        result.summary.failures[0].message,
        MatchesRegex(".*wall .*; from there a route of 1[45]\\.[0-9] m leads to goal by \\[[2-6]\\.[0-9]+, "
                     "-3\\.[0-9]+\\].*: use go_to"));
    const std::vector<Event> blocked = result.recorder.events("avatar.blocked");
    ASSERT_EQ(blocked.size(), 1U);
    EXPECT_THAT(text_of(*reason_of(blocked[0])), Not(HasSubstr("route of"))) << "only what is in the way";
}

TEST(StopReason, TheFailureNamesARouteToAnotherLevel) {
    scene::Campus campus = level_campus();
    add_box(campus, "deck", {-2, 2.0, -10}, {2, 2.4, -4});
    for (int i = 0; i < 10; ++i) {  // stairs up to it from the west
        add_box(campus, "stair", {-5.0 + 0.3 * i, 0, -8}, {-4.7 + 0.3 * i, 0.24 * (i + 1), -6});
    }
    WalkToStep up = walk_to(0, -7);
    up.target.point.y() = 2.4;
    up.target.has_height = true;
    const RecordedRun result = run(campus, walk_of({spawn_at({0, 0, 0}), up}));
    ASSERT_EQ(result.summary.failures.size(), 1U);
    EXPECT_THAT(
        result.summary.failures[0].message,
        MatchesRegex(
            ".*2\\.40. m above the avatar's feet; from there a route of [0-9.]+ m leads to goal by .*"));
}

TEST(StopReason, TheGroundIsNoObstacle) {
    scene::Campus campus = level_campus();
    collision::Object ramp;  // which rises by 2 degrees towards the south
    ramp.shape = collision::Box{{10, 0.1, 10}};
    ramp.X_world_shape.rotation = Eigen::AngleAxisd(-0.035, Eigen::Vector3d::UnitX()).toRotationMatrix();
    campus.objects.push_back({"ramp", {}, {}});
    campus.world.add(ramp);
    StoppedBody body{{}, {collision::Detection::solid, 0}, {{0, 0.1, 0}, 0.1}, {0, 0, 1}};
    EXPECT_FALSE(reason_of_stop(campus, body));
    body.heading = {0, 0, -1};
    EXPECT_FALSE(reason_of_stop(campus, body));
}

TEST(StopReason, IsPartOfTheFailureButNotOfTheHash) {
    scene::Campus low = level_campus();
    add_box(low, "stage", {-20, -0.1, -14}, {20, 0.45, -4});
    scene::Campus high = level_campus();
    add_box(high, "stage", {-20, -0.1, -14}, {20, 0.85, -4});
    const Walk walk = walk_of({spawn_at({0, 0, 0}), walk_to(0, -10)});
    const RecordedRun on_low = run(low, walk);
    const RecordedRun on_high = run(high, walk);
    ASSERT_FALSE(on_low.summary.failures.empty());
    EXPECT_THAT(on_low.summary.failures[0].message, HasSubstr("riser of 0.45 m"));
    EXPECT_THAT(on_high.summary.failures[0].message, HasSubstr("ledge of 0.85 m"));
    EXPECT_EQ(on_low.summary.hash, on_high.summary.hash) << "the avatar did the same";
}

std::string fall_message(const scene::Campus& campus, std::vector<Step> steps) {
    const RecordedRun result = run(campus, walk_of(std::move(steps)));
    if (result.summary.failures.empty()) {
        return "";
    }
    EXPECT_EQ(result.summary.failures[0].code, "fell");
    return result.summary.failures[0].message;
}

TEST(StopReason, AFallOutOfTheWorldSaysFromTheEdgeOfWhat) {
    scene::Campus campus = level_campus(5.0);
    EXPECT_THAT(
        fall_message(campus, {spawn_at({0, 0, 0}), walk_to(0, -10)}),
        MatchesRegex("the avatar fell out of the world from the edge of ground at a height of 0\\.00 m; it "
                     "last stood at 0\\.00, 0\\.00, -5\\.00"));
    add_box(campus, "pier", {-1, -1, -8}, {1, 0.25, -4});
    add_box(campus, "rail", {1, 0, -8}, {1.1, 1.2, -4});
    EXPECT_THAT(fall_message(campus, {spawn_at({0.65, 0, 0}), walk_to(0.65, -10), wait_for(10)}),
                HasSubstr("from the edge of pier at a height of 0.25 m; it last stood at 0.65, 0.25, -8.00"));
}

TEST(StopReason, AFallNamesARouteRoundTheHole) {
    scene::Campus campus = empty_campus();
    add_box(campus, "west", {-10, -1, -20}, {-1, 0, 20});
    add_box(campus, "east", {1, -1, -20}, {10, 0, 20});
    add_box(campus, "bridge", {-1, -1, 4}, {1, 0, 8});
    const std::string message = fall_message(campus, {spawn_at({-4, 0, 0}), walk_to(4, 0)});
    EXPECT_THAT(message,
                HasSubstr("from the edge of west at a height of 0.00 m; it last stood at -1.00, 0.00, 0.00"));
    // To the bridge at z = 4, over it and back, hanging over its edge at most: 4 + 2 + 5 m.
    EXPECT_THAT(message,
                MatchesRegex(".*; from there a route of 1[01]\\.[0-9] m leads to goal by .*: use go_to"));
    const std::string along = fall_message(campus, {spawn_at({-4, 0, 0}), follow({{4, 0, 0}})});
    EXPECT_THAT(along, HasSubstr("; from there a route of 1")) << "a follow as well";
    add_box(campus, "wall", {-1, 0, 4}, {-0.8, 3, 8});
    EXPECT_THAT(fall_message(campus, {spawn_at({-4, 0, 0}), walk_to(4, 0)}), Not(HasSubstr("route")));
}

TEST(StopReason, AFallWhereTheGroundWasDisabledHasNoEdge) {
    EXPECT_THAT(fall_message(level_campus(5.0), {spawn_at({0, 0, 0}), disable("ground"), wait_for(10)}),
                MatchesRegex("the avatar fell out of the world; it last stood at 0\\.00, 0\\.00, 0\\.00"));
}

TEST(StopReason, AFallFromWhereTheAvatarWasPlacedHasNoEdge) {
    EXPECT_THAT(fall_message(level_campus(5.0), {spawn_at({0, 0, 0}), teleport_to({20, 0, 0}), wait_for(10)}),
                HasSubstr("out of the world; it never stood on any ground since it was placed"));
}

}  // namespace
}  // namespace campuswalk::engine

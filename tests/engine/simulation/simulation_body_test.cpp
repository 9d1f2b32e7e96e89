// What the avatar does with its body: jump, crouch, run, follow a curve.

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"
#include "tests/support/angles.h"

namespace campuswalk::engine {
namespace {

using collision::Detection;
using Eigen::Vector3d;
using support::radians;
using testing::AllOf;
using testing::HasSubstr;

constexpr double kGravity = 9.81;
using Lines = std::vector<std::string>;

// ---- jumping --------------------------------------------------------------------------------------------

TEST(Jump, FollowsAParabolaAtEveryTickRate) {
    for (const int rate : {30, 60, 240}) {
        Walk walk = walk_of({spawn_at({0, 0, 0}), jump_up(3.0), wait_for(0.1)});
        walk.sim.ticks_per_second = rate;
        const RecordedRun result = run(level_campus(), walk);
        const double ground = result.recorder.at(0).position.y();
        const auto landing = static_cast<Tick>(std::ceil(2.0 * 3.0 / kGravity * rate));
        for (Tick tick = 1; tick < landing; ++tick) {
            const double t = static_cast<double>(tick) / rate;
            ASSERT_NEAR(result.recorder.at(tick).position.y() - ground, 3.0 * t - 0.5 * kGravity * t * t,
                        1e-9)
                << rate << " tps, tick " << tick;
            ASSERT_FALSE(result.recorder.at(tick).grounded);
        }
        EXPECT_TRUE(result.recorder.at(landing).grounded);
        EXPECT_NEAR(result.recorder.at(landing).position.y(), ground, 1e-3);
        EXPECT_EQ(result.recorder.event_lines(), Lines({"avatar.jump stroll", "avatar.landed stroll"}));
        EXPECT_EQ(field<Decimal>(result.recorder.events("avatar.jump")[0], "speed").value, 3.0);
        const Event landed = result.recorder.events("avatar.landed")[0];
        EXPECT_EQ(landed.tick, landing) << "the step lasts until the landing";
        // The top lies between two ticks, half a tick from one at most; a body rests 0.1 mm above the ground.
        const double missed = 0.125 * kGravity / rate / rate + 1e-4;
        EXPECT_NEAR(field<Decimal>(landed, "height").value, 9.0 / (2.0 * kGravity), missed);
    }
}

TEST(Jump, MovesForwardInTheDirectionOfYaw) {
    const RecordedRun result =
        run(level_campus(), walk_of({spawn_at({0, 0, 0}, radians(90)), jump_up(3.0, 2.0)}));
    const Vector3d end = result.recorder.states().back().avatar.position;
    const double seconds = std::ceil(2.0 * 3.0 / kGravity * 60.0) / 60.0;
    EXPECT_NEAR(end.x(), -2.0 * seconds, 1e-9) << "yaw 90 looks along -x";
    EXPECT_NEAR(end.z(), 0.0, 1e-9);
}

TEST(Jump, ClearsAnObstacleTooHighToStepOver) {
    const auto end_of = [](std::vector<Step> steps) {
        scene::Campus campus = level_campus();
        add_box(campus, "bar", {-5, 0, -1.6}, {5, 0.5, -1.5});
        Walk walk = walk_of(std::move(steps));
        return run(campus, walk).recorder.states().back().avatar.position.z();
    };
    WalkToStep step = walk_to(0, -4);
    step.if_blocked = IfBlocked::proceed;
    EXPECT_GT(end_of({spawn_at({0, 0, 0}), step}), -1.3) << "half a metre stops an adult";
    const double jump = std::sqrt(2.0 * kGravity * 0.8);
    EXPECT_LT(end_of({spawn_at({0, 0, 0}), walk_to(0, -0.6), jump_up(jump, 2.5), step}), -3.9);
}

TEST(Jump, StopsRisingAtAnObstacleOverheadAndLands) {
    scene::Campus campus = level_campus();
    add_box(campus, "beam", {-1, 2.0, -1}, {1, 2.2, 1});
    const RecordedRun result = run(campus, walk_of({spawn_at({0, 0, 0}), jump_up(4.0), wait_for(0.1)}));
    double highest = 0.0;
    for (const Recorder::TickState& state : result.recorder.states()) {
        highest = std::max(highest, state.avatar.position.y());
    }
    EXPECT_GT(highest, 0.19);
    EXPECT_LE(highest, 0.2);
    EXPECT_TRUE(result.summary.passed);
    EXPECT_EQ(result.recorder.events("avatar.landed").size(), 1U)
        << "a jump's landing is logged from any height";
}

TEST(Jump, WaitsUntilTheAvatarIsOnTheGround) {
    const RecordedRun result =
        run(level_campus(), walk_of({spawn_at({0, 0, 0}), teleport_to({0, 5, 0}), jump_up(2.0)}));
    EXPECT_EQ(result.recorder.event_lines(), Lines({"avatar.teleport elsewhere", "avatar.landed stroll",
                                                    "avatar.jump stroll", "avatar.landed stroll"}));
}

// ---- crouching ------------------------------------------------------------------------------------------

/// A bar across the path from z = -2 to -4 with 1.3 m of headroom.
scene::Campus low_campus() {
    scene::Campus campus = level_campus();
    add_box(campus, "bar", {-5, 1.3, -4}, {5, 3, -2});
    return campus;
}

TEST(Crouch, PassesUnderABarThatBlocksAStandingAvatar) {
    WalkToStep step = walk_to(0, -6);
    step.if_blocked = IfBlocked::proceed;
    const RecordedRun tall = run(low_campus(), walk_of({spawn_at({0, 0, 0}), step}));
    EXPECT_EQ(tall.recorder.events("avatar.blocked goal").size(), 1U);
    const RecordedRun low =
        run(low_campus(), walk_of({spawn_at({0, 0, 0}), set_height(1.2), step, set_height(1.8)}));
    EXPECT_EQ(low.recorder.events("avatar.arrive goal").size(), 1U);
    EXPECT_EQ(field<Decimal>(low.recorder.events("avatar.crouch stroll").at(0), "height").value, 1.2);
    EXPECT_EQ(field<Decimal>(low.recorder.events("avatar.stand stroll").at(0), "height").value, 1.8);
}

TEST(Crouch, FailsToStandUpWithoutHeadroom) {
    CrouchStep up = set_height(1.8);
    up.mark = {"a.walk.yaml", 9, 3};
    const RecordedRun result = run(
        low_campus(), walk_of({spawn_at({0, 0, 0}), set_height(1.2), walk_to(0, -3), up, snapshot("never")}));
    ASSERT_EQ(result.summary.failures.size(), 1U);
    EXPECT_EQ(result.summary.failures[0].code, "blocked");
    EXPECT_THAT(result.summary.failures[0].message, AllOf(HasSubstr("1.80 m"), HasSubstr("bar")));
    EXPECT_EQ(result.summary.failures[0].mark.line, 9);
    EXPECT_TRUE(result.recorder.events("snapshot.take").empty());
    EXPECT_TRUE(result.recorder.events("avatar.stand").empty());
}

TEST(Crouch, LowersTheEyesInProportion) {
    // Eyes at 1.65 m see over a wall of 1.2 m; at 1.1 m they see it.
    scene::Campus campus = level_campus();
    add_box(campus, "sill", {-1, 0, -5}, {1, 1.2, -4}, {Detection::ray, "", true, ""});
    const RecordedRun result =
        run(campus, walk_of({spawn_at({0, 0, 0}), wait_for(0.5), set_height(1.2), wait_for(0.5)}));
    const auto enters = result.recorder.events("ray.enter sill");
    ASSERT_EQ(enters.size(), 1U);
    EXPECT_EQ(enters[0].tick, 31) << "the first tick after the crouch";
    EXPECT_NEAR(result.recorder.states().back().avatar.stature, 1.2 / 1.8, 1e-15);
}

TEST(Crouch, ExitsATriggerAboveTheHead) {
    scene::Campus campus = level_campus();
    add_box(campus, "shelf", {-1, 1.5, -1}, {1, 2, 1}, {Detection::trigger, "", true, ""});
    const RecordedRun result =
        run(campus,
            walk_of({spawn_at({0, 0, 0}), set_height(1.2), wait_for(0.1), set_height(1.8), wait_for(0.1)}));
    EXPECT_EQ(result.recorder.event_lines(),
              Lines({"trigger.enter shelf", "avatar.crouch stroll", "trigger.exit shelf",
                     "avatar.stand stroll", "trigger.enter shelf", "trigger.exit shelf"}));
}

TEST(Crouch, LogsNothingIfTheHeightIsUnchanged) {
    const RecordedRun result =
        run(level_campus(), walk_of({spawn_at({0, 0, 0}), set_height(1.8), wait_for(0.1)}));
    EXPECT_EQ(result.recorder.event_lines(), Lines());
}

// ---- speed ----------------------------------------------------------------------------------------------

TEST(SpeedStep, AppliesToTheStepsAfterIt) {
    WalkToStep own = walk_to(0, -6);
    own.speed = 0.6;
    const RecordedRun result =
        run(level_campus(), walk_of({spawn_at({0, 0, 0}), walk_to(0, -1.4), set_speed(3.0), walk_to(0, -5),
                                     own, follow({{0, 0, -9}})}));
    std::vector<double> speeds;
    for (std::size_t i = 1; i < result.recorder.states().size(); ++i) {
        Vector3d motion =
            result.recorder.states()[i].avatar.position - result.recorder.states()[i - 1].avatar.position;
        motion.y() = 0.0;
        const double moved = motion.norm();
        if (speeds.empty() || std::abs(moved * 60.0 - speeds.back()) > 1e-6) {
            speeds.push_back(moved * 60.0);
        }
    }
    // Steps end within 5 cm of their targets: the only other speed is that of a last, shorter tick.
    const auto has = [&](double speed) {
        return std::ranges::any_of(speeds, [&](double s) { return std::abs(s - speed) < 1e-6; });
    };
    EXPECT_NEAR(speeds.front(), 1.4, 1e-6);
    EXPECT_TRUE(has(3.0));
    EXPECT_TRUE(has(0.6)) << "a step's own speed takes precedence";
    EXPECT_NEAR(*std::max_element(speeds.begin(), speeds.end()), 3.0, 1e-6);
}

// ---- following ------------------------------------------------------------------------------------------

TEST(Follow, PassesThroughItsPointsAtFullSpeed) {
    const std::vector<Vector3d> points = {{3, 0, -3}, {0, 0, -6}, {-3, 0, -3}, {0, 0, 0}};
    const RecordedRun result = run(level_campus(), walk_of({spawn_at({0, 0, 0}), follow(points)}));
    EXPECT_TRUE(result.summary.passed);
    EXPECT_EQ(result.recorder.events("avatar.arrive goal").size(), 1U)
        << "not at the start, where the curve ends";
    for (const Vector3d& point : points) {
        double nearest = 1e9;
        for (const Recorder::TickState& state : result.recorder.states()) {
            const Vector3d offset = state.avatar.position - point;
            nearest = std::min(nearest, std::sqrt(offset.x() * offset.x() + offset.z() * offset.z()));
        }
        EXPECT_LT(nearest, 0.05);
    }
    // At full speed; only the chords of the curve are shorter.
    EXPECT_NEAR(result.summary.distance, 1.4 * static_cast<double>(result.summary.ticks) / 60.0, 0.05);
    EXPECT_GT(result.summary.distance, 4.0 * std::sqrt(18.0)) << "longer than the straight lines";
}

TEST(Follow, TurnsSmoothly) {
    const RecordedRun result =
        run(level_campus(), walk_of({spawn_at({0, 0, 0}), follow({{0, 0, -3}, {3, 0, -3}, {3, 0, 0}})}));
    const auto& states = result.recorder.states();
    for (std::size_t i = 2; i + 2 < states.size(); ++i) {  // the last one repeats the final tick
        const Vector3d before = states[i].avatar.position - states[i - 1].avatar.position;
        const Vector3d after = states[i + 1].avatar.position - states[i].avatar.position;
        ASSERT_GT(before.dot(after) / (before.norm() * after.norm()), 0.99) << "tick " << i;
    }
}

TEST(Follow, GivesUpAtAWall) {
    scene::Campus campus = level_campus();
    add_box(campus, "wall", {-20, 0, -4}, {20, 3, -3});
    FollowStep step = follow({{1, 0, -2}, {0, 0, -8}});
    step.mark = {"a.walk.yaml", 5, 3};
    const RecordedRun result = run(campus, walk_of({spawn_at({0, 0, 0}), step}));
    ASSERT_EQ(result.summary.failures.size(), 1U);
    EXPECT_THAT(result.summary.failures[0].message, AllOf(HasSubstr("goal"), HasSubstr("wall")));
    EXPECT_EQ(result.summary.failures[0].mark.line, 5);
    step.if_blocked = IfBlocked::proceed;
    EXPECT_TRUE(run(campus, walk_of({spawn_at({0, 0, 0}), step})).summary.passed);
}

TEST(Follow, ReturnsToItsCurveBehindAPole) {
    scene::Campus campus = level_campus();
    add_box(campus, "pole", {0.02, 0, -3.1}, {0.12, 3, -3});
    const RecordedRun result = run(campus, walk_of({spawn_at({0, 0, 0}), follow({{0, 0, -3}, {0, 0, -8}})}));
    EXPECT_TRUE(result.summary.passed);
    EXPECT_EQ(result.recorder.events("collision.enter pole").size(), 1U);
    EXPECT_NEAR(result.recorder.states().back().avatar.position.x(), 0.0, 0.06);
}

/// A teleport ends the visit of a trigger even if the avatar is inside it before and after.
TEST(Teleport, EndsContactsThatBeginAgain) {
    scene::Campus campus = level_campus();
    add_box(campus, "zone", {-3, 0, -3}, {3, 2, 3}, {collision::Detection::trigger, "", true, ""});
    const RecordedRun result = run(campus, walk_of({spawn_at({1, 0, 0}), teleport_to({-1, 0, 0})}));
    const std::vector<Event> enters = result.recorder.events("trigger.enter");
    const std::vector<Event> exits = result.recorder.events("trigger.exit");
    ASSERT_EQ(enters.size(), 2U);
    ASSERT_EQ(exits.size(), 2U);
    EXPECT_EQ(field<std::string>(exits[0], "cause"), "teleport");
    EXPECT_EQ(field<std::string>(enters[1], "cause"), "teleport");
    EXPECT_EQ(field<std::string>(exits[1], "cause"), "end");
}

}  // namespace
}  // namespace campuswalk::engine

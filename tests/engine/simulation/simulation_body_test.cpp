// What the avatar does with its body: jump, crouch, run, follow a curve.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"

namespace campuswalk::engine {
namespace {

using collision::Detection;
using Eigen::Vector3d;

constexpr double kGravity = 9.81;
using Story = std::vector<std::string>;

// ---- jumping --------------------------------------------------------------------------------------------

TEST(Jump, FollowsTheParabolaWhateverTheRate) {
    for (const int rate : {30, 60, 240}) {
        Walk walk = walk_of({spawn_at({0, 0, 0}), jump_up(3.0), wait_for(0.1)});
        walk.sim.ticks_per_second = rate;
        const Outing outing = run(level_campus(), walk);
        const double ground = outing.recorder.at(0).position.y();
        const auto landing = static_cast<Tick>(std::ceil(2.0 * 3.0 / kGravity * rate));
        for (Tick tick = 1; tick < landing; ++tick) {
            const double t = static_cast<double>(tick) / rate;
            ASSERT_NEAR(outing.recorder.at(tick).position.y() - ground, 3.0 * t - 0.5 * kGravity * t * t,
                        1e-9)
                << rate << " tps, tick " << tick;
            ASSERT_FALSE(outing.recorder.at(tick).grounded);
        }
        EXPECT_TRUE(outing.recorder.at(landing).grounded);
        EXPECT_NEAR(outing.recorder.at(landing).position.y(), ground, 1e-3);
        EXPECT_EQ(outing.recorder.story(), Story({"avatar.jump stroll", "avatar.landed stroll"}));
        EXPECT_EQ(field<Decimal>(outing.recorder.of("avatar.jump")[0], "speed").value, 3.0);
        const Event landed = outing.recorder.of("avatar.landed")[0];
        EXPECT_EQ(landed.tick, landing) << "the step takes until then";
        // The top lies between two ticks, half a tick from one at most; a body rests 0.1 mm above the ground.
        const double missed = 0.125 * kGravity / rate / rate + 1e-4;
        EXPECT_NEAR(field<Decimal>(landed, "height").value, 9.0 / (2.0 * kGravity), missed);
    }
}

TEST(Jump, CarriesForwardWhereTheAvatarLooks) {
    const Outing outing = run(level_campus(), walk_of({spawn_at({0, 0, 0}, radians(90)), jump_up(3.0, 2.0)}));
    const Vector3d end = outing.recorder.frames().back().avatar.position;
    const double seconds = std::ceil(2.0 * 3.0 / kGravity * 60.0) / 60.0;
    EXPECT_NEAR(end.x(), -2.0 * seconds, 1e-9) << "yaw 90 looks along -x";
    EXPECT_NEAR(end.z(), 0.0, 1e-9);
}

TEST(Jump, ClearsWhatIsTooHighToStepOver) {
    const auto end_of = [](std::vector<Step> steps) {
        scene::Campus campus = level_campus();
        add_box(campus, "bar", {-5, 0, -1.6}, {5, 0.5, -1.5});
        Walk walk = walk_of(std::move(steps));
        return run(campus, walk).recorder.frames().back().avatar.position.z();
    };
    WalkToStep step = walk_to(0, -4);
    step.if_blocked = IfBlocked::proceed;
    EXPECT_GT(end_of({spawn_at({0, 0, 0}), step}), -1.3) << "half a metre stops an adult";
    const double jump = std::sqrt(2.0 * kGravity * 0.8);
    EXPECT_LT(end_of({spawn_at({0, 0, 0}), walk_to(0, -0.6), jump_up(jump, 2.5), step}), -3.9);
}

TEST(Jump, BumpsItsHeadAndComesDown) {
    scene::Campus campus = level_campus();
    add_box(campus, "beam", {-1, 2.0, -1}, {1, 2.2, 1});
    const Outing outing = run(campus, walk_of({spawn_at({0, 0, 0}), jump_up(4.0), wait_for(0.1)}));
    double highest = 0.0;
    for (const Recorder::Frame& frame : outing.recorder.frames()) {
        highest = std::max(highest, frame.avatar.position.y());
    }
    EXPECT_GT(highest, 0.19);
    EXPECT_LE(highest, 0.2);
    EXPECT_TRUE(outing.summary.passed);
    EXPECT_EQ(outing.recorder.of("avatar.landed").size(), 1U) << "a jump's landing is told however low";
}

TEST(Jump, WaitsForTheGround) {
    const Outing outing =
        run(level_campus(), walk_of({spawn_at({0, 0, 0}), teleport_to({0, 5, 0}), jump_up(2.0)}));
    EXPECT_EQ(outing.recorder.story(), Story({"avatar.teleport elsewhere", "avatar.landed stroll",
                                              "avatar.jump stroll", "avatar.landed stroll"}));
}

// ---- crouching ------------------------------------------------------------------------------------------

/// A bar across the way from z = -2 to -4 with 1.3 m of head room.
scene::Campus low_campus() {
    scene::Campus campus = level_campus();
    add_box(campus, "bar", {-5, 1.3, -4}, {5, 3, -2});
    return campus;
}

TEST(Crouch, PassesUnderWhatStopsOneWhoStands) {
    WalkToStep step = walk_to(0, -6);
    step.if_blocked = IfBlocked::proceed;
    const Outing tall = run(low_campus(), walk_of({spawn_at({0, 0, 0}), step}));
    EXPECT_EQ(tall.recorder.of("avatar.blocked goal").size(), 1U);
    const Outing low = run(low_campus(), walk_of({spawn_at({0, 0, 0}), be_tall(1.2), step, be_tall(1.8)}));
    EXPECT_EQ(low.recorder.of("avatar.arrive goal").size(), 1U);
    EXPECT_EQ(field<Decimal>(low.recorder.of("avatar.crouch stroll").at(0), "height").value, 1.2);
    EXPECT_EQ(field<Decimal>(low.recorder.of("avatar.stand stroll").at(0), "height").value, 1.8);
}

TEST(Crouch, CantStandUpWithoutHeadRoom) {
    CrouchStep up = be_tall(1.8);
    up.mark = {"a.walk.yaml", 9, 3};
    const Outing outing = run(
        low_campus(), walk_of({spawn_at({0, 0, 0}), be_tall(1.2), walk_to(0, -3), up, snapshot("never")}));
    ASSERT_EQ(outing.summary.failures.size(), 1U);
    EXPECT_EQ(outing.summary.failures[0].code, "blocked");
    EXPECT_EQ(outing.summary.failures[0].message, "there is no head room for 1.80 m: blocked by bar");
    EXPECT_EQ(outing.summary.failures[0].mark.line, 9);
    EXPECT_TRUE(outing.recorder.of("snapshot.take").empty());
    EXPECT_TRUE(outing.recorder.of("avatar.stand").empty());
}

TEST(Crouch, LowersTheEyesInProportion) {
    // Eyes at 1.65 m see over a wall of 1.2 m; at 1.1 m they see it.
    scene::Campus campus = level_campus();
    add_box(campus, "sill", {-1, 0, -5}, {1, 1.2, -4}, {Detection::ray, "", true, ""});
    const Outing outing =
        run(campus, walk_of({spawn_at({0, 0, 0}), wait_for(0.5), be_tall(1.2), wait_for(0.5)}));
    const auto enters = outing.recorder.of("ray.enter sill");
    ASSERT_EQ(enters.size(), 1U);
    EXPECT_EQ(enters[0].tick, 31) << "the first tick after crouching";
    EXPECT_NEAR(outing.recorder.frames().back().avatar.stature, 1.2 / 1.8, 1e-15);
}

TEST(Crouch, LeavesATriggerOverTheHead) {
    scene::Campus campus = level_campus();
    add_box(campus, "shelf", {-1, 1.5, -1}, {1, 2, 1}, {Detection::trigger, "", true, ""});
    const Outing outing =
        run(campus, walk_of({spawn_at({0, 0, 0}), be_tall(1.2), wait_for(0.1), be_tall(1.8), wait_for(0.1)}));
    EXPECT_EQ(outing.recorder.story(),
              Story({"trigger.enter shelf", "avatar.crouch stroll", "trigger.exit shelf",
                     "avatar.stand stroll", "trigger.enter shelf", "trigger.exit shelf"}));
}

TEST(Crouch, IsNothingWhenItIsThatTallAlready) {
    const Outing outing = run(level_campus(), walk_of({spawn_at({0, 0, 0}), be_tall(1.8), wait_for(0.1)}));
    EXPECT_EQ(outing.recorder.story(), Story());
}

// ---- pace -----------------------------------------------------------------------------------------------

TEST(Pace, HoldsFromTheStepThatSetsIt) {
    WalkToStep own = walk_to(0, -6);
    own.speed = 0.6;
    const Outing outing = run(level_campus(), walk_of({spawn_at({0, 0, 0}), walk_to(0, -1.4), go_at(3.0),
                                                       walk_to(0, -5), own, follow({{0, 0, -9}})}));
    std::vector<double> speeds;
    for (std::size_t i = 1; i < outing.recorder.frames().size(); ++i) {
        Vector3d way =
            outing.recorder.frames()[i].avatar.position - outing.recorder.frames()[i - 1].avatar.position;
        way.y() = 0.0;
        const double moved = way.norm();
        if (speeds.empty() || std::abs(moved * 60.0 - speeds.back()) > 1e-6) {
            speeds.push_back(moved * 60.0);
        }
    }
    // Steps end within 5 cm of their targets: only a last, shorter tick comes between.
    const auto has = [&](double speed) {
        return std::ranges::any_of(speeds, [&](double s) { return std::abs(s - speed) < 1e-6; });
    };
    EXPECT_NEAR(speeds.front(), 1.4, 1e-6);
    EXPECT_TRUE(has(3.0));
    EXPECT_TRUE(has(0.6)) << "its own speed goes first";
    EXPECT_NEAR(*std::max_element(speeds.begin(), speeds.end()), 3.0, 1e-6);
}

// ---- following ------------------------------------------------------------------------------------------

TEST(Follow, PassesThroughItsPointsAtFullSpeed) {
    const std::vector<Vector3d> points = {{3, 0, -3}, {0, 0, -6}, {-3, 0, -3}, {0, 0, 0}};
    const Outing outing = run(level_campus(), walk_of({spawn_at({0, 0, 0}), follow(points)}));
    EXPECT_TRUE(outing.summary.passed);
    EXPECT_EQ(outing.recorder.of("avatar.arrive goal").size(), 1U) << "not at once, where the curve ends";
    for (const Vector3d& point : points) {
        double nearest = 1e9;
        for (const Recorder::Frame& frame : outing.recorder.frames()) {
            const Vector3d way = frame.avatar.position - point;
            nearest = std::min(nearest, std::sqrt(way.x() * way.x() + way.z() * way.z()));
        }
        EXPECT_LT(nearest, 0.05);
    }
    // No slower than its pace, but for the chords of the curve.
    EXPECT_NEAR(outing.summary.distance, 1.4 * static_cast<double>(outing.summary.ticks) / 60.0, 0.05);
    EXPECT_GT(outing.summary.distance, 4.0 * std::sqrt(18.0)) << "longer than the straight lines";
}

TEST(Follow, TurnsWithoutCorners) {
    const Outing outing =
        run(level_campus(), walk_of({spawn_at({0, 0, 0}), follow({{0, 0, -3}, {3, 0, -3}, {3, 0, 0}})}));
    const auto& frames = outing.recorder.frames();
    for (std::size_t i = 2; i + 2 < frames.size(); ++i) {  // the last frame is the closing one
        const Vector3d before = frames[i].avatar.position - frames[i - 1].avatar.position;
        const Vector3d after = frames[i + 1].avatar.position - frames[i].avatar.position;
        ASSERT_GT(before.dot(after) / (before.norm() * after.norm()), 0.99) << "tick " << i;
    }
}

TEST(Follow, GivesUpAtAWallLikeAWalk) {
    scene::Campus campus = level_campus();
    add_box(campus, "wall", {-20, 0, -4}, {20, 3, -3});
    FollowStep step = follow({{1, 0, -2}, {0, 0, -8}});
    step.mark = {"a.walk.yaml", 5, 3};
    const Outing outing = run(campus, walk_of({spawn_at({0, 0, 0}), step}));
    ASSERT_EQ(outing.summary.failures.size(), 1U);
    EXPECT_EQ(outing.summary.failures[0].message, "follow goal was not reached: blocked by wall");
    EXPECT_EQ(outing.summary.failures[0].mark.line, 5);
    step.if_blocked = IfBlocked::proceed;
    EXPECT_TRUE(run(campus, walk_of({spawn_at({0, 0, 0}), step})).summary.passed);
}

TEST(Follow, ReturnsToItsCurveBehindAPole) {
    scene::Campus campus = level_campus();
    add_box(campus, "pole", {0.02, 0, -3.1}, {0.12, 3, -3});
    const Outing outing = run(campus, walk_of({spawn_at({0, 0, 0}), follow({{0, 0, -3}, {0, 0, -8}})}));
    EXPECT_TRUE(outing.summary.passed);
    EXPECT_EQ(outing.recorder.of("collision.enter pole").size(), 1U);
    EXPECT_NEAR(outing.recorder.frames().back().avatar.position.x(), 0.0, 0.06);
}

}  // namespace
}  // namespace campuswalk::engine

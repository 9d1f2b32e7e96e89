#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"

namespace campuswalk::engine {
namespace {

using Eigen::Vector3d;

constexpr double kFreeFall = 9.81;
constexpr double kFallerRadius = 0.3;
constexpr double kFallerTick = 1.4 / 60.0;

/// The height of a body `ticks` after it began to fall from `height`.
double fallen(double height, Tick ticks, int ticks_per_second = 60) {
    const double t = static_cast<double>(ticks) / ticks_per_second;
    return height - 0.5 * kFreeFall * t * t;
}

TEST(Falls, FollowAParabolaAtEveryTickRate) {
    for (const int rate : {30, 60, 120}) {
        Walk walk = walk_of({spawn_at({0, 5, 0}), wait_for(2.0)});
        walk.sim.ticks_per_second = rate;
        const RecordedRun result = run(level_campus(), walk);
        const auto landing = static_cast<Tick>(std::ceil(std::sqrt(2.0 * 5.0 / kFreeFall) * rate));
        for (Tick tick = 0; tick < landing; ++tick) {
            const AvatarState& avatar = result.recorder.at(tick);
            ASSERT_NEAR(avatar.position.y(), fallen(5.0, tick, rate), 1e-9) << rate << " tps, tick " << tick;
            ASSERT_FALSE(avatar.grounded);
            ASSERT_NEAR(avatar.vertical_speed, -kFreeFall * static_cast<double>(tick) / rate, 1e-9);
        }
        const AvatarState& landed = result.recorder.at(landing);
        EXPECT_TRUE(landed.grounded);
        EXPECT_NEAR(landed.position.y(), 0.0, 1e-3);
        EXPECT_EQ(landed.vertical_speed, 0.0);
        const auto lands = result.recorder.events("avatar.landed stroll");
        ASSERT_EQ(lands.size(), 1U);
        EXPECT_EQ(lands[0].tick, landing);
        EXPECT_NEAR(field<Decimal>(lands[0], "height").value, 5.0, 1e-3);
        EXPECT_NEAR(field<Vector3d>(lands[0], "pos").y(), 0.0, 1e-3);
    }
}

TEST(Falls, PastAPlaceDoNotArriveThere) {
    scene::Campus campus = level_campus();
    add_box(campus, "terrace", {-5, 0, -1}, {5, 3, 5});
    WalkToStep step = walk_to(0, -1.7);
    step.target = {"balcony", {0, 3, -1.42}, true};
    const RecordedRun high = run(campus, walk_of({spawn_at({0, 3, 0}), step}));
    EXPECT_TRUE(high.recorder.events("avatar.arrive").empty());
    EXPECT_EQ(high.recorder.events("avatar.blocked balcony").size(), 1U);
    const RecordedRun low = run(campus, walk_of({spawn_at({0, 3, 0}), walk_to(0, -1.7)}));
    const auto arrival = low.recorder.events("avatar.arrive");
    ASSERT_EQ(arrival.size(), 1U);
    EXPECT_NEAR(field<Vector3d>(arrival[0], "pos").y(), 0.0, 1e-3) << "at any height, but on its feet";
}

TEST(Falls, OffALedgeAreLoggedWithTheirHeight) {
    scene::Campus campus = level_campus();
    add_box(campus, "terrace", {-5, 0, -1}, {5, 3, 5});
    const RecordedRun result = run(campus, walk_of({spawn_at({0, 3, 0}), walk_to(0, -4)}));
    const auto lands = result.recorder.events("avatar.landed");
    ASSERT_EQ(lands.size(), 1U);
    // The capsule rolls over the edge until its centre is a radius beyond; from there it falls.
    const double beyond = std::floor((1.0 + kFallerRadius) / kFallerTick) * kFallerTick - 1.0;
    const double rolled = kFallerRadius - std::sqrt(kFallerRadius * kFallerRadius - beyond * beyond);
    EXPECT_NEAR(field<Decimal>(lands[0], "height").value, 3.0 - rolled, 2e-3);
    const auto last_supported = static_cast<Tick>(std::floor((1.0 + kFallerRadius) / kFallerTick));
    EXPECT_TRUE(result.recorder.at(last_supported).grounded);
    EXPECT_FALSE(result.recorder.at(last_supported + 1).grounded);
    const double fall = std::sqrt(2.0 * (3.0 - rolled) / kFreeFall) * 60.0;
    EXPECT_NEAR(static_cast<double>(lands[0].tick - last_supported), fall, 2.0);
    EXPECT_EQ(result.recorder.events("avatar.arrive goal").size(), 1U) << "it walks on after the landing";
}

TEST(Falls, OfLessThanHalfAMetreAreNotLogged) {
    // Ledges of 0.6 m and more are too high to step down; the first 0.2014 m it rolls, as computed above.
    const auto lands_from = [](double ledge) {
        scene::Campus campus = level_campus();
        add_box(campus, "step", {-5, 0, -1}, {5, ledge, 5});
        const RecordedRun result = run(campus, walk_of({spawn_at({0, ledge, 0}), walk_to(0, -4)}));
        EXPECT_TRUE(result.summary.passed);
        EXPECT_TRUE(std::ranges::any_of(result.recorder.states(), [](const Recorder::TickState& state) {
            return !state.avatar.grounded;
        }));
        return result.recorder.events("avatar.landed").size();
    };
    EXPECT_EQ(lands_from(0.69), 0U);
    EXPECT_EQ(lands_from(0.71), 1U);
}

TEST(Falls, OffTheWorldEndTheWalk) {
    Walk walk = walk_of({spawn_at({0, 0, 0}), teleport_to({20, 0, 0}), wait_for(60.0), snapshot("never")});
    std::get<WaitStep>(walk.steps[2]).mark = {"fall.walk.yaml", 7, 5};
    const RecordedRun result = run(level_campus(5.0), walk);
    const auto fell = result.recorder.events("avatar.fell stroll");
    ASSERT_EQ(fell.size(), 1U);
    // Ten metres below the lowest object; the fall begins in tick 1.
    const auto tick = 1 + static_cast<Tick>(std::ceil(std::sqrt(2.0 * 10.0 / kFreeFall) * 60.0));
    EXPECT_EQ(fell[0].tick, tick);
    EXPECT_NEAR(field<Vector3d>(fell[0], "pos").y(), fallen(0.0, tick - 1), 1e-9);
    EXPECT_EQ(result.summary.ticks, tick);
    EXPECT_FALSE(result.summary.passed);
    ASSERT_EQ(result.summary.failures.size(), 1U);
    EXPECT_EQ(result.summary.failures[0].code, "fell");
    EXPECT_THAT(result.summary.failures[0].message, testing::HasSubstr("fell"));
    EXPECT_EQ(result.summary.failures[0].mark.file, "fall.walk.yaml");
    EXPECT_EQ(result.summary.failures[0].mark.line, 7) << "of the step during which it fell";
    EXPECT_TRUE(result.recorder.events("snapshot.take").empty());
    EXPECT_EQ(event_line(result.recorder.events().back()), "walk.end stroll");
}

TEST(Falls, OffTheWorldSkipTheRestOfTheScript) {
    // The wait is over in the tick in which the fall ends the walk: 86 ticks after the teleport's.
    const RecordedRun result = run(level_campus(5.0), walk_of({spawn_at({0, 0, 0}), teleport_to({20, 0, 0}),
                                                               wait_for(86.0 / 60.0), snapshot("never")}));
    EXPECT_EQ(
        result.recorder.event_lines(),
        std::vector<std::string>({"avatar.teleport elsewhere", "avatar.fell stroll", "expect.fail fell"}));
}

TEST(Falls, DoNotCountTowardsALandingAfterATeleport) {
    // Falling from 20 m, it is teleported to half a metre above the ground, and so placed on it.
    const RecordedRun result =
        run(level_campus(),
            walk_of({spawn_at({0, 20, 0}), wait_for(0.5), teleport_to({5, 0.5, 0}), wait_for(0.5)}));
    EXPECT_EQ(result.recorder.event_lines(), std::vector<std::string>({"avatar.teleport elsewhere"}));
    EXPECT_TRUE(result.recorder.states().back().avatar.grounded);
    EXPECT_NEAR(result.recorder.states().back().avatar.position.y(), 0.0, 1e-3);
}

}  // namespace
}  // namespace campuswalk::engine

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"

namespace campuswalk::engine {
namespace {

using Eigen::Vector3d;

constexpr double kGravity = 9.81;
constexpr double kRadius = 0.3;
constexpr double kTickLength = 1.4 / 60.0;

/// Where a body that was let go at `height` is after so many ticks.
double fallen(double height, Tick ticks, int ticks_per_second = 60) {
    const double t = static_cast<double>(ticks) / ticks_per_second;
    return height - 0.5 * kGravity * t * t;
}

TEST(Falls, FollowTheParabolaWhateverTheRate) {
    for (const int rate : {30, 60, 120}) {
        Walk walk = walk_of({spawn_at({0, 5, 0}), wait_for(2.0)});
        walk.sim.ticks_per_second = rate;
        const Outing outing = run(level_campus(), walk);
        const auto landing = static_cast<Tick>(std::ceil(std::sqrt(2.0 * 5.0 / kGravity) * rate));
        for (Tick tick = 0; tick < landing; ++tick) {
            const AvatarState& avatar = outing.recorder.at(tick);
            ASSERT_NEAR(avatar.position.y(), fallen(5.0, tick, rate), 1e-9) << rate << " tps, tick " << tick;
            ASSERT_FALSE(avatar.grounded);
            ASSERT_NEAR(avatar.vertical_speed, -kGravity * static_cast<double>(tick) / rate, 1e-9);
        }
        const AvatarState& landed = outing.recorder.at(landing);
        EXPECT_TRUE(landed.grounded);
        EXPECT_NEAR(landed.position.y(), 0.0, 1e-3);
        EXPECT_EQ(landed.vertical_speed, 0.0);
        const auto lands = outing.recorder.of("avatar.landed stroll");
        ASSERT_EQ(lands.size(), 1U);
        EXPECT_EQ(lands[0].tick, landing);
        EXPECT_NEAR(field<Decimal>(lands[0], "height").value, 5.0, 1e-3);
        EXPECT_NEAR(field<Vector3d>(lands[0], "pos").y(), 0.0, 1e-3);
    }
}

TEST(Falls, OffALedgeTellTheirHeight) {
    scene::Campus campus = level_campus();
    add_box(campus, "terrace", {-5, 0, -1}, {5, 3, 5});
    const Outing outing = run(campus, walk_of({spawn_at({0, 3, 0}), walk_to(0, -4)}));
    const auto lands = outing.recorder.of("avatar.landed");
    ASSERT_EQ(lands.size(), 1U);
    // The round foot rolls over the edge until its centre is a radius beyond; from there it falls.
    const double beyond = std::floor((1.0 + kRadius) / kTickLength) * kTickLength - 1.0;
    const double rolled = kRadius - std::sqrt(kRadius * kRadius - beyond * beyond);
    EXPECT_NEAR(field<Decimal>(lands[0], "height").value, 3.0 - rolled, 2e-3);
    const auto last_supported = static_cast<Tick>(std::floor((1.0 + kRadius) / kTickLength));
    EXPECT_TRUE(outing.recorder.at(last_supported).grounded);
    EXPECT_FALSE(outing.recorder.at(last_supported + 1).grounded);
    const double fall = std::sqrt(2.0 * (3.0 - rolled) / kGravity) * 60.0;
    EXPECT_NEAR(static_cast<double>(lands[0].tick - last_supported), fall, 2.0);
    EXPECT_EQ(outing.recorder.of("avatar.arrive goal").size(), 1U) << "it walks on below";
}

TEST(Falls, OfLessThanHalfAMetreAreNotWorthAnEvent) {
    // Of 0.6 m and more the foot can't step down; the first 0.2014 m it rolls, as computed above.
    const auto lands_from = [](double ledge) {
        scene::Campus campus = level_campus();
        add_box(campus, "step", {-5, 0, -1}, {5, ledge, 5});
        const Outing outing = run(campus, walk_of({spawn_at({0, ledge, 0}), walk_to(0, -4)}));
        EXPECT_TRUE(outing.summary.passed);
        EXPECT_TRUE(std::ranges::any_of(outing.recorder.frames(),
                                        [](const Recorder::Frame& frame) { return !frame.avatar.grounded; }));
        return outing.recorder.of("avatar.landed").size();
    };
    EXPECT_EQ(lands_from(0.69), 0U);
    EXPECT_EQ(lands_from(0.71), 1U);
}

TEST(Falls, OffTheWorldEndTheWalk) {
    Walk walk = walk_of({spawn_at({0, 0, 0}), teleport_to({20, 0, 0}), wait_for(60.0), snapshot("never")});
    walk.mark = {"fall.walk.yaml", 0, 0};
    const Outing outing = run(level_campus(5.0), walk);
    const auto fell = outing.recorder.of("avatar.fell stroll");
    ASSERT_EQ(fell.size(), 1U);
    // Ten metres below everything there is; it is let go in tick 1.
    const auto tick = 1 + static_cast<Tick>(std::ceil(std::sqrt(2.0 * 10.0 / kGravity) * 60.0));
    EXPECT_EQ(fell[0].tick, tick);
    EXPECT_NEAR(field<Vector3d>(fell[0], "pos").y(), fallen(0.0, tick - 1), 1e-9);
    EXPECT_EQ(outing.summary.ticks, tick);
    EXPECT_FALSE(outing.summary.passed);
    ASSERT_EQ(outing.summary.failures.size(), 1U);
    EXPECT_EQ(outing.summary.failures[0].code, "fell");
    EXPECT_EQ(outing.summary.failures[0].message, "the avatar fell off the world");
    EXPECT_EQ(outing.summary.failures[0].mark.file, "fall.walk.yaml");
    EXPECT_TRUE(outing.recorder.of("snapshot.take").empty());
    EXPECT_EQ(told(outing.recorder.events().back()), "walk.end stroll");
}

TEST(Falls, OffTheWorldLeaveTheRestOfTheScriptUnplayed) {
    // The wait is over in the tick in which the fall ends the walk: 86 ticks after the teleport's.
    const Outing outing = run(level_campus(5.0), walk_of({spawn_at({0, 0, 0}), teleport_to({20, 0, 0}),
                                                          wait_for(86.0 / 60.0), snapshot("never")}));
    EXPECT_EQ(outing.recorder.story(), std::vector<std::string>({"avatar.teleport elsewhere",
                                                                 "avatar.fell stroll", "expect.fail fell"}));
}

TEST(Falls, DoNotCountTowardsATeleportsLanding) {
    // Falling from 20 m, it is put half a metre above the ground: on it.
    const Outing outing =
        run(level_campus(),
            walk_of({spawn_at({0, 20, 0}), wait_for(0.5), teleport_to({5, 0.5, 0}), wait_for(0.5)}));
    EXPECT_EQ(outing.recorder.story(), std::vector<std::string>({"avatar.teleport elsewhere"}));
    EXPECT_TRUE(outing.recorder.frames().back().avatar.grounded);
    EXPECT_NEAR(outing.recorder.frames().back().avatar.position.y(), 0.0, 1e-3);
}

}  // namespace
}  // namespace campuswalk::engine

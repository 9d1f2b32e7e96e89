#include "engine/script/player.h"

#include <gtest/gtest.h>

#include "tests/engine/short_walk.h"

namespace campuswalk::engine {
namespace {

constexpr double kArrivalSeconds = 0.05 / 1.4;  // a walk_to ends 5 cm, and so this much, early

Walk of(std::vector<Step> steps) {
    Walk walk;
    walk.steps = std::move(steps);
    return walk;
}

TEST(PlannedSeconds, AddUpWalksTurnsAndWaits) {
    EXPECT_DOUBLE_EQ(*planned_seconds(of({spawn_at({3, 1, 4})})), 0.0);
    EXPECT_NEAR(*planned_seconds(of({spawn_at({3, 1, 4}), walk_to(3, -10), wait_for(2.5)})),
                10.0 - kArrivalSeconds + 2.5, 1e-9);
    // At half a turn per second: from -Z to the left, then to the goal behind.
    EXPECT_NEAR(*planned_seconds(of({spawn_at({0, 0, 0}), turn_by(90), turn_to(180)})), 0.5 + 0.5, 1e-9);
    EXPECT_NEAR(*planned_seconds(of({spawn_at({0, 0, 0}), look_at({"x", {0, 0, 5}, false})})), 1.0, 1e-9);
}

TEST(PlannedSeconds, ContinueFromTheEndOfEachStep) {
    EXPECT_NEAR(
        *planned_seconds(of({spawn_at({0, 0, 0}), walk_to(7, 0), teleport_to({7, 3, 14}), walk_to(7, 0)})),
        5.0 + 10.0 - 2 * kArrivalSeconds, 1e-9);
    // The avatar walked along +X and still looks there, so looking at (9, 0) takes no time.
    EXPECT_NEAR(*planned_seconds(of({spawn_at({0, 0, 0}), walk_to(7, 0), look_at({"x", {9, 0, 0}, false})})),
                5.0 - kArrivalSeconds, 1e-9);
}

TEST(PlannedSeconds, DependOnSpeedCurvesAndJumps) {
    EXPECT_NEAR(*planned_seconds(of({spawn_at({0, 0, 0}), set_speed(2.0), walk_to(0, -20.05)})), 10.0, 1e-9);
    EXPECT_NEAR(
        *planned_seconds(of({spawn_at({0, 0, 0}), set_speed(2.0), follow({{0, 0, -10}, {0, 0, -20.05}})})),
        10.0, 1e-6);
    EXPECT_NEAR(*planned_seconds(of({spawn_at({0, 0, 0}), jump_up(4.905)})), 1.0, 1e-9);
}

TEST(PlannedSeconds, AreUnknownIfTheWalkWaitsForAnEvent) {
    EXPECT_FALSE(planned_seconds(of({spawn_at({0, 0, 0}), wait_until("popup.open hall"), walk_to(7, 0)})));
}

}  // namespace
}  // namespace campuswalk::engine

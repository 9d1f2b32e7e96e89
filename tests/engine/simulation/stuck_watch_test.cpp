#include "engine/simulation/stuck_watch.h"

#include <vector>

#include <gtest/gtest.h>

#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"

namespace campuswalk::engine {
namespace {

using Eigen::Vector3d;

constexpr int kRate = 60;
constexpr double kTick = 1.4 / kRate;

/// The ticks, from 1, in which an avatar is reported as stuck if it tries to move by `desired` in every tick
/// and is at x_of(tick).
template <typename Place>
std::vector<int> stuck_ticks(double desired, int ticks, Place&& x_of) {
    StuckWatch watch(kRate);
    std::vector<int> stuck;
    for (int tick = 1; tick <= ticks; ++tick) {
        if (watch.update(Vector3d(x_of(tick), 0, 0), desired)) {
            stuck.push_back(tick);
        }
    }
    return stuck;
}

using Ticks = std::vector<int>;

TEST(StuckWatch, ReportsOnceAfterASecondInOnePlace) {
    EXPECT_EQ(stuck_ticks(kTick, 500, [](int) { return 3.0; }), Ticks({61}));
}

TEST(StuckWatch, ReportsTremblingInPlaceToo) {
    EXPECT_EQ(stuck_ticks(kTick, 500, [](int tick) { return tick % 2 == 0 ? 0.04 : -0.04; }), Ticks({61}));
}

TEST(StuckWatch, DoesNotReportProgress) {
    EXPECT_EQ(stuck_ticks(kTick, 500, [](int tick) { return 0.002 * tick; }), Ticks()) << "12 cm/s";
    EXPECT_EQ(stuck_ticks(kTick, 500, [](int tick) { return 0.00101 * tick; }),
              Ticks({61, 161, 261, 361, 461}))
        << "6 cm/s: free again every 10 cm";
    EXPECT_EQ(stuck_ticks(0.01 / kRate, 500, [](int tick) { return 0.01 / kRate * tick; }), Ticks())
        << "a slow avatar at full speed";
}

TEST(StuckWatch, DoesNotReportStandingStill) {
    EXPECT_EQ(stuck_ticks(0.0, 500, [](int) { return 3.0; }), Ticks());
    EXPECT_EQ(stuck_ticks(1e-9, 500, [](int) { return 3.0; }), Ticks()) << "hovering at its target";
}

TEST(StuckWatch, ReportsAgainAfterTheAvatarCameFree) {
    EXPECT_EQ(stuck_ticks(kTick, 300, [](int tick) { return tick < 100 ? 0.0 : 1.0; }), Ticks({61, 160}));
}

// ---- in a walk ------------------------------------------------------------------------------------------

TEST(StuckEvent, NamesPlaceAndObstacleBeforeTheWalkGivesUp) {
    scene::Campus campus = level_campus();
    add_box(campus, "wall", {-5, 0, -3}, {5, 3, -2});
    const RecordedRun result = run(campus, walk_of({spawn_at({0, 0, 0}), walk_to(0, -9)}));
    const auto stuck = result.recorder.events("avatar.stuck stroll");
    ASSERT_EQ(stuck.size(), 1U);
    EXPECT_EQ(field<std::string>(stuck[0], "by"), "wall");
    EXPECT_NEAR(field<Vector3d>(stuck[0], "pos").z(), -1.68, 0.01);
    EXPECT_LT(stuck[0].tick, result.recorder.events("avatar.blocked").at(0).tick);
}

TEST(StuckEvent, DoesNotOccurWhileSlidingAlongAWall) {
    scene::Campus campus = level_campus();
    add_box(campus, "wall", {-50, 0, -3}, {50, 3, -2});
    WalkToStep step = walk_to(12, -3);
    step.if_blocked = IfBlocked::proceed;
    const RecordedRun result = run(campus, walk_of({spawn_at({0, 0, -1.5}), step}));
    EXPECT_GT(result.recorder.states().back().avatar.position.x(), 11.5);
    for (const Event& stuck : result.recorder.events("avatar.stuck")) {
        EXPECT_GT(field<Vector3d>(stuck, "pos").x(), 11.5) << "at the end, in front of its target";
    }
}

TEST(StuckEvent, DoesNotOccurWhileWaiting) {
    EXPECT_TRUE(run(level_campus(), walk_of({spawn_at({0, 0, 0}), wait_for(5.0), turn_by(700)}))
                    .recorder.events("avatar.stuck")
                    .empty());
}

}  // namespace
}  // namespace campuswalk::engine

// What keeps a body from ground that lies behind long passages, thick walls and high ramps: the numbers are
// those that the campuses were built with.

#include "engine/walkspace/barrier/island_barriers.h"

#include <cmath>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "collision/mesh/mesh_collider.h"
#include "tests/engine/small_campus.h"
#include "tests/engine/walkspace/barrier/explored_barrier.h"
#include "tests/support/mesh_pieces.h"

namespace campuswalk::engine {
namespace {

using collision::Vec3;

/// South of z = 0 is open ground; north of it a yard behind walls of 4 m, the south one `thick`, with a gap
/// of `gap` at x = 0 whose roof is `headroom` above the ground.
scene::Campus yard_behind(double thick, double gap, double headroom) {
    scene::Campus campus = level_campus(20.0);
    add_box(campus, "south-west", {-6, 0, -thick}, {-0.5 * gap, 4, 0});
    add_box(campus, "south-east", {0.5 * gap, 0, -thick}, {6, 4, 0});
    add_box(campus, "lintel", {-0.5 * gap, headroom, -thick}, {0.5 * gap, 4, 0});
    add_box(campus, "west", {-6, 0, -thick - 6}, {-5.8, 4, -thick});
    add_box(campus, "east", {5.8, 0, -thick - 6}, {6, 4, -thick});
    add_box(campus, "north", {-6, 0, -thick - 6.2}, {6, 4, -thick - 6});
    return campus;
}

/// A block of this height, with a ramp up to it that begins at z = 0, of `degrees`, and as wide as it.
scene::Campus block_with_ramp(double height, double degrees) {
    scene::Campus campus = level_campus(20.0);
    const double length = height / std::tan(degrees * std::numbers::pi / 180.0);
    collision::TriangleMesh ramp;
    const Vec3 low_left(-1, 0, 0);
    const Vec3 low_right(1, 0, 0);
    const Vec3 high_left(-1, height, -length);
    const Vec3 high_right(1, height, -length);
    support::add_quad(ramp, low_left, low_right, high_right, high_left);
    support::add_triangle(ramp, low_left, high_left, {-1, 0, -length});
    support::add_triangle(ramp, low_right, {1, 0, -length}, high_right);
    support::add_box(ramp, {-3, 0, -length - 5}, {3, height, -length});
    add_object(campus, "ramp", std::make_shared<const collision::MeshCollider>(std::move(ramp)),
               Vec3::Zero());
    return campus;
}

class ThickWall : public testing::TestWithParam<double> {
protected:
    Vec3 behind() const { return {3.0, 0.0, -GetParam() - 3.0}; }
};

INSTANTIATE_TEST_SUITE_P(IslandBarriers, ThickWall, testing::Values(0.2, 1.0, 1.5, 2.0, 3.0, 5.0));

TEST_P(ThickWall, TheGapInItIsMeasured) {
    scene::Campus campus = yard_behind(GetParam(), 0.55, 4.0);
    const Barrier barrier = explored_barrier(campus, behind());
    EXPECT_EQ(barrier.kind, ReasonKind::opening);
    EXPECT_NEAR(barrier.measured, 0.55, 0.01);
    EXPECT_THAT(reason_to_go(campus, behind()), testing::HasSubstr("is 0.55 m wide, the body needs 0.60 m"));
}

TEST_P(ThickWall, TheHeadroomInItIsMeasured) {
    scene::Campus campus = yard_behind(GetParam(), 1.2, 1.62);
    const Barrier barrier = explored_barrier(campus, behind());
    EXPECT_EQ(barrier.kind, ReasonKind::headroom);
    EXPECT_NEAR(barrier.measured, 1.62, 0.01);
    EXPECT_THAT(reason_to_go(campus, behind()), testing::HasSubstr("headroom of 1.62 m under lintel"));
}

TEST_P(ThickWall, WhatStandsInItsGapIsNamed) {
    scene::Campus campus = yard_behind(GetParam(), 1.2, 4.0);
    add_box(campus, "truck", {-0.4, 0, -GetParam() + 0.05}, {0.4, 3, -0.05});
    const Barrier barrier = explored_barrier(campus, behind());
    ASSERT_TRUE(barrier.object);
    EXPECT_EQ(campus.objects[index_of(*barrier.object)].id, "truck");
    EXPECT_THAT(reason_to_go(campus, behind()), testing::HasSubstr("truck stands in the way"));
}

class SteepRamp : public testing::TestWithParam<double> {};

INSTANTIATE_TEST_SUITE_P(IslandBarriers, SteepRamp, testing::Values(1.0, 2.0, 3.0, 4.0, 6.0));

TEST_P(SteepRamp, ItsSlopeIsMeasuredThoughItsTopIsHigherThanAnyLedgeThatIsClimbed) {
    scene::Campus campus = block_with_ramp(GetParam(), 52.0);
    const Vec3 top(0.0, GetParam(), -GetParam() / std::tan(52.0 * std::numbers::pi / 180.0) - 3.0);
    const Barrier barrier = explored_barrier(campus, top);
    EXPECT_EQ(barrier.kind, ReasonKind::slope);
    EXPECT_NEAR(barrier.measured * 180.0 / std::numbers::pi, 52.0, 0.1);
    EXPECT_THAT(reason_to_go(campus, top), testing::HasSubstr("slope of 52.0 degrees at ramp"));
}

/// A platform whose edge is 4 m from that of the ground: not a roof, but ground that lies apart.
TEST(IslandBarriers, GroundThatLiesApartIsBehindAGap) {
    for (const double height : {-0.5, 0.0, 0.5}) {
        scene::Campus campus = level_campus(20.0);
        add_box(campus, "platform", {-5, -1, -40}, {5, height, -24});
        const Barrier barrier = explored_barrier(campus, {0, height, -30});
        ASSERT_EQ(barrier.kind, ReasonKind::gap) << height;
        EXPECT_NEAR(barrier.measured, 4.0, 0.6) << "from cell to cell";
    }
}

TEST(IslandBarriers, AMissingStripOfTheFloorIsAGap) {
    for (const double apart : {1.0, 1.4, 1.8, 2.2}) {
        scene::Campus campus = level_campus(20.0);
        add_box(campus, "floor", {-5, -1, -40}, {5, 0, -20.0 - apart});
        const Barrier barrier = explored_barrier(campus, {0, 0, -30});
        ASSERT_EQ(barrier.kind, ReasonKind::gap) << apart;
        EXPECT_NEAR(barrier.measured, apart, 0.3) << "from cell to cell";
    }
}

/// Neither a roof nor what is behind a wall.
TEST(IslandBarriers, AWallOrAnotherLevelIsNoGap) {
    scene::Campus campus = level_campus(20.0);
    add_box(campus, "roof", {-5, 4, -40}, {5, 5, -24});
    EXPECT_NE(explored_barrier(campus, {0, 5, -30}).kind, ReasonKind::gap);
    scene::Campus walled = level_campus(20.0);
    add_box(walled, "platform", {-5, -1, -40}, {5, 0, -24});
    add_box(walled, "wall", {-20, 0, -22}, {20, 4, -21.8});
    EXPECT_NE(explored_barrier(walled, {0, 0, -30}).kind, ReasonKind::gap);
}

/// The way straight to the place leads over the block's front; the stairs are behind it.
TEST(IslandBarriers, GoToNamesTheSmallestChangeAndNotTheOneNearestToTheStraightLine) {
    scene::Campus campus = level_campus(20.0);
    add_box(campus, "block", {-3, 0, -9}, {3, 2.0, -3});
    for (int i = 0; i < 6; ++i) {
        add_box(campus, "step-" + std::to_string(i + 1), {-1, 0, -12.5 + 0.5 * i},
                {1, 0.45 + 1.55 / 6.0 * i, -9});
    }
    EXPECT_THAT(reason_to_go(campus, {0, 2.0, -4}), testing::HasSubstr("riser of 0.45 m at step-1"));
}

}  // namespace
}  // namespace campuswalk::engine

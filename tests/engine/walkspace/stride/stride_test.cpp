#include "engine/walkspace/stride/stride.h"

#include <array>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "tests/engine/small_campus.h"
#include "tests/engine/walkspace/explore/explored_ground.h"
#include "tests/support/mesh_pieces.h"

namespace campuswalk::engine {
namespace {

using collision::TriangleMesh;
using collision::Vec3;
using Kind = StrideEnd::Kind;

constexpr std::uint8_t kEast = 0;
constexpr std::uint8_t kSouth = 1;
constexpr WalkGrid kGrid;

void add_nothing(TriangleMesh&) {}

/// A floor of 20 m by 20 m with what `add` adds to it.
template <typename Add>
scene::Campus floor_with(const Add& add) {
    TriangleMesh mesh;
    support::add_floor(mesh, 10.0);
    add(mesh);
    return campus_of(std::move(mesh));
}

/// A body on it.
struct StrideOn {
    template <typename Add>
    explicit StrideOn(const Add& add) : campus(floor_with(add)), strider(campus.world, strides_of(), {}) {}

    /// Where a body put down there stands.
    GroundState state_at(const Vec3& foot) { return strider.put_down(foot).at; }

    scene::Campus campus;
    Strider strider;
};

TEST(Strider, WalksToTheNextCellInEachDirection) {
    StrideOn floor(add_nothing);
    const GroundState start = floor.state_at({0.1, 0.0, -0.1});
    const GridCell cell = kGrid.cell_at(start.foot);
    for (std::uint8_t i = 0; i < 8; ++i) {
        const StrideEnd end = floor.strider.take(start, {.direction = i}, kGrid);
        const GridDirection& direction = grid_directions()[i];
        const GridCell next{cell.x + direction.x, cell.z + direction.z};
        EXPECT_EQ(end.kind, Kind::grounded);
        EXPECT_EQ(kGrid.cell_at(end.at.foot), next);
        // Not across its own direction, and to the middle within half a tick's way.
        EXPECT_NEAR((kGrid.center(next) - end.at.foot).dot(direction.unit), 0.0, 0.5 * 1.4 / 60.0 + 1e-9);
        EXPECT_TRUE(end.clean);
        EXPECT_FALSE(end.left_ground);
        EXPECT_EQ(static_cast<std::size_t>(end.ticks), floor.strider.path().size());
        EXPECT_EQ(floor.strider.path().back(), end.at.foot);
    }
}

TEST(Strider, TakesTheSameStrideAgain) {
    StrideOn floor([](TriangleMesh& mesh) { support::add_box(mesh, {0.5, 0, -2}, {1, 2, 2}); });
    const GroundState start = floor.state_at({0.1, 0.0, 0.1});
    const StrideEnd first = floor.strider.take(start, {.direction = 4}, kGrid);
    floor.strider.take(start, {.direction = kEast}, kGrid);
    floor.state_at({-3, 0, 3});
    const StrideEnd again = floor.strider.take(start, {.direction = 4}, kGrid);
    EXPECT_EQ(first.at, again.at) << "whatever came in between";
    EXPECT_EQ(first.ticks, again.ticks);
}

TEST(Strider, StopsAtAWall) {
    StrideOn floor([](TriangleMesh& mesh) { support::add_box(mesh, {0.5, 0, -2}, {1, 2, 2}); });
    const GroundState start = floor.state_at({0.15, 0.0, 0.1});
    const StrideEnd end = floor.strider.take(start, {.direction = kEast}, kGrid);
    EXPECT_EQ(end.kind, Kind::grounded);
    EXPECT_LE(end.at.foot.x(), 0.5 - 0.3);
    EXPECT_FALSE(end.clean);
    EXPECT_LT(end.ticks, 10) << "it doesn't go on pushing";
    EXPECT_TRUE(floor.strider.touched().front());
}

TEST(Strider, DoesNotCallASlideAlongAWallClean) {
    StrideOn floor([](TriangleMesh& mesh) { support::add_box(mesh, {0.5, 0, -2}, {1, 2, 2}); });
    const GroundState start = floor.state_at({0.15, 0.0, 0.1});
    const StrideEnd end = floor.strider.take(start, {.direction = 4}, kGrid);
    EXPECT_GT(end.at.foot.z(), start.foot.z() + 0.1);
    EXPECT_FALSE(end.clean);
}

TEST(Strider, GivesUpAtAWallOnceItIsNotWorthIt) {
    StrideOn floor([](TriangleMesh& mesh) { support::add_box(mesh, {0.5, 0, -2}, {1, 2, 2}); });
    const GroundState start = floor.state_at({0.15, 0.0, 0.1});
    const StrideEnd whole = floor.strider.take(start, {.direction = 4}, kGrid);
    const auto until = [&](double least) {
        return floor.strider.take(start, {.direction = 4}, kGrid,
                                  [&](const GroundState&, double metres) { return metres > least; });
    };
    EXPECT_FALSE(whole.given_up);
    EXPECT_EQ(until(0.0).at, whole.at);
    const StrideEnd half = until(0.1);
    EXPECT_TRUE(half.given_up);
    EXPECT_EQ(half.kind, Kind::grounded);
    EXPECT_NEAR((whole.ticks - half.ticks) * 1.4 / 60.0, 0.1, 1.4 / 60.0);
    const GroundState away = floor.state_at({-1.9, 0.0, 0.1});
    const StrideEnd free =
        floor.strider.take(away, {.direction = 4}, kGrid, [](const GroundState&, double) { return false; });
    EXPECT_FALSE(free.given_up) << "nothing is in the way";
    EXPECT_EQ(free.at, floor.strider.take(away, {.direction = 4}, kGrid).at);
}

TEST(Strider, DoesNotCallAStepClean) {
    StrideOn floor([](TriangleMesh& mesh) { support::add_box(mesh, {0.5, 0, -2}, {3, 0.2, 2}); });
    GroundState at = floor.state_at({-0.1, 0.0, 0.1});
    bool clean = true;
    for (int i = 0; i < 5; ++i) {
        const StrideEnd end = floor.strider.take(at, {.direction = kEast}, kGrid);
        clean = clean && end.clean;
        at = end.at;
    }
    EXPECT_NEAR(at.foot.y(), 0.2, 1e-3);
    EXPECT_FALSE(clean);
}

/// Of a box 3 m high that ends at x = 0.
GroundState on_the_rim(StrideOn& floor) {
    const GroundState before = floor.state_at({-0.1, 3.0, 0.1});
    return floor.strider.take(before, {.direction = kEast}, kGrid).at;
}

TEST(Strider, TellsWhetherABodyHangsOverAnEdge) {
    StrideOn floor([](TriangleMesh& mesh) {
        support::add_box(mesh, {-2, 0, -2}, {0, 3, 2});
        support::add_quad(mesh, {4, 0, 2}, {6, 2, 2}, {6, 2, -2}, {4, 0, -2});
    });
    EXPECT_FALSE(floor.strider.hangs(floor.state_at({-5, 0, 0}))) << "level ground";
    EXPECT_FALSE(floor.strider.hangs(floor.state_at({5, 1.2, 0}))) << "a slope of 45 degrees";
    EXPECT_FALSE(floor.strider.hangs(floor.state_at({-0.1, 3, 0})));
    GroundState at = on_the_rim(floor);
    EXPECT_GT(at.foot.x(), 0.1);
    EXPECT_FALSE(floor.strider.hangs(at)) << "a little over the rim";
    at = floor.strider.walk_to(at, {0.28, 3, 0.1}, 0.005, 1.0).at;
    EXPECT_LT(at.foot.y(), 2.9);
    EXPECT_TRUE(floor.strider.hangs(at));
}

/// All ways to steer one fall, one after another: what they have in common is played once.
TEST(Strider, SteersAFallAlikeWhateverCameBefore) {
    StrideOn floor([](TriangleMesh& mesh) {
        support::add_box(mesh, {-2, 0, -2}, {0, 3, 2});
        support::add_box(mesh, {0.9, 0, -2}, {1.2, 1.9, 2});
    });
    const GroundState start = on_the_rim(floor);
    const std::uint64_t before = floor.strider.ticks();
    std::uint64_t all = 0;
    for (const std::uint8_t after : std::array<std::uint8_t, 4>{2, 0, 1, 3}) {
        for (std::uint8_t steering = 0; steering <= Stride::kLetGo; ++steering) {
            const Stride stride{.direction = kEast, .steering = steering, .steers_after = after};
            const StrideEnd end = floor.strider.take(start, stride, kGrid);
            Strider fresh(floor.campus.world, strides_of(), {});
            const StrideEnd alone = fresh.take(start, stride, kGrid);
            EXPECT_EQ(end.at, alone.at);
            EXPECT_EQ(end.edge, alone.edge);
            EXPECT_EQ(end.ticks, alone.ticks);
            EXPECT_EQ(end.ticks_ahead, alone.ticks_ahead);
            EXPECT_EQ(floor.strider.path(), fresh.path());
            all += static_cast<std::uint64_t>(alone.ticks);
        }
    }
    EXPECT_LT(floor.strider.ticks() - before, all * 9 / 10);
}

TEST(Strider, FallsStraightOn) {
    StrideOn floor([](TriangleMesh& mesh) { support::add_box(mesh, {-2, 0, -2}, {0, 3, 2}); });
    const GroundState start = on_the_rim(floor);
    const StrideEnd end = floor.strider.take(start, {.direction = kEast}, kGrid);
    EXPECT_EQ(end.kind, Kind::grounded);
    EXPECT_TRUE(end.left_ground);
    EXPECT_FALSE(end.clean);
    EXPECT_NEAR(end.at.foot.y(), 0.0, 1e-3);
    EXPECT_NEAR(end.edge.y(), 3.0, 0.3) << "on the rim it hangs lower";
    // As far as 1.4 m/s get in the time that a fall of 3 m takes.
    EXPECT_NEAR(end.at.foot.x() - end.edge.x(), 1.4 * std::sqrt(2.0 * 3.0 / 9.81), 0.06);
    EXPECT_NEAR(end.at.foot.z(), start.foot.z(), 1e-9);
}

TEST(Strider, FallsWhereItIsSteered) {
    StrideOn floor([](TriangleMesh& mesh) { support::add_box(mesh, {-2, 0, -2}, {0, 3, 2}); });
    const GroundState start = on_the_rim(floor);
    const StrideEnd down = floor.strider.take(start, {.direction = kEast, .steering = Stride::kLetGo}, kGrid);
    EXPECT_EQ(down.kind, Kind::grounded);
    EXPECT_NEAR(down.at.foot.x(), down.edge.x(), 0.15);
    const StrideEnd late =
        floor.strider.take(start, {.direction = kEast, .steering = Stride::kLetGo, .steers_after = 2}, kGrid);
    EXPECT_NEAR(late.at.foot.x() - down.at.foot.x(), 0.4 * 1.4, 0.03);
    const StrideEnd south = floor.strider.take(start, {.direction = kEast, .steering = kSouth}, kGrid);
    EXPECT_EQ(south.kind, Kind::grounded);
    EXPECT_GT(south.at.foot.z(), 1.0);
    EXPECT_NEAR(south.at.foot.x(), south.edge.x(), 0.15);
}

/// With next to no gravity, one that lets go stays where it left the ground.
TEST(Strider, SoonGivesUpABodyThatIsCaughtInTheAir) {
    StrideOn floor([](TriangleMesh& mesh) { support::add_box(mesh, {-2, 0, -2}, {0, 3, 2}); });
    const GroundState start = on_the_rim(floor);
    StrideSettings floating = strides_of();
    floating.body.gravity = 1e-6;
    Strider strider(floor.campus.world, floating, {});
    const StrideEnd end = strider.take(start, {.direction = kEast, .steering = Stride::kLetGo}, kGrid);
    EXPECT_EQ(end.kind, Kind::falling);
    EXPECT_TRUE(end.left_ground);
    EXPECT_LT(end.ticks, 120) << "rather than 1,800, which is half a minute";
}

TEST(Strider, JumpsAheadAtTheSpeedOfItsRun) {
    StrideOn floor(add_nothing);
    const GroundState start = floor.state_at({0.1, 0.0, 0.1});
    const StrideEnd end = floor.strider.take(start, {.direction = kEast, .gait = Gait::jump}, kGrid);
    EXPECT_EQ(end.kind, Kind::grounded);
    EXPECT_TRUE(end.left_ground);
    // In the air for 2 v / g.
    EXPECT_NEAR(end.at.foot.x() - start.foot.x(), 2.8 * 2.0 * 2.8 / 9.81, 0.1);
}

TEST(Strider, FallsOutOfTheWorld) {
    StrideOn floor(add_nothing);
    const GroundState start = floor.state_at({9.9, 0.0, 0.1});
    GroundState at = start;
    StrideEnd end;
    for (int i = 0; i < 3 && end.kind == Kind::grounded; ++i) {
        end = floor.strider.take(at, {.direction = kEast}, kGrid);
        at = end.at;
    }
    EXPECT_EQ(end.kind, Kind::gone);
    EXPECT_NEAR(end.edge.x(), 10.0, 0.3);
}

TEST(Strider, WalksToAPoint) {
    StrideOn floor([](TriangleMesh& mesh) { support::add_box(mesh, {3, 0, -9}, {4, 2, 9}); });
    const GroundState start = floor.state_at({0.1, 0.0, 0.1});
    const StrideEnd end = floor.strider.walk_to(start, {2, 0, 1}, 0.02, 5.0);
    EXPECT_LE(collision::horizontal_norm(end.at.foot - Vec3(2, 0, 1)), 0.02);
    const StrideEnd late = floor.strider.walk_to(start, {2, 0, 1}, 0.02, 0.5);
    EXPECT_EQ(late.ticks, 30);
    const StrideEnd blocked = floor.strider.walk_to(start, {6, 0, 0.1}, 0.02, 60.0);
    EXPECT_LT(blocked.at.foot.x(), 3.0);
    EXPECT_LT(blocked.ticks, 600) << "ends at a standstill";
}

TEST(Strider, WalksOverTheEdgeOfTheLowestGround) {
    StrideOn floor(add_nothing);
    const StrideEnd end = floor.strider.walk_to(floor.state_at({9.5, 0, 0.1}), {12, 0, 0.1}, 0.02, 60.0);
    EXPECT_EQ(end.kind, Kind::gone)
        << "though it is lower than all ground while it still hangs over the edge";
    EXPECT_TRUE(end.left_ground);
}

TEST(Strider, PutsDownWhereThereIsRoomAndGround) {
    StrideOn floor([](TriangleMesh& mesh) { support::add_box(mesh, {3, 0, -9}, {9, 5, 9}); });
    const StrideEnd dropped = floor.strider.put_down({0, 4, 0});
    EXPECT_EQ(dropped.kind, Kind::grounded);
    EXPECT_NEAR(dropped.at.foot.y(), 0.0, 1e-3);
    EXPECT_EQ(floor.strider.put_down({6, 1, 0}).kind, Kind::gone) << "inside a solid";
    EXPECT_EQ(floor.strider.put_down({-20, 1, 0}).kind, Kind::gone) << "beside the world";
}

}  // namespace
}  // namespace campuswalk::engine

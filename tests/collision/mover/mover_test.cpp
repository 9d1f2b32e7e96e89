#include "collision/mover/mover.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/collision/mover/audited_body.h"
#include "tests/support/angles.h"
#include "tests/support/effort.h"
#include "tests/support/mesh_pieces.h"

/// Walls. Ground, steps and falls are in mover_ground_test.cpp.
namespace campuswalk::collision {
namespace {

using support::add_object;
using support::add_quad;
using support::radians;

constexpr double kRadius = 0.3;
constexpr double kSkin = 0.02;
const Vec3 kEastward(1.4, 0, 0);

/// A level floor to add things to.
class MoverAndWalls : public ::testing::Test {
protected:
    static std::unique_ptr<World> floor_only() {
        auto world = std::make_unique<World>(std::make_unique<LinearBroadPhase>());
        TriangleMesh floor;
        support::add_floor(floor, 50.0);
        add_object(*world, floor);
        return world;
    }

    /// A wall without thickness from one point to another, 3 m high.
    ObjectId add_wall(const Vec3& from, const Vec3& to, int pieces = 1) {
        TriangleMesh wall;
        const Vec3 up(0, 3, 0);
        for (int i = 0; i < pieces; ++i) {
            const Vec3 a = from + (i / static_cast<double>(pieces)) * (to - from);
            const Vec3 b = from + ((i + 1) / static_cast<double>(pieces)) * (to - from);
            add_quad(wall, a, b, b + up, a + up);
        }
        return add_object(*world_, wall);
    }
    /// A row of flush boxes, its front in the plane through the origin along `along`, facing `out`.
    void add_boxes(const Vec3& along, const Vec3& out) {
        Object box;
        box.shape = Box{{1.0, 1.5, 0.5}};
        box.X_world_shape.rotation << along, Vec3(0, 1, 0), -out;
        for (int i = -10; i <= 10; ++i) {
            box.X_world_shape.translation = 2.0 * i * along - 0.5 * out + Vec3(0, 1.5, 0);
            world_->add(box);
        }
    }

    std::unique_ptr<World> world_ = floor_only();
};

TEST_F(MoverAndWalls, OpenFloorIsWalkedAtFullSpeed) {
    AuditedBody body(*world_);
    body.stand({0, 0, 0});
    body.walk({1.0, 0, 1.0}, 5.0);
    EXPECT_NEAR(body.foot().x(), 5.0, 1e-9);
    EXPECT_NEAR(body.foot().z(), 5.0, 1e-9);
    EXPECT_NEAR(body.foot().y(), 0.0, 2e-4);
    EXPECT_EQ(body.ticks_in_air(), 0);
    EXPECT_TRUE(body.trace().touching.empty()) << "the floor underfoot isn't reported as touched";
}

TEST_F(MoverAndWalls, StopsInFrontOfAWallAndStaysThere) {
    const ObjectId wall = add_wall({3, 0, 5}, {3, 0, -5});
    AuditedBody body(*world_);
    body.stand({0, 0, 0});
    body.walk(kEastward, 4.0);
    EXPECT_NEAR(body.foot().x(), 3.0 - kRadius - kSkin, 1e-3);
    EXPECT_NEAR(body.foot().z(), 0.0, 1e-12);
    ASSERT_TRUE(body.touches(wall));
    EXPECT_NEAR(body.trace().touching.front().gap, kSkin, 1e-3);
    const Vec3 rest = body.foot();
    body.walk(kEastward, 1.0);
    EXPECT_LT((body.foot() - rest).norm(), 1e-6) << "no jitter";
}

TEST_F(MoverAndWalls, LeavesAWallAtFullSpeed) {
    add_wall({3, 0, 5}, {3, 0, -5});
    AuditedBody body(*world_);
    body.stand({2, 0, 0});
    body.walk(kEastward, 2.0);
    const Vec3 at_wall = body.foot();
    body.walk(-kEastward, 1.0);
    EXPECT_NEAR(at_wall.x() - body.foot().x(), 1.4, 1e-9);
}

TEST_F(MoverAndWalls, SlidesAlongAWallAtItsTangentialSpeed) {
    for (const int pieces : {1, 37}) {
        const double x = 3.0 + pieces;
        add_wall({x, 0, 20}, {x, 0, -20}, pieces);
        AuditedBody body(*world_);
        body.stand({x - kRadius - kSkin, 0, 0});
        body.walk({1.0, 0, -1.0}, 5.0);
        EXPECT_NEAR(body.foot().z(), -5.0, 1e-6) << pieces << " pieces: the seams don't slow it down";
        EXPECT_NEAR(body.foot().x(), x - kRadius - kSkin, 1e-3);
    }
}

/// At any heading, of triangles or of boxes, a wall is slid along at the skin's distance without losing
/// speed.
TEST_F(MoverAndWalls, SlidesAlongSlantedWalls) {
    for (const bool boxes : {false, true}) {
        for (const double degrees : {26.565, 5.0, 20.0, 45.0, 61.0, 84.0}) {
            if (support::kSanitized && degrees != 26.565) {
                continue;  // the search for a box's nearest point takes minutes under sanitizers
            }
            SCOPED_TRACE(testing::Message() << degrees << (boxes ? " boxes" : " triangles"));
            const double angle = radians(degrees);
            const Vec3 along(std::cos(angle), 0, -std::sin(angle));
            const Vec3 out(-std::sin(angle), 0, -std::cos(angle));
            world_ = floor_only();
            if (boxes) {
                add_boxes(along, out);
            } else {
                add_wall(-20.0 * along, 20.0 * along, 11);
            }
            AuditedBody body(*world_);
            body.stand((kRadius + kSkin + 0.1) * out - 5.0 * along);
            body.walk(along - out, 0.5);
            const Vec3 start = body.foot();
            EXPECT_NEAR(start.dot(out), kRadius + kSkin, 1e-5);
            const double seconds = support::kSanitized ? 1.0 : 3.0;
            body.walk(along - out, seconds);
            EXPECT_NEAR((body.foot() - start).dot(along), seconds, 1e-5);
            EXPECT_NEAR(body.foot().dot(out), kRadius + kSkin, 1e-5);
        }
    }
}

TEST_F(MoverAndWalls, FlushBoxesActAsOneWall) {
    for (int i = 0; i < 10; ++i) {
        add_object(*world_, Box{{0.5, 1.5, 1.0}}, {3.5, 1.5, 9.0 - 2.0 * i});
    }
    AuditedBody body(*world_);
    body.stand({3.0 - kRadius - kSkin, 0, 8});
    const double seconds = support::kSanitized ? 2.0 : 5.0;  // two seconds suffice to pass a seam
    body.walk({1.4, 0, -1.4}, seconds);
    EXPECT_NEAR(body.foot().z(), 8.0 - 1.4 * seconds, 1e-6);
}

TEST_F(MoverAndWalls, StandsStillInAWedge) {
    for (const double degrees : {15.0, 30.0, 45.0, 63.0, 90.0, 120.0, 170.0}) {
        SCOPED_TRACE(degrees);
        World world(std::make_unique<LinearBroadPhase>());
        TriangleMesh place;
        support::add_floor(place, 50.0);
        const double half = radians(0.5 * degrees);
        for (const double side : {-1.0, 1.0}) {  // a wedge that narrows towards +X
            const Vec3 tip(5, 0, 0);
            const Vec3 end = tip + 10.0 * Vec3(-std::cos(half), 0, side * std::sin(half));
            add_quad(place, tip, end, end + Vec3(0, 3, 0), tip + Vec3(0, 3, 0));
        }
        add_object(world, place);
        AuditedBody body(world);
        body.stand({0.5, 0, 0});
        body.walk(kEastward, 5.0);
        const Vec3 rest = body.foot();
        body.walk(kEastward, 2.0);
        EXPECT_LT((body.foot() - rest).norm(), 1e-4) << "no jitter";
        // The clearance of a radius and a skin ends there; along a straight wall the body may slide.
        EXPECT_NEAR(rest.x(), 5.0 - (kRadius + kSkin) / std::sin(half), 0.01);
    }
}

TEST_F(MoverAndWalls, WalksThroughADoorwayOfNinetyCentimetres) {
    TriangleMesh room;
    support::add_room(room, {-3, 0, -8}, {3, 3, -2}, 0.9);
    add_object(*world_, room);
    AuditedBody body(*world_);
    body.stand({0, 0, 0});
    body.walk({0, 0, -1.4}, 3.0);
    EXPECT_NEAR(body.foot().z(), -4.2, 1e-9) << "at full speed through the middle";
    for (const double offset : {-0.1, 0.1}) {
        body.stand({offset, 0, 0});
        body.walk({0, 0, -1.4}, 3.0);
        EXPECT_NEAR(body.foot().z(), -4.2, 1e-9) << offset;
    }
    for (const double offset : {-0.4, -0.3, 0.2, 0.35}) {
        body.stand({offset, 0, 0});
        body.walk(Vec3(-0.5 * offset, 0, -1.4), 6.0);
        EXPECT_LT(body.foot().z(), -4.0) << offset << ": slides past the door post";
    }
}

TEST_F(MoverAndWalls, CannotPassAGapNarrowerThanItself) {
    TriangleMesh room;
    support::add_room(room, {-3, 0, -8}, {3, 3, -2}, 0.55);
    add_object(*world_, room);
    AuditedBody body(*world_);
    body.stand({0, 0, 0});
    body.walk({0, 0, -1.4}, 5.0);
    EXPECT_GT(body.foot().z(), -2.0);
}

TEST_F(MoverAndWalls, WalksAroundATree) {
    const ObjectId tree = add_object(*world_, Capsule{0.25, 1.5}, {3, 1.5, 0.05});
    AuditedBody body(*world_);
    body.stand({0, 0, 0});
    bool bumped = false;
    for (int i = 0; i < 400; ++i) {
        body.tick(kEastward);
        bumped = bumped || body.touches(tree);
    }
    EXPECT_TRUE(bumped);
    EXPECT_GT(body.foot().x(), 4.0);
    EXPECT_LT(body.foot().z(), -0.4) << "it was pushed to the side it came from";
}

TEST_F(MoverAndWalls, DoesNotTunnelThroughAWallAtAnySpeed) {
    const ObjectId wall = add_wall({3, 0, 5}, {3, 0, -5});
    for (const double speed : {5.0, 20.0, 100.0, 1000.0}) {
        AuditedBody body(*world_);
        body.stand({0, 0, 0});
        body.walk({speed, 0, 0}, 0.8);
        EXPECT_NEAR(body.foot().x(), 3.0 - kRadius - kSkin, 1e-3) << speed;
        EXPECT_TRUE(body.touches(wall)) << speed;
    }
}

TEST_F(MoverAndWalls, StopsAtAThinRailAtHipHeight) {
    TriangleMesh rail;
    add_quad(rail, {2, 1.0, 5}, {2, 1.0, -5}, {2, 1.01, -5}, {2, 1.01, 5});
    add_object(*world_, rail);
    add_object(*world_, Capsule{0.02, 2.0}, {-2, 1.0, 0});
    AuditedBody body(*world_);
    body.stand({0, 0, 0});
    body.walk(kEastward, 3.0);
    EXPECT_LT(body.foot().x(), 2.0 - kRadius + 1e-9);
    body.walk(-kEastward, 5.0);
    EXPECT_GT(body.foot().x(), -10.0);
}

TEST_F(MoverAndWalls, WalksThroughTriggersAndIgnoredLayers) {
    Object ghost;
    ghost.shape = Box{{0.5, 2, 5}};
    ghost.X_world_shape.translation = {2, 0, 0};
    ghost.detection = Detection::trigger | Detection::ray;
    world_->add(ghost);
    ghost.X_world_shape.translation = {4, 0, 0};
    ghost.detection = Detection::solid;
    ghost.layer = 5;
    world_->add(ghost);
    AuditedBody body(*world_, {}, {Detection::solid, 1U << 5U});
    body.stand({0, 0, 0});
    body.walk(kEastward, 5.0);
    EXPECT_NEAR(body.foot().x(), 7.0, 1e-9);
    AuditedBody other(*world_);
    other.stand({0, 0, 0});
    other.walk(kEastward, 5.0);
    EXPECT_NEAR(other.foot().x(), 3.5 - kRadius - kSkin, 1e-3) << "it stops unless the layer is ignored";
}

TEST_F(MoverAndWalls, ListsEachTouchedObjectOnceInOrder) {
    const ObjectId left = add_wall({-5, 0, -0.4}, {5, 0, -0.4}, 40);
    const ObjectId ahead = add_wall({3, 0, 5}, {3, 0, -5}, 40);
    AuditedBody body(*world_);
    body.stand({0, 0, 0});
    body.walk({1.4, 0, -0.7}, 4.0);
    ASSERT_EQ(body.trace().touching.size(), 2U);
    EXPECT_EQ(body.trace().touching[0].object, left);
    EXPECT_EQ(body.trace().touching[1].object, ahead);
    for (const Touch& touch : body.trace().touching) {
        EXPECT_NEAR(touch.gap, kSkin, 1e-3);
    }
    MoveTrace trace;
    MoverCache cache;
    CapsuleMover(*world_, {}, {}).touch(body.state(), cache, trace);
    ASSERT_EQ(trace.touching.size(), 2U) << "the same for a body at rest";
    EXPECT_EQ(trace.touching[1].gap, body.trace().touching[1].gap);
}

TEST_F(MoverAndWalls, ATicksPathConsistsOfEqualSegments) {
    AuditedBody body(*world_);
    body.stand({0, 0, 0});
    body.tick({60.0 * 1.0, 0, 0});  // a metre in one tick
    const auto& path = body.trace().path;
    ASSERT_GE(path.size(), 4U);
    for (std::size_t i = 1; i < path.size(); ++i) {
        EXPECT_NEAR((path[i] - path[i - 1]).x(), 1.0 / static_cast<double>(path.size() - 1), 1e-9);
    }
}

/// Placed in a wall by mistake, it can leave but not go deeper.
TEST_F(MoverAndWalls, CanLeaveAWallItWasPlacedIn) {
    add_wall({3, 0, 5}, {3, 0, -5});
    const CapsuleMover mover(*world_, {}, {});
    MoverCache cache;
    MoverState state;
    state.foot = {2.8, 1e-4, 0};  // 10 cm deep
    state.grounded = true;
    MoveTrace trace;
    for (int i = 0; i < 30; ++i) {
        mover.move(state, {0.02, 0, 0}, 1.0 / 60.0, cache, trace);
    }
    EXPECT_LE(state.foot.x(), 2.8 + 1e-9);
    for (int i = 0; i < 30; ++i) {
        mover.move(state, {-0.02, 0, 0}, 1.0 / 60.0, cache, trace);
    }
    EXPECT_LT(state.foot.x(), 2.4);
}

}  // namespace
}  // namespace campuswalk::collision

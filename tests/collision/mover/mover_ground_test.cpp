#include <cmath>

#include <gtest/gtest.h>

#include "collision/mover/mover.h"
#include "tests/collision/mover/audited_body.h"
#include "tests/support/angles.h"
#include "tests/support/effort.h"
#include "tests/support/mesh_pieces.h"

/// Ground and ceilings: resting, steps, slopes, falls.
namespace campuswalk::collision {
namespace {

using support::add_box;
using support::add_floor;
using support::add_object;
using support::add_quad;
using support::add_stairs;
using support::radians;

constexpr double kGravity = 9.81;
const Vec3 kEast(1.4, 0, 0);

void push_until_it_lands(AuditedBody& body, const Vec3& velocity) {
    for (int tick = 0; tick < 600 && !body.state().grounded; ++tick) {
        body.tick(velocity);
    }
    EXPECT_TRUE(body.state().grounded) << "after ten seconds";
}

class MoverAndGround : public ::testing::Test {
protected:
    /// A level floor at height 0 with something added to it.
    template <typename Add>
    void build(const Add& add) {
        add_object(world_, support::floor_with(add));
    }
    /// A slope that starts at x = 1 and rises along +X for 6 m, then a landing.
    void build_ramp(double degrees) {
        build([&](TriangleMesh& mesh) {
            const double high = 6.0 * std::tan(radians(degrees));
            add_quad(mesh, {1, 0, 2}, {7, high, 2}, {7, high, -2}, {1, 0, -2});
            add_quad(mesh, {7, high, 2}, {20, high, 2}, {20, high, -2}, {7, high, -2});
        });
    }

    World world_{std::make_unique<LinearBroadPhase>()};
};

TEST_F(MoverAndGround, ABodyAtRestDoesNotMove) {
    build_ramp(40.0);
    for (const double x : {0.0, 1.0, 3.0, 7.0}) {
        AuditedBody body(world_);
        body.stand({x, 6.0, 0}, 7.0);
        ASSERT_TRUE(body.state().grounded);
        body.fall_down();
        const Vec3 start = body.foot();
        body.walk(Vec3::Zero(), 20.0);
        EXPECT_EQ(body.foot(), start) << "bit for bit, at x = " << x;
        EXPECT_EQ(body.ticks_in_air(), 0);
        EXPECT_FALSE(body.trace().landed);
    }
}

TEST_F(MoverAndGround, RisersOfSeventeenCentimetresAreClimbed) {
    build([](TriangleMesh& mesh) { add_stairs(mesh, 1.0, -1.0, 2.0, 0.17, 0.28, 15); });
    for (const double rate : {20.0, 60.0, 144.0}) {
        AuditedBody body(world_);
        body.ticks_per_second = rate;
        body.stand({0, 0, 0});
        body.walk(kEast, 4.0);
        EXPECT_NEAR(body.foot().x(), 5.6, 1e-6) << "at full speed, " << rate << " ticks per second";
        EXPECT_NEAR(body.foot().y(), 15 * 0.17, 1e-3);
        EXPECT_EQ(body.ticks_in_air(), 0);
    }
}

TEST_F(MoverAndGround, StairsAreDescendedWithoutLeavingTheGround) {
    build([](TriangleMesh& mesh) { add_stairs(mesh, 1.0, -1.0, 2.0, 0.17, 0.28, 15); });
    AuditedBody body(world_);
    body.stand({5.5, 2.6, 0}, 0.5);
    ASSERT_TRUE(body.state().grounded);
    body.walk(-kEast, 4.0);
    EXPECT_NEAR(body.foot().x(), -0.1, 1e-6);
    EXPECT_NEAR(body.foot().y(), 0.0, 1e-3);
    EXPECT_EQ(body.ticks_in_air(), 0);
}

TEST_F(MoverAndGround, StairsAreClimbedAtAnAngle) {
    build([](TriangleMesh& mesh) { add_stairs(mesh, 1.0, -5.0, 10.0, 0.17, 0.28, 15); });
    AuditedBody body(world_);
    body.stand({0, 0, 3});
    body.walk({1.0, 0, -1.0}, 5.0);
    EXPECT_NEAR(body.foot().x(), 5.0, 1e-6);
    EXPECT_NEAR(body.foot().z(), -2.0, 1e-6);
    EXPECT_NEAR(body.foot().y(), 15 * 0.17, 1e-3);
}

/// A step as a mesh and as a box: climbed up to the step height, a wall above it.
TEST_F(MoverAndGround, OnlyStepsUpToTheStepHeightAreClimbed) {
    for (const bool solid : {false, true}) {
        for (const double high : {0.05, 0.17, 0.25, 0.30, 0.32, 0.35, 0.40, 0.5, 0.9}) {
            if (support::kSanitized && solid && high != 0.30 && high != 0.5) {
                continue;  // the search for a box's nearest point is slow under sanitizers
            }
            SCOPED_TRACE(testing::Message() << high << (solid ? " box" : " mesh"));
            World world(std::make_unique<LinearBroadPhase>());
            TriangleMesh mesh;
            add_floor(mesh, 40.0);
            if (solid) {
                add_object(world, Box{{2.0, 0.5 * high, 2.0}}, {3.0, 0.5 * high, 0.0});
            } else {
                add_box(mesh, {1, 0, -2}, {5, high, 2});
            }
            add_object(world, mesh);
            AuditedBody body(world);
            body.stand({0, 0, 0});
            body.walk(kEast, 2.0);
            if (high <= 0.30) {
                EXPECT_NEAR(body.foot().x(), 2.8, 1e-6);
                EXPECT_NEAR(body.foot().y(), high, 1e-3);
            } else {
                EXPECT_LT(body.foot().x(), 1.0 - 0.29);
                EXPECT_NEAR(body.foot().y(), 0.0, 1e-3);
            }
        }
    }
}

TEST_F(MoverAndGround, RampsAreWalkedUpAndDownAtFullHorizontalSpeed) {
    build_ramp(30.0);
    AuditedBody body(world_);
    body.stand({0, 0, 0});
    body.walk(kEast, 6.0);
    EXPECT_NEAR(body.foot().x(), 8.4, 1e-6);
    EXPECT_NEAR(body.foot().y(), 6.0 * std::tan(radians(30.0)), 1e-3);
    body.walk(-kEast, 6.0);
    EXPECT_NEAR(body.foot().x(), 0.0, 1e-6);
    EXPECT_NEAR(body.foot().y(), 0.0, 1e-3);
    EXPECT_EQ(body.ticks_in_air(), 0) << "no flicker downhill";
}

TEST_F(MoverAndGround, RampsBeyondTheSlopeLimitAreWalls) {
    for (const double degrees : {45.0, 49.0, 52.0, 65.0, 80.0}) {
        SCOPED_TRACE(degrees);
        World world(std::make_unique<LinearBroadPhase>());
        TriangleMesh mesh;
        add_floor(mesh, 40.0);
        const double high = 6.0 * std::tan(radians(degrees));
        add_quad(mesh, {1, 0, 2}, {7, high, 2}, {7, high, -2}, {1, 0, -2});
        add_object(world, mesh);
        AuditedBody body(world);
        body.stand({0, 0, 0});
        body.walk(kEast, 3.0);
        if (degrees < 50.0) {
            EXPECT_GT(body.foot().y(), 3.0);
        } else {
            EXPECT_LT(body.foot().y(), 0.01);
        }
    }
}

TEST_F(MoverAndGround, DropsFromALedgeAndLands) {
    constexpr double kHigh = 3.0;
    build([&](TriangleMesh& mesh) { add_box(mesh, {-5, 0, -2}, {0, kHigh, 2}); });
    AuditedBody body(world_);
    body.stand({-1, kHigh + 0.1, 0});
    ASSERT_TRUE(body.state().grounded);
    while (body.state().grounded && body.foot().x() < 5.0) {
        body.tick(kEast);
    }
    EXPECT_GT(body.foot().x(), 0.0) << "it walks on as long as anything supports it";
    EXPECT_LT(body.foot().x(), 0.35);
    int ticks = 0;
    while (!body.state().grounded && ticks < 600) {
        body.tick(kEast);
        ++ticks;
    }
    EXPECT_TRUE(body.trace().landed);
    const double fallen = body.trace().fall_height;
    EXPECT_LE(fallen, kHigh + 1e-3);
    EXPECT_GT(fallen, kHigh - 0.3) << "its round end rolls over the edge before it leaves the ground";
    EXPECT_NEAR(ticks / 60.0, std::sqrt(2.0 * fallen / kGravity), 0.03) << "as long as gravity takes";
    EXPECT_NEAR(body.foot().y(), 0.0, 1e-3);
    EXPECT_EQ(body.state().vertical_speed, 0.0);
    body.tick(kEast);
    EXPECT_FALSE(body.trace().landed) << "reported only once";
}

TEST_F(MoverAndGround, FreeFallFollowsGravity) {
    build([](TriangleMesh&) {});
    AuditedBody body(world_);
    body.stand({0, 30, 0}, 0.5);
    ASSERT_FALSE(body.state().grounded);
    for (int tick = 1; tick <= 120; ++tick) {
        body.tick(Vec3::Zero());
        const double t = tick / 60.0;
        ASSERT_NEAR(body.foot().y(), 30.0 - 0.5 * kGravity * t * t, 1e-9);
        ASSERT_NEAR(body.state().vertical_speed, -kGravity * t, 1e-9);
    }
    body.fall_down();
    EXPECT_NEAR(body.trace().fall_height, 30.0, 1e-3);
}

TEST_F(MoverAndGround, AFastFallStopsAtAThinFloor) {
    build([](TriangleMesh&) {});
    AuditedBody body(world_);
    body.stand({0.3, 10, 0.3}, 0.1);
    body.state().vertical_speed = -2000.0;
    body.tick(Vec3::Zero());
    EXPECT_NEAR(body.foot().y(), 0.0, 1e-3);
    EXPECT_TRUE(body.state().grounded);
}

/// The body falls past the edge of a shelf that it pushes at; the wall below stands out from that a little.
TEST_F(MoverAndGround, AFallIsCaughtByALedgeButNotByAWallThatIsNotQuiteFlush) {
    for (const double out : {-1e-4, 0.0, 1e-4, 2e-4, 3e-4, 5e-4, 0.001, 0.005, 0.05}) {
        SCOPED_TRACE(out);
        World world(std::make_unique<LinearBroadPhase>());
        add_object(world, support::floor_with([&](TriangleMesh& mesh) {
                       add_quad(mesh, {1, 2, 3}, {2, 2, 3}, {2, 2, -3}, {1, 2, -3});
                       add_box(mesh, {1 - out, -1, -3}, {2, 1.65, 3});
                   }));
        AuditedBody body(world);
        body.stand({0.5, 1.68, 0}, 0.1);
        push_until_it_lands(body, kEast);
        EXPECT_NEAR(body.state().support_y, out < 4e-4 ? 0.0 : 1.65, 1e-3);
    }
}

/// It pushes into a corner whose two walls stand out a little below: neither edge may hold it for ever.
TEST_F(MoverAndGround, AFallAgainstTwoWallsThatAreNotQuiteFlushEndsOnTheFloor) {
    for (const double radius : {0.1, 0.3, 0.5, 1.0}) {
        for (const double out : {0.0, 0.02, 0.3, 0.6, 0.9}) {
            for (const double other : {0.1, 0.5, 0.8}) {
                SCOPED_TRACE(testing::Message() << radius << ' ' << out << ' ' << other);
                MoverSettings settings;
                settings.radius = radius;
                settings.height = 2.2;
                const double most = 0.00125 * radius;                 // what doesn't catch a fall
                const double lower = 1.0 - settings.skin + kRestGap;  // where the body passes it
                World world(std::make_unique<LinearBroadPhase>());
                add_object(world, support::floor_with([&](TriangleMesh& mesh) {
                               add_box(mesh, {1, 1, -3}, {2, 6, 3});
                               add_box(mesh, {-3, 1, 1}, {2, 6, 2});
                               add_box(mesh, {lower - out * most, -1, -3}, {2, 1, 3});
                               add_box(mesh, {-3, -1, lower - other * most}, {2, 1, 2});
                           }));
                AuditedBody body(world, settings);
                body.stand({0.75 - radius, 1.9, 0.75 - radius}, 0.01);
                push_until_it_lands(body, {1.2, 0, 0.9});
                EXPECT_NEAR(body.foot().y(), 0.0, 1e-3);
            }
        }
    }
}

TEST_F(MoverAndGround, AFallBetweenTwoEdgesThatHardlyOverlapItEndsOnTheFloor) {
    for (const double left : {1e-5, 1e-4, 2.85e-4}) {
        for (const double right : {2e-5, 1.1e-4, 3e-4}) {
            SCOPED_TRACE(testing::Message() << left << ' ' << right);
            World world(std::make_unique<LinearBroadPhase>());
            add_object(world, support::floor_with([&](TriangleMesh& mesh) {
                           add_box(mesh, {-3, -1, -3}, {left - 0.3001, 1, 3});
                           add_box(mesh, {0.3001 - right, -1, -3}, {3, 1, 3});
                       }));
            AuditedBody body(world);
            body.stand({0, 1.6, 0}, 0.01);
            push_until_it_lands(body, Vec3::Zero());
            EXPECT_LT(body.foot().y(), 1.0) << "it stands between the edges, or on the floor";
        }
    }
}

TEST_F(MoverAndGround, SlidesDownASlopeTooSteepToStandOn) {
    build([](TriangleMesh& mesh) { add_quad(mesh, {0, 0, 2}, {3, 6, 2}, {3, 6, -2}, {0, 0, -2}); });
    AuditedBody body(world_);
    body.stand({1.0, 4.0, 0}, 0.1);
    body.fall_down();
    EXPECT_NEAR(body.foot().y(), 0.0, 1e-3);
    EXPECT_LT(body.foot().x(), 0.0);
}

/// However shallow: it isn't taken for wedged.
TEST_F(MoverAndGround, SlidesDownEverySlopeThatItMayNotStandOn) {
    for (const double degrees : {6.5, 8.0, 15.0, 30.0, 60.0, 80.0}) {
        SCOPED_TRACE(degrees);
        World world(std::make_unique<LinearBroadPhase>());
        add_object(world, support::floor_with([&](TriangleMesh& mesh) {
                       const double high = 3.0 * std::tan(radians(degrees));
                       add_quad(mesh, {0, 0, 2}, {3, high, 2}, {3, high, -2}, {0, 0, -2});
                   }));
        MoverSettings settings;
        settings.min_up = std::cos(radians(5.0));
        settings.step_height = 0.02;
        AuditedBody body(world, settings);
        const double clear = settings.radius / std::cos(radians(degrees));
        body.stand({1.5, 1.5 * std::tan(radians(degrees)) + clear, 0}, 0.01);
        push_until_it_lands(body, Vec3::Zero());
        EXPECT_LE(body.state().support_y, settings.step_height) << "the floor, at most a step above it";
        EXPECT_LT(body.foot().x(), 0.1);
    }
}

TEST_F(MoverAndGround, OnlyACeilingLowerThanTheBodyStopsIt) {
    for (const double high : {0.5, 1.0, 1.7, 1.79, 1.83, 2.1}) {
        SCOPED_TRACE(high);
        World world(std::make_unique<LinearBroadPhase>());
        TriangleMesh mesh;
        add_floor(mesh, 40.0);
        add_box(mesh, {2, high, -3}, {6, 4, 3});
        add_object(world, mesh);
        AuditedBody body(world);
        body.stand({0, 0, 0});
        body.walk(kEast, 3.0);
        if (high > 1.8) {
            EXPECT_NEAR(body.foot().x(), 4.2, 1e-6);
        } else {
            EXPECT_LT(body.foot().x(), 2.0);
            EXPECT_NEAR(body.foot().y(), 0.0, 1e-3);
        }
    }
}

TEST_F(MoverAndGround, StopsUnderASlopingCeilingAndBacksOut) {
    build([](TriangleMesh& mesh) { add_quad(mesh, {0, 3, 2}, {6, 0, 2}, {6, 0, -2}, {0, 3, -2}); });
    AuditedBody body(world_);
    body.stand({-1, 0, 0});
    body.walk(kEast, 5.0);
    const Vec3 rest = body.foot();
    EXPECT_LT(rest.x(), 2.5);
    EXPECT_NEAR(rest.y(), 0.0, 1e-3);
    body.walk(kEast, 1.0);
    EXPECT_LT((body.foot() - rest).norm(), 1e-3);
    body.walk(-kEast, 1.0);
    EXPECT_NEAR(rest.x() - body.foot().x(), 1.4, 1e-3);
}

TEST_F(MoverAndGround, ADoorstepUnderALowLintelIsPassed) {
    build([](TriangleMesh& mesh) {
        add_box(mesh, {2, 0, -3}, {2.3, 0.1, 3});
        add_box(mesh, {2, 1.95, -3}, {2.3, 3, 3});  // 1.85 above the doorstep
    });
    AuditedBody body(world_);
    body.stand({0, 0, 0});
    body.walk(kEast, 3.0);
    EXPECT_NEAR(body.foot().x(), 4.2, 1e-6);
}

TEST_F(MoverAndGround, AJumpEndsAtTheCeiling) {
    build([](TriangleMesh& mesh) { add_box(mesh, {-3, 2.2, -3}, {3, 3, 3}); });
    AuditedBody body(world_);
    body.stand({0, 0, 0});
    body.state().grounded = false;
    body.state().vertical_speed = 6.0;
    double highest = 0.0;
    for (int i = 0; i < 60; ++i) {
        body.tick(Vec3::Zero());
        highest = std::max(highest, body.foot().y());
    }
    EXPECT_NEAR(highest, 0.4, 0.01);
    EXPECT_TRUE(body.state().grounded);
}

TEST_F(MoverAndGround, FlippedFloorsSupportTheBody) {
    TriangleMesh floor;
    add_quad(floor, {-9, 0, -9}, {9, 0, -9}, {9, 0, 9}, {-9, 0, 9});
    std::swap(floor.triangles[0][0], floor.triangles[0][1]);
    add_object(world_, floor);
    AuditedBody body(world_);
    body.stand({-5, 1, -4}, 0.1);
    body.fall_down();
    body.walk({1.4, 0, 1.0}, 5.0);
    EXPECT_NEAR(body.foot().x(), 2.0, 1e-6);
    EXPECT_NEAR(body.foot().y(), 0.0, 1e-3);
}

TEST_F(MoverAndGround, WalksLevelOnATessellatedFloor) {
    TriangleMesh floor;
    add_floor(floor, 10.0, 0.0, 0.37);
    add_object(world_, floor);
    AuditedBody body(world_);
    body.stand({-5, 0.1, -4});
    const double level = body.foot().y();
    for (int i = 0; i < 300; ++i) {
        body.tick({1.31, 0, 0.77});
        ASSERT_NEAR(body.foot().y(), level, 1e-6) << i;
    }
    EXPECT_NEAR(body.foot().x(), -5.0 + 1.31 * 5.0, 1e-6);
}

TEST_F(MoverAndGround, PlaceFindsGroundOnlyWithinTheSearchDistance) {
    build([](TriangleMesh&) {});
    AuditedBody body(world_);
    body.stand({2, 0.4, 3}, 0.5);
    EXPECT_TRUE(body.state().grounded);
    EXPECT_NEAR(body.foot().y(), 0.0, 1e-3);
    EXPECT_EQ(body.foot().x(), 2.0);
    body.stand({2, 0.6, 3}, 0.5);
    EXPECT_FALSE(body.state().grounded);
    EXPECT_EQ(body.foot().y(), 0.6);
    body.fall_down();
    EXPECT_NEAR(body.trace().fall_height, 0.6, 1e-3);
}

TEST_F(MoverAndGround, FallsOffTheEdgeOfTheFloor) {
    build([](TriangleMesh&) {});
    AuditedBody body(world_);
    body.stand({39, 0, 0});
    body.walk(kEast, 3.0);
    EXPECT_FALSE(body.state().grounded);
    EXPECT_LT(body.foot().y(), -5.0);
    EXPECT_NEAR(body.foot().x(), 43.2, 1e-6);
}

}  // namespace
}  // namespace campuswalk::collision

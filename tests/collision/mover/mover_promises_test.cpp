#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "collision/mover/mover.h"
#include "tests/collision/mover/audited_body.h"
#include "tests/support/angles.h"
#include "tests/support/effort.h"
#include "tests/support/mesh_pieces.h"
#include "tests/support/random_scene.h"

/// What holds everywhere: for any order of triangles, tick rate, speed and place.
namespace campuswalk::collision {
namespace {

using support::add_box;
using support::add_floor;
using support::add_object;
using support::add_quad;
using support::add_stairs;
using support::radians;

/// A stair, a ramp, a kerb and a room with a doorway.
TriangleMesh yard() {
    TriangleMesh mesh;
    add_floor(mesh, 30.0, 0.0, 1.7);
    add_stairs(mesh, 3.0, -2.0, 4.0, 0.17, 0.28, 10);
    add_quad(mesh, {-3, 0, -2}, {-3, 0, 2}, {-8, 2, 2}, {-8, 2, -2});
    add_box(mesh, {-20, 0, 4}, {20, 0.12, 6});
    support::add_room(mesh, {-3, 0, 8}, {3, 3, 14}, 0.9);
    return mesh;
}

/// A tour of the yard.
Vec3 tour(AuditedBody& body, const Vec3& at = Vec3::Zero()) {
    body.stand(at + Vec3(0, 0.05, 0));
    for (const Vec3& velocity : {Vec3(1.4, 0, 0.1), Vec3(-1.4, 0, -0.1), Vec3(-1.4, 0, 0.2),
                                 Vec3(0.7, 0, 1.2), Vec3(0, 0, -1.4), Vec3(0.5, 0, 1.3)}) {
        body.walk(velocity, 3.5);
    }
    return body.foot();
}

TEST(MoverPromises, TheOrderOfTrianglesDoesNotMatter) {
    const auto walk = [](TriangleMesh mesh) {
        World world(std::make_unique<LinearBroadPhase>());
        add_object(world, std::move(mesh));
        AuditedBody body(world);
        return tour(body);
    };
    const Vec3 end = walk(yard());
    TriangleMesh reversed = yard();
    std::reverse(reversed.triangles.begin(), reversed.triangles.end());
    EXPECT_EQ(walk(reversed), end) << "bit for bit";
    support::Dice dice(3);
    TriangleMesh shuffled = yard();
    for (std::size_t i = shuffled.triangles.size(); i > 1; --i) {
        std::swap(shuffled.triangles[i - 1],
                  shuffled.triangles[static_cast<std::size_t>(dice.below(static_cast<int>(i)))]);
    }
    EXPECT_EQ(walk(shuffled), end);
    TriangleMesh doubled = yard();
    doubled.triangles.insert(doubled.triangles.end(), shuffled.triangles.begin(), shuffled.triangles.end());
    EXPECT_EQ(walk(doubled), end) << "every triangle twice";
}

/// Round solids are swept, and how far a sweep goes shows in the last bits of what it finds.
TEST(MoverPromises, TheOrderOfSolidsDoesNotMatter) {
    support::Dice dice(5);
    std::vector<std::pair<double, Vec3>> mounds;  // a ball's radius and its centre
    for (int i = 0; i < 80; ++i) {
        const double radius = dice.between(0.3, 0.9);
        const double top = dice.between(0.05, 0.25);
        mounds.emplace_back(radius, Vec3(dice.between(-4, 4), top - radius, dice.between(-4, 4)));
    }
    const auto walk = [](const auto& balls) {
        World world(std::make_unique<LinearBroadPhase>());
        TriangleMesh floor;
        add_floor(floor, 10.0);
        add_object(world, std::move(floor));
        for (const auto& [radius, center] : balls) {
            add_object(world, Sphere{radius}, center);
        }
        AuditedBody body(world);
        body.stand({-4, 0.3, -4});
        std::vector<Vec3> ends;
        for (int i = 0; i < 40; ++i) {
            body.walk(1.4 * Vec3(i % 2 == 0 ? 1.0 : -1.0, 0, 0.2), 0.15 * (40 - i));
            ends.push_back(body.foot());
        }
        return ends;
    };
    EXPECT_EQ(walk(mounds), walk(std::vector(mounds.rbegin(), mounds.rend()))) << "bit for bit";
}

TEST(MoverPromises, FlippedTrianglesAreJustAsSolid) {
    const auto walk = [](TriangleMesh mesh) {
        World world(std::make_unique<LinearBroadPhase>());
        add_object(world, std::move(mesh));
        AuditedBody body(world);
        return tour(body);
    };
    TriangleMesh flipped = yard();
    for (auto& t : flipped.triangles) {
        std::swap(t[0], t[1]);
    }
    EXPECT_LT((walk(flipped) - walk(yard())).norm(), 1e-6);
}

TEST(MoverPromises, TheTickRateHardlyChangesAWalk) {
    World world(std::make_unique<LinearBroadPhase>());
    add_object(world, yard());
    AuditedBody reference(world);
    const Vec3 end = tour(reference);
    for (const double rate : {30.0, 120.0, 240.0}) {
        AuditedBody body(world);
        body.ticks_per_second = rate;
        EXPECT_LT((tour(body) - end).norm(), 0.05) << rate;
    }
}

TEST(MoverPromises, AWalkIsTheSameFiveKilometresAway) {
    World world(std::make_unique<LinearBroadPhase>());
    add_object(world, yard());
    const Vec3 at(4096.0, 128.0, -4096.0);
    World far(std::make_unique<LinearBroadPhase>());
    Pose X;
    X.translation = at;
    add_object(far, yard(), Detection::solid, X);
    AuditedBody here(world);
    AuditedBody there(far);
    EXPECT_LT((tour(there, at) - at - tour(here)).norm(), 1e-6);
}

TEST(MoverPromises, NothingIsCrossedAtAHundredMetresPerSecond) {
    World world(std::make_unique<LinearBroadPhase>());
    add_object(world, yard());
    for (const double heading : {0.0, 37.0, 91.0, 130.0, 200.0, 271.0, 333.0}) {
        AuditedBody body(world);
        body.stand({0, 0.05, 0});
        for (int i = 0; i < 40; ++i) {  // back and forth: the oracle checks every segment
            const double angle = radians(heading + 177.0 * i);
            body.walk(100.0 * Vec3(std::cos(angle), 0, std::sin(angle)), 0.05);
        }
    }
}

TEST(MoverPromises, SlidingAlongAWallKeepsTheTangentialSpeed) {
    for (const int pieces : {1, 40}) {
        for (const double degrees : {5.0, 25.0, 45.0, 65.0, 85.0}) {
            World world(std::make_unique<LinearBroadPhase>());
            TriangleMesh mesh;
            add_floor(mesh, 40.0, 0.0, 3.3);
            for (int i = 0; i < pieces; ++i) {
                for (const double row : {0.0, 1.0, 2.0}) {
                    const double from = -30.0 + 60.0 * i / pieces;
                    const double to = -30.0 + 60.0 * (i + 1) / pieces;
                    add_quad(mesh, {from, row, 1}, {to, row, 1}, {to, row + 1, 1}, {from, row + 1, 1});
                }
            }
            add_object(world, mesh);
            AuditedBody body(world);
            body.stand({-20, 0.05, 0.68});
            const double angle = radians(degrees);
            body.walk(1.4 * Vec3(std::cos(angle), 0, std::sin(angle)), 1.0);
            const Vec3 start = body.foot();
            body.walk(1.4 * Vec3(std::cos(angle), 0, std::sin(angle)), 5.0);
            const double speed = (body.foot() - start).x() / 5.0;
            EXPECT_NEAR(speed / (1.4 * std::cos(angle)), 1.0, 1e-6) << pieces << " pieces, " << degrees;
        }
    }
}

/// Also where it leans back, so that the body touches it below the height of a step, and in bands.
TEST(MoverPromises, SlidingAlongALeaningWallKeepsTheTangentialSpeed) {
    for (const double radius : {0.2, 0.3, 0.5}) {
        for (const double lean : {-1.0, 0.1, 0.2, 0.25, 0.5, 1.0, 1.9, 5.0}) {
            for (const int bands : {1, 7}) {
                World world(std::make_unique<LinearBroadPhase>());
                TriangleMesh mesh;
                add_floor(mesh, 40.0, 0.0, 3.3);
                const auto at = [&](double x, int band) {
                    const double height = 4.0 * band / bands;
                    return Vec3(x, height, -height * std::tan(radians(lean)));
                };
                for (int band = 0; band < bands; ++band) {
                    add_quad(mesh, at(-30, band), at(30, band), at(30, band + 1), at(-30, band + 1));
                }
                add_object(world, mesh);
                MoverSettings settings;
                settings.radius = radius;
                AuditedBody body(world, settings);
                body.stand({0, 0.05, radius + 0.3});
                body.walk({1, 0, -1}, 1.0);
                const double start = body.foot().x();
                body.walk({1, 0, -1}, 2.0);
                EXPECT_NEAR(body.foot().x() - start, 2.0, 1e-5)
                    << "radius " << radius << ", leans by " << lean << " degrees, " << bands << " bands";
                EXPECT_EQ(body.ticks_in_air(), 0);
            }
        }
    }
}

/// A faceted dome and dish: followed within the facets' sagitta, at full horizontal speed, never in the air.
TEST(MoverPromises, CurvedGroundIsFollowed) {
    for (const double bend : {-1.0, 1.0}) {
        World world(std::make_unique<LinearBroadPhase>());
        TriangleMesh mesh;
        const auto point = [&](int i, int k) {
            const double x = 0.4 * i;
            const double z = 0.4 * k;
            return Vec3(x, bend * 0.03 * (x * x + z * z), z);
        };
        for (int i = -20; i < 20; ++i) {
            for (int k = -20; k < 20; ++k) {
                add_quad(mesh, point(i, k), point(i, k + 1), point(i + 1, k + 1), point(i + 1, k));
            }
        }
        add_object(world, mesh);
        AuditedBody body(world);
        body.stand({-6, bend * 0.03 * 36.3 + 0.1, 0.5}, 1.0);
        ASSERT_TRUE(body.state().grounded);
        for (int i = 0; i < 480; ++i) {
            body.tick({1.4, 0, 0.1});
            const Vec3& f = body.foot();
            const double ground = bend * 0.03 * (f.x() * f.x() + f.z() * f.z());
            ASSERT_NEAR(f.y(), ground, 0.04) << i;
        }
        EXPECT_NEAR(body.foot().x(), -6.0 + 1.4 * 8.0, 1e-6);
        EXPECT_EQ(body.ticks_in_air(), 0);
    }
}

/// A body that comes to rest on the ridge or in the valley stays there.
TEST(MoverPromises, RidgesAndValleysAreCrossedAtFullSpeed) {
    for (const double bend : {-1.0, 1.0}) {
        World world(std::make_unique<LinearBroadPhase>());
        TriangleMesh mesh;
        const double high = bend * 5.0 * std::tan(radians(35.0));
        add_quad(mesh, {-5, high, 5}, {0, 0, 5}, {0, 0, -5}, {-5, high, -5});
        add_quad(mesh, {0, 0, 5}, {5, high, 5}, {5, high, -5}, {0, 0, -5});
        add_object(world, mesh);
        AuditedBody body(world);
        body.stand({-4, 0.8 * high + 0.2, 0}, 1.0);
        body.walk({1.4, 0, 0}, 5.0);
        EXPECT_NEAR(body.foot().x(), 3.0, 1e-6);
        EXPECT_EQ(body.ticks_in_air(), 0);
        body.walk({-1.4, 0, 0.3}, 3.0 / 1.4);
        const Vec3 rest = body.foot();
        body.walk(Vec3::Zero(), 5.0);
        EXPECT_EQ(body.foot(), rest);
    }
}

/// Down a lift shaft, pressed against its wall.
TEST(MoverPromises, AFallAlongAWallIsAFreeFall) {
    World world(std::make_unique<LinearBroadPhase>());
    TriangleMesh mesh;
    add_box(mesh, {-1, 0, -1}, {1, 60, 1});
    add_object(world, mesh);
    AuditedBody body(world);
    body.stand({0.5, 39.0, 0.2}, 0.1);
    ASSERT_FALSE(body.state().grounded);
    for (int i = 1; i <= 120; ++i) {
        body.tick({1.0, 0, 0.3});
        const double t = i / 60.0;
        ASSERT_NEAR(body.foot().y(), 39.0 - 0.5 * 9.81 * t * t, 1e-9) << i;
    }
    body.fall_down();
    EXPECT_NEAR(body.foot().y(), 0.0, 1e-3);
    EXPECT_NEAR(body.trace().fall_height, 39.0, 1e-3);
}

/// In wedges from 15 to 120 degrees, with or without a step at the foot of the walls, the body stands still.
TEST(MoverPromises, NoJitterInWedgesAndOnSteps) {
    for (const double degrees : {15.0, 40.0, 90.0, 120.0}) {
        for (const double step : {0.0, 0.15}) {
            World world(std::make_unique<LinearBroadPhase>());
            TriangleMesh mesh;
            add_floor(mesh, 40.0);
            if (step > 0.0) {
                add_box(mesh, {3, 0, -9}, {9, step, 9});
            }
            const double half = radians(0.5 * degrees);
            const Vec3 tip(5, -1, 0);
            for (const double side : {-1.0, 1.0}) {
                const Vec3 end = tip + 12.0 * Vec3(-std::cos(half), 0, side * std::sin(half));
                add_quad(mesh, tip, end, end + Vec3(0, 5, 0), tip + Vec3(0, 5, 0));
            }
            add_object(world, mesh);
            AuditedBody body(world);
            body.stand({0.3, 0.05, 0.01});
            body.walk({1.4, 0, 0.02}, 6.0);
            Aabb seen;
            for (int i = 0; i < 120; ++i) {
                body.tick({1.4, 0, 0.02});
                seen.extend(body.foot());
            }
            EXPECT_LT((seen.max - seen.min).norm(), 0.0005) << degrees << ", step " << step;
        }
    }
}

}  // namespace
}  // namespace campuswalk::collision

#include <cmath>

#include <gtest/gtest.h>

#include "collision/mover/mover.h"
#include "tests/collision/mover/audited_body.h"
#include "tests/support/angles.h"
#include "tests/support/dice.h"
#include "tests/support/effort.h"
#include "tests/support/mesh_pieces.h"

/// Falls past things that hardly stand out, into what is narrow, and fast.
namespace campuswalk::collision {
namespace {

using support::add_box;
using support::add_object;
using support::add_quad;
using support::Dice;
using support::radians;

template <typename Add>
World world_with(const Add& add) {
    World world(std::make_unique<LinearBroadPhase>());
    TriangleMesh mesh;
    add(mesh);
    add_object(world, mesh);
    return world;
}

/// In the air, with this speed downwards.
void let_fall(AuditedBody& body, const Vec3& foot, double speed) {
    body.stand(foot, 1e-5);
    body.state().grounded = false;
    body.state().foot = foot;
    body.state().fall_from = foot.y();
    body.state().vertical_speed = -speed;
}

bool lands_within(AuditedBody& body, double seconds) {
    const auto ticks = static_cast<int>(seconds * body.ticks_per_second);
    for (int tick = 0; tick < ticks && !body.state().grounded; ++tick) {
        body.tick(Vec3::Zero());
    }
    return body.state().grounded;
}

/// Steep slats, each a little farther on and lower than the one before, and a wall behind them: a fall goes
/// from one to the next in one tick, and must not get through the wall.
TEST(MoverFall, FromSlatToSlatDoesNotLeadThroughTheWallBehind) {
    struct Case {
        std::uint32_t seed;
        double radius, ticks_per_second, speed;
    };
    // Of some 70,000 random ones, those that did.
    for (const Case& c : {Case{12175, 0.3, 10, 8}, Case{782, 0.1, 30, 12}, Case{18067, 0.1, 60, 20},
                          Case{1535, 0.3, 60, 45}, Case{343, 0.2, 20, 14}}) {
        SCOPED_TRACE(c.seed);
        Dice dice(c.seed);
        const double speed = c.speed * dice.between(0.6, 1.0);
        const double in_a_tick = speed / c.ticks_per_second;
        const double pitch = in_a_tick * dice.between(0.3, 0.5);
        const double drop = pitch * dice.between(0.05, 0.35);
        const double width = dice.between(0.3, 0.6) * c.radius;
        const double wall = dice.between(2.0, 4.0) * pitch + 1.5 * c.radius;
        const World world = world_with([&](TriangleMesh& mesh) {
            const Vec3 down(width * std::cos(0.96), -width * std::sin(0.96), 0);
            for (int i = 0; i < 8 && i * pitch + width <= wall - 0.02; ++i) {
                const Vec3 left(i * pitch, 8.0 - i * drop, -3);
                const Vec3 right(i * pitch, 8.0 - i * drop, 3);
                add_quad(mesh, left, right, right + down, left + down);
            }
            add_box(mesh, {wall, 6, -3}, {wall + 0.05, 12, 3});
        });
        MoverSettings settings;
        settings.radius = c.radius;
        settings.height = std::max(3.0 * c.radius, 0.05);
        settings.step_height = 0.2 * c.radius;
        AuditedBody body(world, settings);
        body.ticks_per_second = c.ticks_per_second;
        const double high = 8.0 + dice.between(0.05, 1.05) * in_a_tick + 0.8 * c.radius;
        let_fall(body, {c.radius * dice.between(0.4, 0.9), high, 0}, speed);
        lands_within(body, 3.0);
        EXPECT_LT(body.foot().x(), wall);
    }
}

/// On its way down along a wall, 1 m of which stands out 0.1 to 0.36 mm, there is a ledge of
/// a few centimetres, reached in the same tick as what stands out.
TEST(MoverFall, EndsOnALedgeRightBelowAnEdgeThatHardlyOverlaps) {
    for (int seed = 0; seed < support::repeats(200); ++seed) {
        Dice dice(static_cast<std::uint32_t>(seed));
        for (const double speed : {8.0, 15.0}) {
            const double ledge = speed > 10.0 ? 0.09 : 0.03;
            const double below = dice.between(0.0, 1.0) * speed / 60.0;
            const double out = dice.between(0.2, 1.0) * 0.00036;
            const World world = world_with([&](TriangleMesh& mesh) {
                add_box(mesh, {0, 10, -3}, {3, 20, 3});
                add_box(mesh, {-out, 9, -3}, {3, 10, 3});
                add_box(mesh, {-ledge, -1, -3}, {3, 10.0 - below, 3});
            });
            AuditedBody body(world);
            let_fall(body, {-0.3001, 10.0 + dice.between(0.0, 1.0) * speed / 60.0, 0}, speed);
            EXPECT_TRUE(lands_within(body, 0.5)) << seed << ' ' << speed;
        }
    }
}

/// However near to it: sweeps leave less of a gap than falls do, and a body that was nearer stood on the
/// wall.
TEST(MoverFall, AlongAPlainWallThatLeansBackEndsOnTheFloor) {
    for (const double lean : {0.001, 0.05, 0.2, 0.34, 0.5, 1.0, 3.0}) {
        for (const double gap : {1e-6, 3e-5, 5e-5, 7e-5, 9.9e-5, 1e-4, 1.01e-4}) {
            SCOPED_TRACE(testing::Message() << lean << ' ' << gap);
            const double slope = std::tan(radians(lean));
            World world(std::make_unique<LinearBroadPhase>());
            add_object(world, support::floor_with([&](TriangleMesh& mesh) {
                           add_quad(mesh, {-6, 0, 0}, {12, 0, 0}, {12, 8, -8 * slope}, {-6, 8, -8 * slope});
                       }));
            AuditedBody body(world);
            const double radius = MoverSettings().radius;
            const Vec3 normal(0, std::sin(radians(lean)), std::cos(radians(lean)));
            const Vec3 center = Vec3(0, 3, -3 * slope) + (radius + gap) * normal;
            let_fall(body, center - Vec3(0, radius, 0), 0.0);
            EXPECT_TRUE(lands_within(body, 1.5));
            EXPECT_NEAR(body.foot().y(), 0.0, 1e-3);
        }
    }
}

/// A level funnel over a slot that is a little wider than the body: it may sink slowly, but it gets through.
TEST(MoverFall, ThroughAFunnelWithAMillimetreOfPlayEndsBelow) {
    for (const double degrees : {55.0, 65.0, 75.0}) {
        for (const double aside : {-0.1, 0.0, 0.03, 0.2}) {
            SCOPED_TRACE(testing::Message() << degrees << ' ' << aside);
            const double half = 0.3 + 0.0005;
            const double high = 1.0 * std::tan(radians(degrees));
            World world(std::make_unique<LinearBroadPhase>());
            add_object(world, support::floor_with([&](TriangleMesh& mesh) {
                           add_quad(mesh, {half, 2, -3}, {half, 2, 3}, {half + 1, 2 + high, 3},
                                    {half + 1, 2 + high, -3});
                           add_quad(mesh, {-half, 2, -3}, {-half, 2, 3}, {-half - 1, 2 + high, 3},
                                    {-half - 1, 2 + high, -3});
                       }));
            AuditedBody body(world);
            let_fall(body, {aside, 3.5, 0}, 0.0);
            EXPECT_TRUE(lands_within(body, 20.0));
            EXPECT_NEAR(body.foot().y(), 0.0, 1e-3);
        }
    }
}

/// Boxes side by side and one on the other, some of them up to 0.6 mm out of line. A body that walks and
/// jumps among them is never in the air for long: 5.5 m are the farthest fall.
TEST(MoverFall, AmongBoxesThatAreNotQuiteInLineNoneHangsInTheAir) {
    for (int seed = 0; seed < support::repeats(120); ++seed) {
        Dice dice(static_cast<std::uint32_t>(seed));
        World world(std::make_unique<LinearBroadPhase>());
        add_object(world, support::floor_with([&](TriangleMesh& mesh) {
                       for (int i = 0; i < 64; ++i) {
                           if (dice.chance(0.45)) {
                               continue;
                           }
                           const auto shift = [&] {
                               return dice.chance(0.6) ? dice.between(-0.0006, 0.0006) : 0.0;
                           };
                           const int row = i / 8;
                           const Vec3 low(-2.4 + 0.6 * (i % 8) + shift(), dice.chance(0.5) ? 0.0 : -0.05,
                                          -2.4 + 0.6 * row + shift());
                           const double middle = low.y() + (dice.chance(0.5) ? 0.5 : dice.between(0.1, 1.2));
                           add_box(mesh, low, {low.x() + 0.6, middle, low.z() + 0.6});
                           if (dice.chance(0.5)) {
                               const Vec3 on(low.x() + shift(), middle, low.z() + shift());
                               add_box(mesh, on, on + Vec3(0.6, dice.between(0.1, 1.2), 0.6));
                           }
                       }
                   }));
        AuditedBody body(world);
        body.stand({dice.between(-2, 2), 4, dice.between(-2, 2)}, 0.01);
        Vec3 velocity = Vec3::Zero();
        int in_air = 0;
        for (int tick = 0; tick < 1800 && body.foot().y() > -0.5; ++tick) {
            if (dice.chance(1.0 / 90.0)) {
                const double yaw = dice.between(0.0, 6.283);
                const double speed = dice.chance(0.2) ? 0.0 : dice.between(0.3, 4.0);
                velocity = speed * Vec3(std::cos(yaw), 0, std::sin(yaw));
            }
            if (dice.chance(1.0 / 60.0) && body.state().grounded) {
                body.state().leave_ground(dice.between(2.0, 5.0), body.foot().y());
            }
            body.tick(velocity);
            in_air = body.state().grounded ? 0 : in_air + 1;
            ASSERT_LT(in_air, 240) << "for four seconds, at tick " << tick << " of " << seed;
        }
    }
}

/// Steep faces are walls, to which a body keeps a gap of at most the skin. A sphere that keeps the gap g to
/// all faces of a pit with the slope s has its middle (r + g) / cos s above the deepest point.
TEST(MoverFall, InAPitOfSteepFacesItRestsWhereTheGapToThemIsWithinTheSkin) {
    const MoverSettings settings;
    for (int seed = 0; seed < support::repeats(150); ++seed) {
        SCOPED_TRACE(seed);
        Dice dice(static_cast<std::uint32_t>(seed));
        const int sides = 3 + dice.below(10);
        const double slope = radians(dice.between(53, 80));
        const double turned = dice.between(0.0, 6.283);
        const double depth = 3.0 * std::tan(slope);
        const double reach = 3.0 / std::cos(3.14159265 / sides);
        const World world = world_with([&](TriangleMesh& mesh) {
            const auto rim = [&](int side) {
                const double angle = turned + 6.28318531 * side / sides;
                return Vec3(reach * std::cos(angle), 0.0, reach * std::sin(angle));
            };
            for (int side = 0; side < sides; ++side) {
                support::add_triangle(mesh, {0, -depth, 0}, rim(side + 1), rim(side));
            }
        });
        AuditedBody body(world);
        const double from = dice.between(0.0, 6.283);
        const double off = dice.between(0.0, 1.4);
        let_fall(body, {off * std::cos(from), 0.5, off * std::sin(from)}, 0.0);
        ASSERT_TRUE(lands_within(body, 10.0));
        const double above = (body.foot().y() + depth + settings.radius) * std::cos(slope) - settings.radius;
        EXPECT_GE(above, 0.0);
        EXPECT_LE(above, settings.skin);
        const Vec3 rest = body.foot();
        body.walk(Vec3::Zero(), 1.0);
        EXPECT_EQ(body.foot(), rest);
    }
}

}  // namespace
}  // namespace campuswalk::collision

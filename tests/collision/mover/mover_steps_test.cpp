#include <cmath>

#include <gtest/gtest.h>

#include "collision/mover/mover.h"
#include "tests/collision/mover/audited_body.h"
#include "tests/support/angles.h"
#include "tests/support/effort.h"
#include "tests/support/mesh_pieces.h"

/// How high a step may be, for bodies of several sizes.
namespace campuswalk::collision {
namespace {

using support::add_box;
using support::add_floor;
using support::add_object;
using support::add_quad;
using support::add_stairs;
using support::radians;

struct Profile {
    const char* name = "";
    double height = 1.8;
    double radius = 0.3;
    double step = 0.3;
};

MoverSettings settings_of(const Profile& profile) {
    MoverSettings settings;
    settings.height = profile.height;
    settings.radius = profile.radius;
    settings.step_height = profile.step;
    return settings;
}

/// How high a body gets that walks `heading` degrees off +X against what `add` builds from x = 1.
template <typename Add>
double height_reached(const MoverSettings& settings, double heading, double speed, const Add& add) {
    World world(std::make_unique<LinearBroadPhase>());
    add_object(world, support::floor_with(add));
    AuditedBody body(world, settings);
    body.stand({0, 0, 0});
    const double angle = radians(heading);
    double highest = 0.0;
    for (int i = 0; i < static_cast<int>(120.0 * 1.4 / speed); ++i) {
        body.tick(speed * Vec3(std::cos(angle), 0, std::sin(angle)));
        highest = std::max(highest, body.foot().y());
    }
    return highest;
}

class MoverAndSteps : public ::testing::TestWithParam<Profile> {};

/// A block with an upright front, its top far deeper than a tread.
void add_block(TriangleMesh& mesh, double high) {
    add_box(mesh, {1, 0, -20}, {5, high, 20});
}

/// The same with its front in rows of small triangles.
void add_tessellated_block(TriangleMesh& mesh, double high) {
    constexpr int kRows = 4;
    for (int row = 0; row < kRows; ++row) {
        for (int i = 0; i < 200; ++i) {
            const double low = row * high / kRows;
            const double top = (row + 1) * high / kRows;
            const double z = -20.0 + 0.2 * i;
            add_quad(mesh, {1, low, z}, {1, low, z + 0.2}, {1, top, z + 0.2}, {1, top, z});
        }
    }
    add_quad(mesh, {1, high, 20}, {5, high, 20}, {5, high, -20}, {1, high, -20});
}

/// Treads a quarter of a metre deep.
void add_flight(TriangleMesh& mesh, double riser) {
    add_stairs(mesh, 1.0, -20.0, 40.0, riser, 0.25, 3);
}

TEST_P(MoverAndSteps, TheStepHeightIsExactToFiveMillimetres) {
    const MoverSettings settings = settings_of(GetParam());
    for (const auto add : {add_block, add_tessellated_block, add_flight}) {
        for (const double heading : {0.0, 20.0, 45.0}) {
            if (support::kSanitized && heading != 20.0) {
                continue;  // it would take a minute
            }
            for (const double speed : {0.3, 1.4, 5.0}) {
                SCOPED_TRACE(testing::Message() << "heading " << heading << ", speed " << speed);
                const double low = settings.step_height - 0.005;
                const double high = settings.step_height + 0.005;
                EXPECT_GE(height_reached(settings, heading, speed, [&](auto& m) { add(m, low); }), low);
                EXPECT_LT(height_reached(settings, heading, speed, [&](auto& m) { add(m, high); }), 0.001);
            }
        }
    }
}

/// Other movers climb r (1 - cos limit) more than their step height: up the curve of their foot.
TEST_P(MoverAndSteps, TheRoundFootClimbsNoHigher) {
    const MoverSettings settings = settings_of(GetParam());
    for (int i = 0; 0.005 + 0.01 * i < settings.radius; ++i) {
        const double high = settings.step_height + 0.005 + 0.01 * i;
        EXPECT_LT(height_reached(settings, 0.0, 1.4, [&](auto& m) { add_block(m, high); }), 0.001) << high;
    }
}

TEST_P(MoverAndSteps, TheCrestOfARampIsNotAStep) {
    const MoverSettings settings = settings_of(GetParam());
    for (const double degrees : {10.0, 30.0, 45.0}) {
        const double high = std::tan(radians(degrees));
        const auto add = [&](TriangleMesh& mesh) {
            add_quad(mesh, {1, 0, 9}, {2, high, 9}, {2, high, -9}, {1, 0, -9});
            add_quad(mesh, {2, high, 9}, {9, high, 9}, {9, high, -9}, {2, high, -9});
        };
        EXPECT_NEAR(height_reached(settings, 0.0, 1.4, add), high, 0.001) << degrees;
        EXPECT_NEAR(height_reached(settings, 30.0, 5.0, add), high, 0.001) << degrees;
    }
}

INSTANTIATE_TEST_SUITE_P(Profiles, MoverAndSteps,
                         ::testing::Values(Profile{"adult", 1.8, 0.3, 0.3}, Profile{"child", 1.1, 0.2, 0.25},
                                           Profile{"robot", 0.6, 0.3, 0.04},
                                           Profile{"climber", 1.8, 0.25, 0.45}),
                         [](const auto& each) { return each.param.name; });

/// At most 3 % more ticks than over level ground.
TEST(MoverOnStairs, TwentyRisersTakeHardlyLongerThanLevelGround) {
    for (const double riser : {0.10, 0.17, 0.20, 0.29}) {
        World world(std::make_unique<LinearBroadPhase>());
        TriangleMesh mesh;
        add_floor(mesh, 40.0);
        add_stairs(mesh, 1.0, -1.0, 2.0, riser, 0.28, 20);
        add_object(world, mesh);
        AuditedBody body(world);
        body.stand({0.2, 0, 0});
        const double far = 1.0 + 19 * 0.28 + 0.5;
        int ticks = 0;
        while (body.foot().x() < far && ticks < 2000) {
            body.tick({1.4, 0, 0});
            ++ticks;
        }
        const double flat = (far - 0.2) / 1.4 * 60.0;
        EXPECT_LE(ticks, 1.03 * flat) << riser;
        EXPECT_NEAR(body.foot().y(), 20 * riser, 0.001);
        EXPECT_EQ(body.ticks_in_air(), 0);
    }
}

/// A plank 3 cm thick, its top at several heights.
TEST(MoverOnStairs, AThinPlankIsClimbedUpToTheStepHeight) {
    const auto reached = [](double high) {
        return height_reached({}, 0.0, 1.4, [&](TriangleMesh& mesh) {
            add_box(mesh, {1, high - 0.03, -2}, {1.3, high, 2});
        });
    };
    EXPECT_NEAR(reached(0.28), 0.28, 0.001) << "an open tread";
    EXPECT_LT(reached(0.33), 0.001);
    EXPECT_LT(reached(1.0), 0.001);
}

}  // namespace
}  // namespace campuswalk::collision

#include "tests/support/penetration_oracle.h"

#include <cmath>
#include <memory>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/audited_walk.h"
#include "tests/support/effort.h"
#include "tests/support/mesh_pieces.h"
#include "tests/support/village.h"

namespace campuswalk::support {
namespace {

using collision::CapsuleMover;
using collision::LinearBroadPhase;
using collision::MoverSettings;
using collision::MoverState;
using collision::MoveTrace;
using collision::Vec3;
using collision::World;

constexpr double kRadius = 0.3;
constexpr double kHeight = 1.8;

World empty_world() {
    return World(std::make_unique<LinearBroadPhase>());
}

double depth_at(const World& world, const Point& foot) {
    return PenetrationOracle(world).worst_penetration(foot, kRadius, kHeight).depth;
}

TEST(PenetrationOracle, AboveAFloorTheDepthIsMinusTheGap) {
    World world = empty_world();
    TriangleMesh floor;
    add_floor(floor, 5.0);
    add_object(world, floor);
    EXPECT_NEAR(depth_at(world, {1, 0.01, 1}), -0.01, 1e-15);
    EXPECT_NEAR(depth_at(world, {1, -0.02, 1}), 0.02, 1e-15);
    EXPECT_DOUBLE_EQ(depth_at(world, {1, 7, 1}), -PenetrationOracle::kClear);
}

TEST(PenetrationOracle, AxisThroughAWallIsARadiusDeep) {
    World world = empty_world();
    TriangleMesh wall;
    add_quad(wall, {-1, 0, 0}, {1, 0, 0}, {1, 3, 0}, {-1, 3, 0});
    add_object(world, wall);
    EXPECT_NEAR(depth_at(world, {0, 0.5, 0.25}), 0.05, 1e-15);
    EXPECT_DOUBLE_EQ(depth_at(world, {0, 2.0, 0}), kRadius);
}

TEST(PenetrationOracle, DeepInASolidTheDepthIsMeasuredToItsSurface) {
    World world = empty_world();
    add_object(world, collision::Box{{5, 5, 5}}, {0, 0, 0});
    EXPECT_NEAR(depth_at(world, {0, -0.9, 0}), 5.0 + kRadius, 1e-12);
    EXPECT_NEAR(depth_at(world, {4.9, -0.9, 0}), 0.1 + kRadius, 1e-12);
    EXPECT_NEAR(depth_at(world, {5.25, -0.9, 0}), 0.05, 1e-12);
}

TEST(PenetrationOracle, RoundSolidsAreMeasuredExactly) {
    World world = empty_world();
    add_object(world, collision::Sphere{1.0}, {0, 1, 0});
    add_object(world, collision::Capsule{0.5, 1.0}, {10, 1.5, 0});
    collision::Object wheel;
    wheel.shape = collision::Wheel{1.0, 0.2};
    wheel.X_world_shape.translation = {20, 1, 0};
    world.add(wheel);
    EXPECT_NEAR(depth_at(world, {1.25, 0.1, 0}), 0.05, 1e-12);
    EXPECT_NEAR(depth_at(world, {10, 0.1, 0.7}), 0.1, 1e-12);
    EXPECT_NEAR(depth_at(world, {20.4, 0.1, 0}), 0.1, 1e-12);
    EXPECT_NEAR(depth_at(world, {20, 0.1, -1.2}), 0.1, 1e-12);
    EXPECT_EQ(PenetrationOracle(world).worst_penetration({20.4, 0.1, 0}, kRadius, kHeight).object, 2U);
}

TEST(PenetrationOracle, RespectsTheFilter) {
    World world = empty_world();
    collision::Object ball;
    ball.shape = collision::Sphere{1.0};
    ball.detection = collision::Detection::trigger;
    ball.layer = 3;
    world.add(ball);
    const auto depth = [&](const collision::QueryFilter& filter) {
        return PenetrationOracle(world, filter).worst_penetration({0, 0, 0}, kRadius, kHeight).depth;
    };
    EXPECT_LT(depth({}), 0.0);
    EXPECT_GT(depth({collision::Detection::trigger, 0}), 0.9);
    EXPECT_LT(depth({collision::Detection::trigger, 1U << 3U}), 0.0);
}

TEST(PenetrationOracle, SeesAJumpThroughAThinWall) {
    World world = empty_world();
    TriangleMesh wall;
    add_quad(wall, {-1, 0, 0}, {1, 0, 0}, {1, 3, 0}, {-1, 3, 0});
    add_object(world, wall);
    const PenetrationOracle oracle(world);
    EXPECT_EQ(oracle.crossed({0, 0.1, 2}, {0, 0.1, -2}, kRadius, kHeight), 0U);
    EXPECT_EQ(oracle.crossed({0, 2.8, 2}, {0.3, 2.9, -2}, kRadius, kHeight), std::nullopt)
        << "the axis goes over it";
    EXPECT_EQ(oracle.crossed({0, 0.1, 2}, {0, 0.1, 0.5}, kRadius, kHeight), std::nullopt);
    EXPECT_EQ(oracle.crossed({0, 0.1, 2}, {0, 0.1, 2}, kRadius, kHeight), std::nullopt);
}

TEST(PenetrationOracle, SeesAJumpThroughASliverBetweenTheAxisEnds) {
    World world = empty_world();
    TriangleMesh rail;
    add_quad(rail, {-1, 1.0, 0}, {1, 1.0, 0}, {1, 1.01, 0}, {-1, 1.01, 0});
    add_object(world, rail);
    add_object(world, collision::Box{{1, 0.01, 0.01}}, {0, 1, -5});
    const PenetrationOracle oracle(world);
    EXPECT_EQ(oracle.crossed({0, 0, 1}, {0, 0, -1}, kRadius, kHeight), 0U);
    EXPECT_EQ(oracle.crossed({0, 0, -3}, {0, 0, -7}, kRadius, kHeight), 1U);
}

TEST(PenetrationOracle, SeesAFallThroughAFloor) {
    World world = empty_world();
    TriangleMesh floor;
    add_floor(floor, 5.0);
    add_object(world, floor);
    const PenetrationOracle oracle(world);
    EXPECT_EQ(oracle.crossed({1, 1, 1}, {1, -3, 1}, kRadius, kHeight), 0U);
    EXPECT_EQ(oracle.crossed({1, 1, 1}, {1, 0.1, 1}, kRadius, kHeight), std::nullopt);
}

TEST(PenetrationOracle, GridAgreesWithALoopOverEverything) {
    const auto village = make_village();
    const PenetrationOracle oracle(*village);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> across(-kVillageHalf - 3.0, kVillageHalf + 3.0);
    std::uniform_real_distribution<double> up(-2.0, 4.0);
    int inside = 0;
    const int places = repeats(2000);
    for (int i = 0; i < places; ++i) {
        const Point foot(across(random), up(random), across(random));
        const Penetration fast = oracle.worst_penetration(foot, kRadius, kHeight);
        const Penetration plain = oracle.worst_penetration_without_grid(foot, kRadius, kHeight);
        ASSERT_EQ(fast.depth, plain.depth) << foot.transpose();
        ASSERT_EQ(fast.object.has_value(), plain.object.has_value());
        inside += fast.depth > 0.0 ? 1 : 0;
    }
    EXPECT_GT(inside, places / 10);
    EXPECT_LT(inside, places * 9 / 10);
}

/// Five random walks through the village by the given mover.
class MoverUnderAudit : public ::testing::Test {
protected:
    WalkAudit walks(const MoveBody& move) const {
        WalkAudit all;
        for (std::uint32_t seed = 0; seed < 5; ++seed) {
            WalkSettings settings;
            settings.start = {0, 1, 0};
            settings.seed = seed;
            settings.ticks = kSanitized ? 300 : 1500;
            const WalkAudit one = audit_random_walk(oracle_, move, settings);
            if (one.deepest.depth > all.deepest.depth) {
                all.deepest = one.deepest;
            }
            all.ticks_inside += one.ticks_inside;
            all.crossings += one.crossings;
            all.finite = all.finite && one.finite;
            all.distance += one.distance;
        }
        return all;
    }

    MoveBody real_mover(const MoverSettings& settings) const {
        const CapsuleMover mover(*village_, settings, {});
        const auto cache = std::make_shared<collision::MoverCache>();
        return [mover, cache](MoverState& state, const Vec3& desired, double seconds, MoveTrace& trace) {
            mover.move(state, desired, seconds, *cache, trace);
        };
    }

    std::unique_ptr<World> village_ = make_village();
    PenetrationOracle oracle_{*village_};
};

TEST_F(MoverUnderAudit, TheRealMoverPasses) {
    const WalkAudit audit = walks(real_mover({}));
    EXPECT_TRUE(audit.clean()) << audit.ticks_inside << " ticks inside, " << audit.crossings
                               << " crossings, deepest " << audit.deepest.depth << " m in object "
                               << audit.deepest.object.value_or(999);
    EXPECT_GT(audit.distance, kSanitized ? 20.0 : 100.0) << "the body moved";
}

TEST_F(MoverUnderAudit, ARadiusFiveCentimetresTooSmallIsDetected) {
    MoverSettings thin;
    thin.radius = 0.25;
    const WalkAudit audit = walks(real_mover(thin));
    EXPECT_GT(audit.ticks_inside, kSanitized ? 5 : 100);
    EXPECT_GT(audit.deepest.depth, 0.025);
}

TEST_F(MoverUnderAudit, IgnoringAllObstaclesIsDetected) {
    const WalkAudit audit = walks([](MoverState& state, const Vec3& desired, double, MoveTrace& trace) {
        trace.path.assign(1, state.foot);
        state.foot += desired;
        trace.path.push_back(state.foot);
    });
    EXPECT_GT(audit.ticks_inside, kSanitized ? 2 : 10);
    EXPECT_GT(audit.crossings, kSanitized ? 0 : 5);
}

TEST_F(MoverUnderAudit, EndingACentimetreInsideAWallIsDetected) {
    const MoveBody real = real_mover({});
    const WalkAudit audit =
        walks([&](MoverState& state, const Vec3& desired, double seconds, MoveTrace& trace) {
            const Vec3 before = state.foot;
            real(state, desired, seconds, trace);
            const double gained = (state.foot - before).dot(desired) / desired.norm();
            if (state.grounded && gained < 0.5 * desired.norm()) {
                state.foot += (MoverSettings{}.skin + 0.01) * desired.normalized();
                trace.path.push_back(state.foot);
            }
        });
    EXPECT_GT(audit.ticks_inside, kSanitized ? 2 : 10);
    EXPECT_GT(audit.deepest.depth, 0.005);
}

}  // namespace
}  // namespace campuswalk::support

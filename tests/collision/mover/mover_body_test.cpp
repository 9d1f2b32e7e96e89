#include <cmath>

#include <gtest/gtest.h>

#include "collision/mover/mover.h"
#include "tests/support/mesh_pieces.h"
#include "tests/support/penetration_oracle.h"

/// Jumping, crouching, and a world whose objects come and go.
namespace campuswalk::collision {
namespace {

using support::add_box;
using support::add_object;
using support::PenetrationOracle;

constexpr double kStandardGravity = 9.81;

/// A body in the middle of a floor to which each test adds obstacles.
class MoverBody : public ::testing::Test {
protected:
    template <typename Add>
    void build(const Add& add) {
        add_object(world_, support::floor_with(add));
        mover_.place(state_, Vec3(0, 0.01, 0), 0.5, cache_);
        ASSERT_TRUE(state_.grounded);
    }
    void tick(const Vec3& velocity, double rate = 60.0) {
        mover_.move(state_, velocity / rate, 1.0 / rate, cache_, trace_);
    }
    bool resize(double height) {
        const auto resized = mover_.resized(state_, height, cache_);
        mover_ = resized.value_or(mover_);
        return resized.has_value();
    }
    double depth() const {
        return PenetrationOracle(world_).worst_penetration(state_.foot, 0.3, mover_.height()).depth;
    }

    World world_{std::make_unique<LinearBroadPhase>()};
    CapsuleMover mover_{world_, {}, {}};
    MoverCache cache_;
    MoverState state_;
    MoveTrace trace_;
};

TEST_F(MoverBody, AJumpIsAParabolaAtAnyRate) {
    build([](TriangleMesh&) {});
    const MoverState start = state_;
    for (const double rate : {30.0, 60.0, 120.0, 240.0}) {
        state_ = start;
        ASSERT_TRUE(mover_.jump(state_, 4.0));
        const int ticks = static_cast<int>(std::floor(2.0 * 4.0 / kStandardGravity * rate));
        for (int i = 1; i <= ticks; ++i) {
            tick({1.0, 0, 0}, rate);
            const double t = i / rate;
            ASSERT_NEAR(state_.foot.y() - start.foot.y(), 4.0 * t - 0.5 * kStandardGravity * t * t, 1e-9)
                << rate;
            ASSERT_NEAR(state_.foot.x(), t, 1e-9);
            ASSERT_FALSE(state_.grounded);
        }
        tick({1.0, 0, 0}, rate);
        EXPECT_TRUE(state_.grounded);
        EXPECT_TRUE(trace_.landed);
        EXPECT_NEAR(trace_.fall_height, 4.0 * 4.0 / (2.0 * kStandardGravity), 0.05);
    }
}

TEST_F(MoverBody, CannotJumpAgainInTheAir) {
    build([](TriangleMesh&) {});
    ASSERT_TRUE(mover_.jump(state_, 4.0));
    tick(Vec3::Zero());
    const MoverState before = state_;
    EXPECT_FALSE(mover_.jump(state_, 4.0));
    EXPECT_EQ(state_.vertical_speed, before.vertical_speed);
    EXPECT_EQ(state_.foot, before.foot);
}

TEST_F(MoverBody, JumpsOntoABlockTooHighToStepOn) {
    build([](TriangleMesh& mesh) { add_box(mesh, {1, 0, -5}, {9, 0.6, 5}); });
    for (int i = 0; i < 120; ++i) {
        tick({1.4, 0, 0});
    }
    EXPECT_LT(state_.foot.x(), 0.71);
    ASSERT_TRUE(mover_.jump(state_, 4.5));
    for (int i = 0; i < 120; ++i) {
        tick({1.4, 0, 0});
        ASSERT_LT(depth(), 1e-6);
    }
    EXPECT_GT(state_.foot.x(), 1.5);
    EXPECT_NEAR(state_.foot.y(), 0.6, 0.001);
    EXPECT_TRUE(state_.grounded);
}

TEST_F(MoverBody, PassesCrouchedUnderABeamThatStopsItUpright) {
    build([](TriangleMesh& mesh) { add_box(mesh, {1, 1.3, -5}, {3, 2.0, 5}); });
    for (int i = 0; i < 180; ++i) {
        tick({1.4, 0, 0});
    }
    EXPECT_LT(state_.foot.x(), 0.71) << "too tall";
    ASSERT_TRUE(resize(1.2));
    EXPECT_EQ(mover_.height(), 1.2);
    for (int i = 0; i < 60; ++i) {
        tick({1.4, 0, 0});
        ASSERT_LT(depth(), 1e-6);
    }
    EXPECT_NEAR(state_.foot.x(), 2.1, 0.02);
    const Vec3 foot = state_.foot;
    EXPECT_FALSE(resize(1.8)) << "no headroom";
    EXPECT_EQ(mover_.height(), 1.2);
    EXPECT_EQ(state_.foot, foot);
    for (int i = 0; i < 90; ++i) {
        tick({1.4, 0, 0});
    }
    EXPECT_GT(state_.foot.x(), 4.0) << "it walks on crouched";
    EXPECT_TRUE(resize(1.8));
    EXPECT_LT(depth(), 1e-6);
}

TEST_F(MoverBody, StandsUpOnlyWithEnoughHeadroom) {
    build([](TriangleMesh& mesh) { add_box(mesh, {1, 1.6, -5}, {3, 2.0, 5}); });
    ASSERT_TRUE(resize(1.0));
    for (int i = 0; i < 90; ++i) {
        tick({1.4, 0, 0});
    }
    EXPECT_FALSE(resize(1.7));
    EXPECT_FALSE(resize(1.6)) << "it floats a tenth of a millimetre above the floor";
    EXPECT_TRUE(resize(1.599));
    EXPECT_LT(depth(), 1e-6);
}

TEST_F(MoverBody, SeesANewObjectOnceItsCacheIsCleared) {
    Object wall;
    wall.shape = Box{{0.1, 1.0, 5.0}};
    wall.X_world_shape.translation = {1.5, 1.0, 0};
    wall.layer = 3;
    world_.add(wall);
    build([](TriangleMesh&) {});
    for (int i = 0; i < 120; ++i) {
        tick({1.4, 0, 0});
    }
    EXPECT_NEAR(state_.foot.x(), 1.4 - 0.32, 1e-3);
    Object near_wall = wall;
    near_wall.X_world_shape.translation = {-0.5, 1.0, 0};
    world_.add(near_wall);  // as if it had been enabled
    cache_.clear();
    for (int i = 0; i < 120; ++i) {
        tick({-1.4, 0, 0});
    }
    EXPECT_NEAR(state_.foot.x(), -0.4 + 0.32, 1e-3);
}

}  // namespace
}  // namespace campuswalk::collision

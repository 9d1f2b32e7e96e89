#include <algorithm>
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "tests/collision/course/course_scene.h"
#include "tests/support/penetration_oracle.h"

/// The course's jumps and crouches.
namespace campuswalk::collision::course {
namespace {

constexpr double kGravity = 9.81;

/// Uses a mover directly, because its height changes: the oracle is passed the current height.
class CourseBody : public ::testing::Test {
protected:
    void start(const World& world, const Vec3& foot) {
        world_ = &world;
        oracle_.emplace(world);
        mover_.emplace(world, MoverSettings{}, QueryFilter{});
        cache_.clear();
        mover_->place(state_, foot, 0.5, cache_);
    }
    void tick(const Vec3& velocity, double rate = 60.0) {
        mover_->move(state_, velocity / rate, 1.0 / rate, cache_, trace_);
        ASSERT_LE(oracle_->worst_penetration(state_.foot, kRadius, mover_->height()).depth, 1e-6);
        for (std::size_t i = 1; i < trace_.path.size(); ++i) {
            ASSERT_FALSE(oracle_->crossed(trace_.path[i - 1], trace_.path[i], kRadius, mover_->height()));
        }
    }
    bool resize(double height) {
        const auto resized = mover_->resized(state_, height, cache_);
        mover_ = resized.value_or(*mover_);
        return resized.has_value();
    }
    void walk(const Vec3& velocity, double seconds) {
        for (int i = 0; i < 60.0 * seconds; ++i) {
            ASSERT_NO_FATAL_FAILURE(tick(velocity));
        }
    }

    const World* world_ = nullptr;
    std::optional<support::PenetrationOracle> oracle_;
    std::optional<CapsuleMover> mover_;
    MoverCache cache_;
    MoverState state_;
    MoveTrace trace_;
};

TEST_F(CourseBody, JumpsOnTheParabolaAtEveryTickRate) {
    const auto world = floor_world();
    for (const double rate : {30.0, 60.0, 120.0, 240.0}) {
        for (const double speed : {2.0, 4.5}) {
            SCOPED_TRACE(testing::Message() << rate << " Hz, " << speed << " m/s");
            start(*world, {0, 0.01, 0});  // placed, it rests where it will land
            const double ground = state_.foot.y();
            ASSERT_TRUE(mover_->jump(state_, speed));
            ASSERT_FALSE(mover_->jump(state_, speed)) << "not again in the air";
            int tick_number = 1;
            for (; tick_number / rate < 2.0 * speed / kGravity; ++tick_number) {
                const double t = tick_number / rate;
                ASSERT_NO_FATAL_FAILURE(tick(kEast, rate));
                ASSERT_NEAR(state_.foot.y(), ground + speed * t - 0.5 * kGravity * t * t, 1e-9);
                ASSERT_NEAR(state_.foot.x(), kPace * t, 1e-9);
            }
            ASSERT_NO_FATAL_FAILURE(tick(kEast, rate));
            EXPECT_TRUE(state_.grounded);
            EXPECT_TRUE(trace_.landed);
            EXPECT_NEAR(trace_.fall_height, 0.5 * speed * speed / kGravity, 0.5 * kGravity / rate / rate);
        }
    }
}

/// A block too high to step on may be low enough to jump on.
TEST_F(CourseBody, JumpsOntoABlockItCannotClimb) {
    const auto world = floor_and([](TriangleMesh& mesh) { support::add_box(mesh, {1, 0, -3}, {5, 0.6, 3}); });
    start(*world, {0, 0, 0});
    ASSERT_NO_FATAL_FAILURE(walk(kEast, 1.0));
    EXPECT_LT(state_.foot.x(), 0.7);
    ASSERT_TRUE(mover_->jump(state_, 4.2));  // 0.9 m
    ASSERT_NO_FATAL_FAILURE(walk(kEast, 1.5));
    EXPECT_NEAR(state_.foot.y(), 0.6, 1e-3);
    EXPECT_TRUE(state_.grounded);
}

TEST_F(CourseBody, AJumpEndsAtTheCeilingAndFallsImmediately) {
    const auto world = floor_and([](TriangleMesh& mesh) {
        support::add_box(mesh, {-3, 2, -3}, {3, 2.2, 3});
    });
    start(*world, {0, 0, 0});
    ASSERT_TRUE(mover_->jump(state_, 5.0));
    double highest = 0.0;
    int ticks = 0;
    for (; !state_.grounded && ticks < 120; ++ticks) {
        ASSERT_NO_FATAL_FAILURE(tick(Vec3::Zero()));
        highest = std::max(highest, state_.foot.y());
    }
    EXPECT_NEAR(highest, 0.2, 2e-3);
    EXPECT_LT(ticks / 60.0, 0.04 + std::sqrt(2.0 * 0.2 / kGravity) + 2.0 / 60.0);
}

TEST_F(CourseBody, CrouchesUnderALowDoorAndStandsUpBehindIt) {
    const auto world = floor_and([](TriangleMesh& mesh) {
        support::add_box(mesh, {1, 1.3, -3}, {3, 2.5, 3});
    });
    start(*world, {0, 0, 0});
    ASSERT_NO_FATAL_FAILURE(walk(kEast, 2.0));
    EXPECT_LT(state_.foot.x(), 1.0) << "upright it doesn't fit";
    const Vec3 foot = state_.foot;
    ASSERT_TRUE(resize(1.2));
    EXPECT_EQ(mover_->height(), 1.2);
    EXPECT_EQ(state_.foot, foot);
    ASSERT_NO_FATAL_FAILURE(walk(kEast, 1.0));
    EXPECT_NEAR(state_.foot.x(), foot.x() + kPace, 1e-3);
    EXPECT_FALSE(resize(1.8)) << "no headroom";
    EXPECT_EQ(mover_->height(), 1.2);
    ASSERT_NO_FATAL_FAILURE(walk(kEast, 1.5));
    ASSERT_TRUE(resize(1.8));
    ASSERT_NO_FATAL_FAILURE(walk(-kEast, 2.0));
    EXPECT_GT(state_.foot.x(), 3.0) << "it doesn't fit on the way back";
}

}  // namespace
}  // namespace campuswalk::collision::course

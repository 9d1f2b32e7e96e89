#include <cmath>
#include <ostream>

#include <gtest/gtest.h>

#include "tests/collision/course/course_scene.h"
#include "tests/support/angles.h"
#include "tests/support/course/profile.h"

/// The course's ground: the foot follows it like a ball rolling over it, at full horizontal speed.
namespace campuswalk::collision::course {
namespace {

using support::Profile;
using support::radians;
using support::rolled_height;

/// How far the foot may be above the ball that rolls over the ground, metres.
constexpr double kFollows = 2e-3;

struct Ground {
    const char* name = "";
    Profile profile;
    double from = 0.0;  ///< x
    double to = 0.0;
    double speed = kPace;
};

std::unique_ptr<World> world_of(const Profile& profile) {
    auto world = empty_world();
    TriangleMesh mesh;
    support::add_profile(mesh, profile, 2.5);
    support::add_object(*world, std::move(mesh));
    return world;
}

/// Once across the ground, straight or at an angle; x must be right at every tick.
void cross(AuditedBody& body, const Ground& ground, double from, double to, double sideways) {
    const double heading = to > from ? 1.0 : -1.0;
    const Vec3 velocity(heading * ground.speed, 0, sideways * ground.speed);
    const double start_height = rolled_height(ground.profile, from, kRadius);
    body.stand({from, start_height + 0.01, -sideways}, 0.1);
    ASSERT_TRUE(body.state().grounded);
    const double per_tick = ground.speed / body.ticks_per_second;
    const int ticks = static_cast<int>(std::abs(to - from) / per_tick);
    for (int i = 1; i <= ticks; ++i) {
        ASSERT_NO_FATAL_FAILURE(body.tick(velocity));
        ASSERT_NEAR(body.foot().x(), from + heading * i * per_tick, 1e-6) << "held back";
        const double rolled = rolled_height(ground.profile, body.foot().x(), kRadius);
        ASSERT_NEAR(body.foot().y(), rolled, kFollows) << "at x = " << body.foot().x();
    }
    EXPECT_EQ(body.ticks_in_air(), 0);
}

void PrintTo(const Ground& ground, std::ostream* out) {
    *out << ground.name;
}

class CourseGround : public ::testing::TestWithParam<Ground> {};

TEST_P(CourseGround, IsFollowedInBothDirectionsAtFullSpeed) {
    const Ground& ground = GetParam();
    const auto world = world_of(ground.profile);
    AuditedBody body(*world);
    for (const double rate : {30.0, 60.0, 120.0, 240.0}) {
        for (const double offset : {0.0, 0.3}) {
            SCOPED_TRACE(testing::Message() << rate << " Hz, offset " << offset);
            body.ticks_per_second = rate;
            {
                SCOPED_TRACE("east");
                ASSERT_NO_FATAL_FAILURE(cross(body, ground, ground.from, ground.to, offset));
            }
            SCOPED_TRACE("west");
            ASSERT_NO_FATAL_FAILURE(cross(body, ground, ground.to, ground.from, offset));
        }
    }
}

Ground ramp_of(const char* name, double degrees) {
    return {name, support::ramp(0.0, degrees, 2.0), -0.8, 2.8};
}

INSTANTIATE_TEST_SUITE_P(
    Grounds, CourseGround,
    ::testing::Values(ramp_of("ramp_5", 5.0), ramp_of("ramp_15", 15.0), ramp_of("ramp_30", 30.0),
                      ramp_of("ramp_40", 40.0), ramp_of("ramp_45", 45.0), ramp_of("ramp_49", 49.0),
                      Ground{"kerb_12", support::flight(0.0, 0.12, 0.3, 1), -1.0, 1.0},
                      Ground{"flight_17", support::flight(0.0, 0.17, 0.28, 5), -0.8, 2.0},
                      Ground{"flight_10", support::flight(0.0, 0.10, 0.35, 5), -0.8, 2.2},
                      Ground{"flight_25", support::flight(0.0, 0.25, 0.25, 5), -0.8, 1.8},
                      Ground{"ridge_20", {{-3, 0}, {0, 0}, {1.5, 0.546}, {3, 0}, {6, 0}}, -1.0, 4.0},
                      Ground{"ridge_45", {{-3, 0}, {0, 0}, {1.5, 1.5}, {3, 0}, {6, 0}}, -1.0, 4.0},
                      Ground{"valley_20", {{-3, 0}, {0, 0}, {1.5, -0.546}, {3, 0}, {6, 0}}, -1.0, 4.0},
                      Ground{"valley_45", {{-3, 0}, {0, 0}, {1.5, -1.5}, {3, 0}, {6, 0}}, -1.0, 4.0},
                      Ground{"narrow_ditch", {{-3, 0}, {0, 0}, {0.1, -0.8}, {0.2, 0}, {3, 0}}, -1.0, 1.2},
                      Ground{"bumps", support::waves(0.5, 0.06, 5, 6), -0.5, 3.0},
                      Ground{"hills", support::waves(4.0, 0.8, 1, 40), -0.5, 4.5},
                      Ground{"hills_running", support::waves(4.0, 0.8, 1, 40), -0.5, 4.5, 4.0}),
    [](const auto& test) { return std::string(test.param.name); });

/// The body's lower sphere rolls over the ball with its centre at the sum of the radii.
TEST(CourseGrounds, SpheresAreFollowedInTheirRoundShape) {
    for (const double ball : {1.0, 5.0, 60.0}) {
        SCOPED_TRACE(ball);
        const double top = std::min(0.25, 0.2 * ball);
        const auto world = floor_world();
        support::add_object(*world, Sphere{ball}, {2.0, top - ball, 0});
        AuditedBody body(*world);
        const double half = std::sqrt(ball * ball - (ball - top) * (ball - top));
        const double start = std::max(-19.0, 2.0 - half - 1.0);
        body.stand({start, 0.5, 0}, 1.0);
        for (int i = 1; i <= 300 && body.foot().x() < 2.0 + half + 0.5; ++i) {
            ASSERT_NO_FATAL_FAILURE(body.tick(kEast));
            ASSERT_NEAR(body.foot().x(), start + i * kPace / 60.0, 1e-6);
            const double x = body.foot().x() - 2.0;
            const double both = ball + kRadius;
            const double over_ball = top - ball - kRadius + std::sqrt(std::max(0.0, both * both - x * x));
            ASSERT_NEAR(body.foot().y(), std::max(0.0, over_ball), kFollows) << "at " << x;
        }
        EXPECT_EQ(body.ticks_in_air(), 0);
    }
}

/// On any walkable slope, even after walking, a body at rest keeps its position bit for bit.
TEST(CourseGrounds, ABodyAtRestDoesNotCreep) {
    for (const double degrees : {5.0, 20.0, 35.0, 45.0, 49.5}) {
        const auto world = world_of(support::ramp(0.0, degrees, 3.0));
        AuditedBody body(*world);
        for (const double rate : {30.0, 240.0}) {
            for (const double heading : {0.0, 60.0, 90.0, 180.0}) {
                SCOPED_TRACE(testing::Message() << degrees << " degrees, walked at " << heading);
                body.ticks_per_second = rate;
                body.stand({1.5, 4.0, 0}, 4.5);
                ASSERT_TRUE(body.state().grounded);
                ASSERT_NO_FATAL_FAILURE(body.walk(kPace * towards(heading), 0.5));
                EXPECT_EQ(jitter(body, Vec3::Zero(), 5.0), 0.0);
                EXPECT_EQ(body.ticks_in_air(), 0);
            }
        }
    }
}

/// From below, a ramp beyond the limit is a wall.
TEST(CourseGrounds, SlopesBeyondTheLimitAreNotClimbed) {
    for (const double degrees : {51.0, 55.0, 60.0, 75.0}) {
        SCOPED_TRACE(degrees);
        const auto world = world_of(support::ramp(0.0, degrees, 2.0));
        AuditedBody body(*world);
        for (const double heading : {0.0, 40.0}) {
            body.stand({-1, 0, 0});
            ASSERT_NO_FATAL_FAILURE(body.walk(kPace * towards(heading), 1.5));
            EXPECT_LT(body.foot().x(), 0.0);
            EXPECT_NEAR(body.foot().y(), 0.0, 5e-3);
        }
        body.stand({-1, 0, 0});
        ASSERT_NO_FATAL_FAILURE(body.walk(kEast, 3.0));
        EXPECT_LE(jitter(body, kEast, 1.0), 5e-4);
    }
}

/// From above it is a slide, at most as fast as without friction and at least half as fast.
TEST(CourseGrounds, SlopesBeyondTheLimitAreSlidDown) {
    for (const double degrees : {51.0, 55.0, 60.0, 75.0}) {
        const double run = 6.0 / std::tan(radians(degrees));
        const auto world = world_of(support::ramp(0.0, degrees, run));
        AuditedBody body(*world);
        for (const double rate : {30.0, 60.0, 240.0}) {
            SCOPED_TRACE(testing::Message() << degrees << " degrees, " << rate << " Hz");
            body.ticks_per_second = rate;
            body.stand({0.5 * run, 4.0, 0}, 1.1);
            ASSERT_NO_FATAL_FAILURE(body.tick(Vec3::Zero()));
            const double high = body.foot().y();
            double last = high;
            int ticks = 1;
            for (; last > 0.01 && ticks < 10.0 * rate; ++ticks) {
                ASSERT_NO_FATAL_FAILURE(body.tick(Vec3::Zero()));
                ASSERT_LE(body.foot().y(), last + 1e-9) << "only ever down";
                last = body.foot().y();
            }
            const double frictionless = std::sqrt(2.0 * high / 9.81) / std::sin(radians(degrees));
            EXPECT_GE(ticks / rate, 0.8 * frictionless) << "it begins with a fall of half a metre or so";
            EXPECT_LE(ticks / rate, 2.0 * frictionless);
            ASSERT_NO_FATAL_FAILURE(body.walk(Vec3::Zero(), 1.0));
            EXPECT_TRUE(body.state().grounded);
            EXPECT_NEAR(body.foot().y(), 0.0, 5e-3);
        }
    }
}

}  // namespace
}  // namespace campuswalk::collision::course

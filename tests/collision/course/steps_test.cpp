#include <cmath>
#include <ostream>

#include <gtest/gtest.h>

#include "tests/collision/course/course_scene.h"
#include "tests/support/angles.h"
#include "tests/support/course/profile.h"
#include "tests/support/effort.h"

/// The course's risers: one 5 mm or more above the step height is never climbed, one 5 mm or more below it
/// always, by any body from any direction.
namespace campuswalk::collision::course {
namespace {

using support::add_box;
using support::radians;

constexpr double kTolerance = 5e-3;

struct StepBody {
    double radius = 0.0;
    double step_height = 0.0;
};

constexpr double kTread = 0.25;

/// Steps up from a level floor at x = 1, the last one deep: boxes as meshes or as convex solids.
struct Steps {
    double high = 0.0;
    int count = 1;
    bool solid = false;
};

std::unique_ptr<World> world_of(const Steps& steps) {
    auto world = floor_world();
    for (int i = 0; i < steps.count; ++i) {
        const double depth = i + 1 < steps.count ? kTread : 3.0;
        const double x = 1.0 + i * kTread;
        const double top = (i + 1) * steps.high;
        if (steps.solid) {
            support::add_object(*world, Box{{0.5 * depth, 0.5 * top, 6.0}}, {x + 0.5 * depth, 0.5 * top, 0});
        } else {
            TriangleMesh mesh;
            add_box(mesh, {x, 0, -6}, {x + depth, top, 6});
            support::add_object(*world, std::move(mesh));
        }
    }
    return world;
}

void approach(const StepBody& limits, const Steps& steps, bool climbed) {
    const auto world = world_of(steps);
    MoverSettings settings;
    settings.radius = limits.radius;
    settings.step_height = limits.step_height;
    AuditedBody body(*world, settings);
    for (const double rate : {30.0, 60.0, 240.0}) {
        for (const double degrees : {0.0, 20.0, 45.0}) {
            for (const double speed : {0.4, 1.4, 4.0}) {
                if ((support::kSanitized || steps.solid) && (rate != 60.0 || speed != 1.4)) {
                    continue;  // the search for a convex box's nearest point is slow
                }
                SCOPED_TRACE(testing::Message() << steps.count << " of " << steps.high << " m, " << rate
                                                << " Hz, at " << degrees << ", " << speed << " m/s");
                body.ticks_per_second = rate;
                body.stand({0.5, 0, 0});
                const double far = (0.5 + 2.0 * kTread + 1.0) / std::cos(radians(degrees));
                ASSERT_NO_FATAL_FAILURE(body.walk(speed * towards(degrees), far / speed));
                if (climbed) {
                    EXPECT_NEAR(body.foot().x(), 2.5, 0.1);
                    EXPECT_NEAR(body.foot().y(), steps.count * steps.high, 2e-3);
                } else {
                    EXPECT_LT(body.foot().x(), 1.0);
                    EXPECT_NEAR(body.foot().y(), 0.0, 1e-3);
                }
            }
        }
    }
}

void PrintTo(const StepBody& limits, std::ostream* out) {
    *out << "radius " << limits.radius << ", step height " << limits.step_height;
}

class CourseRisers : public ::testing::TestWithParam<StepBody> {};

TEST_P(CourseRisers, AreClimbedUpToTheStepHeightAndNoHigher) {
    const double limit = GetParam().step_height;
    for (const double high :
         {0.10, 0.15, 0.20, 0.25, 0.30, 0.35, 0.40, 0.45, limit - kTolerance, limit + kTolerance}) {
        if (std::abs(high - limit) > 0.9 * kTolerance) {
            ASSERT_NO_FATAL_FAILURE(approach(GetParam(), {high, 1, false}, high < limit));
        }
    }
    ASSERT_NO_FATAL_FAILURE(approach(GetParam(), {limit - kTolerance, 1, true}, true));
    ASSERT_NO_FATAL_FAILURE(approach(GetParam(), {limit + kTolerance, 1, true}, false));
}

/// On the edge of a tread the round body stands a little lower than on the tread: that doesn't make the next
/// riser higher.
TEST_P(CourseRisers, AreClimbedOneAfterTheOther) {
    for (const bool solid : {false, true}) {
        const double high = GetParam().step_height - kTolerance;
        ASSERT_NO_FATAL_FAILURE(approach(GetParam(), {high, 3, solid}, true));
    }
}

INSTANTIATE_TEST_SUITE_P(Bodies, CourseRisers,
                         ::testing::Values(StepBody{0.3, 0.3}, StepBody{0.3, 0.4}, StepBody{0.3, 0.15},
                                           StepBody{0.2, 0.3}, StepBody{0.4, 0.22}),
                         [](const auto& test) {
                             return "r" + std::to_string(std::lround(100 * test.param.radius)) + "_step" +
                                    std::to_string(std::lround(100 * test.param.step_height));
                         });

/// Twenty risers, up and down, take at most 3 % longer than level ground, and no tick jumps.
TEST(CourseSteps, TwentyRisersTakeAsLongAsLevelGround) {
    struct Flight {
        double riser = 0.0;
        double tread = 0.0;
    };
    for (const Flight& stair :
         {Flight{0.15, 0.32}, Flight{0.17, 0.28}, Flight{0.20, 0.25}, Flight{0.28, 0.25}}) {
        for (const double rate : {30.0, 60.0, 120.0, 240.0}) {
            SCOPED_TRACE(testing::Message() << stair.riser << " by " << stair.tread << ", " << rate << " Hz");
            const auto profile = support::flight(0.0, stair.riser, stair.tread, 20);
            auto world = empty_world();
            TriangleMesh mesh;
            support::add_profile(mesh, profile, 2.0);
            support::add_object(*world, std::move(mesh));
            AuditedBody body(*world);
            body.ticks_per_second = rate;
            const double far = 20 * stair.tread + 2.0;
            for (const bool up : {true, false}) {
                const double from = up ? -1.0 : far - 1.0;
                body.stand({from, support::rolled_height(profile, from, kRadius) + 0.01, 0});
                const auto flat_ticks = static_cast<int>(std::ceil(far / kPace * rate));
                int ticks = 0;
                double steepest = 0.0;
                while (std::abs(body.foot().x() - from) < far && ticks < 2 * flat_ticks) {
                    const double before = body.foot().y();
                    ASSERT_NO_FATAL_FAILURE(body.tick(up ? kEast : Vec3(-kEast)));
                    steepest = std::max(steepest, std::abs(body.foot().y() - before));
                    ++ticks;
                }
                EXPECT_LE(ticks, 1.03 * flat_ticks + 1) << (up ? "up" : "down");
                EXPECT_EQ(body.ticks_in_air(), 0);
                // A ball that hits an edge at its own height rises by sqrt(2 r d) over the first d.
                EXPECT_LE(steepest, std::sqrt(2.0 * kRadius * kPace / rate) + 1e-3) << "the height jumps";
            }
        }
    }
}

/// A riser that it could climb, under a slab that leaves no room for it there.
TEST(CourseSteps, ARiserWithoutHeadroomIsAWall) {
    for (const double riser : {0.1, 0.25}) {
        for (const double room : {-0.05, 0.03}) {
            SCOPED_TRACE(testing::Message() << riser << " m, headroom " << room << " m");
            const auto world = floor_and([&](TriangleMesh& mesh) {
                add_box(mesh, {1, 0, -3}, {4, riser, 3});
                const double slab = riser + kHeight + room;
                add_box(mesh, {1, slab, -3}, {4, slab + 0.3, 3});
            });
            AuditedBody body(*world);
            body.stand({0, 0, 0});
            ASSERT_NO_FATAL_FAILURE(body.walk(kEast, 4.0));
            if (room > 0.0) {
                EXPECT_NEAR(body.foot().x(), 4.0 * kPace, 1e-6);
            } else {
                EXPECT_LT(body.foot().x(), 1.0);
                EXPECT_LE(jitter(body, kEast, 1.0), 5e-4);
                ASSERT_NO_FATAL_FAILURE(body.walk(-kEast, 0.5));
                EXPECT_NEAR(body.foot().y(), 0.0, 1e-3);
            }
        }
    }
}

/// Along and over a kerb, from the road to the pavement and back, at a grazing angle.
TEST(CourseSteps, KerbsAreCrossedAtAnyAngle) {
    const auto world = floor_and([](TriangleMesh& mesh) { add_box(mesh, {-15, 0, -6}, {15, 0.12, 0}); });
    AuditedBody body(*world);
    for (const double degrees : {3.0, 10.0, 45.0, 90.0}) {
        SCOPED_TRACE(degrees);
        body.stand({-8, 0, 0.4});
        const Vec3 desired = kPace * towards(degrees);
        const double seconds = std::min(10.0, 2.0 / desired.head<3>().dot(Vec3(0, 0, -1)));
        ASSERT_NO_FATAL_FAILURE(body.walk(desired, seconds));
        EXPECT_NEAR((body.foot() - Vec3(-8, body.foot().y(), 0.4) - seconds * desired).norm(), 0.0, 0.02);
        ASSERT_NO_FATAL_FAILURE(body.walk(Vec3(desired.x(), 0, -desired.z()), seconds));
        EXPECT_NEAR(body.foot().z(), 0.4, 0.02);
        EXPECT_NEAR(body.foot().y(), 0.0, 1e-3);
        EXPECT_EQ(body.ticks_in_air(), 0);
    }
}

}  // namespace
}  // namespace campuswalk::collision::course

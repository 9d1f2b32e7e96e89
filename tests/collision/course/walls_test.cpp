#include "tests/support/course/walls.h"

#include <algorithm>
#include <cmath>
#include <ostream>

#include <gtest/gtest.h>

#include "tests/collision/course/course_scene.h"
#include "tests/support/angles.h"
#include "tests/support/effort.h"

/// The course's walls: none is passed through at any speed, and only the angle costs speed.
namespace campuswalk::collision::course {
namespace {

using support::radians;

/// How a wall is built.
struct WallKind {
    const char* name = "";
    void (*add)(World& world, double length, const Pose& X_world_wall) = nullptr;
};

/// 0.5 to 100 m/s at 30 to 240 ticks per second, straight and at an angle.
TEST(CourseWalls, NoneIsPassedThrough) {
    for (const double thickness : {0.2, 0.02, 0.0}) {
        const auto world = floor_and(
            [&](TriangleMesh& mesh) { support::add_barrier(mesh, 1.0, thickness, 15.0, 0.0, 3.0); });
        AuditedBody body(*world);
        for (const double rate : {30.0, 60.0, 120.0, 240.0}) {
            for (const double speed : {0.5, 1.4, 5.0, 20.0, 100.0}) {
                for (const double degrees : {0.0, 35.0}) {
                    SCOPED_TRACE(testing::Message() << thickness << " m thick, " << speed << " m/s, " << rate
                                                    << " Hz, " << degrees << " degrees");
                    body.ticks_per_second = rate;
                    body.stand({0, 0, 0});
                    const double seconds = std::max(2.0 / rate, 1.5 / speed);
                    ASSERT_NO_FATAL_FAILURE(body.walk(speed * towards(degrees), seconds));
                    EXPECT_NEAR(body.foot().x(), 1.0 - kRadius - kSkin, 1e-3);
                    EXPECT_TRUE(body.state().grounded);
                }
            }
        }
    }
}

void PrintTo(const WallKind& kind, std::ostream* out) {
    *out << kind.name;
}

class CourseAlongWalls : public ::testing::TestWithParam<WallKind> {};

/// A desired displacement at an angle to the wall keeps its cosine, whatever the wall's heading, with or
/// without seams.
TEST_P(CourseAlongWalls, SlidingKeepsTheCosineOfTheSpeed) {
    // The search for a convex box's nearest point is slow.
    const double every = support::kSanitized                            ? 20.0
                         : GetParam().add == support::add_wall_of_boxes ? 10.0
                                                                        : 5.0;
    for (const double heading : {0.0, 26.565, 73.0}) {
        auto world = floor_world();
        GetParam().add(*world, 10.0, {support::turn(Vec3::UnitY(), radians(heading)), Vec3::Zero()});
        AuditedBody body(*world);
        const Vec3 along = towards(heading);
        const Vec3 out = towards(heading - 90.0);
        for (int i = 0; 5.0 + i * every < 90.0; ++i) {
            const double degrees = 5.0 + i * every;
            SCOPED_TRACE(testing::Message() << "wall at " << heading << ", walking at " << degrees);
            body.stand(-3.0 * along + (kRadius + kSkin + 0.01) * out);
            const Vec3 desired = 3.0 * towards(heading + degrees);
            ASSERT_NO_FATAL_FAILURE(body.walk(desired, 0.2));
            const Vec3 start = body.foot();
            const double seconds = every > 5.0 ? 0.5 : 1.5;
            ASSERT_NO_FATAL_FAILURE(body.walk(desired, seconds));
            const double free = 3.0 * seconds * std::cos(radians(degrees));
            EXPECT_NEAR((body.foot() - start).dot(along), free, 0.01 * free);
            EXPECT_LE(body.foot().dot(out), kRadius + kSkin + 1e-3) << "it left the wall";
            EXPECT_EQ(body.ticks_in_air(), 0);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, CourseAlongWalls,
                         ::testing::Values(WallKind{"plain", support::add_plain_wall},
                                           WallKind{"butted", support::add_butted_wall},
                                           WallKind{"tessellated", support::add_tessellated_wall},
                                           WallKind{"sheets", support::add_wall_of_sheets},
                                           WallKind{"boxes", support::add_wall_of_boxes}),
                         [](const auto& test) { return std::string(test.param.name); });

/// However a walk leads into a wedge, the body comes to rest there and leaves again without delay.
TEST(CourseWalls, AcuteWedgesHoldTheBodyStill) {
    for (const double degrees : {15.0, 30.0, 45.0, 60.0, 75.0, 90.0}) {
        const auto world = floor_and([&](TriangleMesh& mesh) { support::add_wedge(mesh, degrees); });
        AuditedBody body(*world);
        for (const double rate : {30.0, 60.0, 240.0}) {
            // Within half the wedge's angle, the body can't slide out along either wall.
            for (const double part : {0.0, 0.3, -0.6}) {
                SCOPED_TRACE(testing::Message() << degrees << " degrees, " << rate << " Hz, walking at "
                                                << part << " of the half");
                body.ticks_per_second = rate;
                const double there = (kRadius + kSkin) / std::sin(radians(0.5 * degrees));
                body.stand({-there - 0.8, 0, 0});
                const Vec3 desired = kPace * towards(0.5 * part * degrees);
                ASSERT_NO_FATAL_FAILURE(body.walk(desired, 4.0));
                EXPECT_NEAR(body.foot().x(), -there, 0.01);
                EXPECT_LE(jitter(body, desired, 2.0), 5e-4);
                const double tip = body.foot().x();
                ASSERT_NO_FATAL_FAILURE(body.walk(-kEast, 0.5));
                EXPECT_NEAR(tip - body.foot().x(), 0.5 * kPace, 0.01) << "not sticky";
            }
        }
    }
}

}  // namespace
}  // namespace campuswalk::collision::course

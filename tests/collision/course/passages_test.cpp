#include <cmath>

#include <gtest/gtest.h>

#include "tests/collision/course/course_scene.h"
#include "tests/support/angles.h"
#include "tests/support/course/walls.h"

/// The course's narrow places: the body passes where there is room, and stops without jitter where there
/// isn't.
namespace campuswalk::collision::course {
namespace {

using support::add_quad;
using support::radians;

/// Doors of 0.7 to 1 m in walls of any thickness: at full speed through the middle, past the posts from
/// off-centre.
TEST(CoursePassages, WideEnoughDoorwaysArePassed) {
    for (const double width : {0.7, 0.8, 0.9, 1.0}) {
        for (const double thickness : {0.0, 0.2, 1.5}) {
            SCOPED_TRACE(testing::Message() << width << " m wide, " << thickness << " m thick");
            const auto world = floor_and(
                [&](TriangleMesh& mesh) { support::add_doorway(mesh, 2.0, thickness, width, 2.0); });
            AuditedBody body(*world);
            const double room = 0.5 * width - kRadius - kSkin;
            for (const double offset : {0.0, 0.9 * room, -0.9 * room}) {
                body.stand({0, 0, offset});
                ASSERT_NO_FATAL_FAILURE(body.walk(kEast, 4.0));
                EXPECT_NEAR(body.foot().x(), 4.0 * kPace, 1e-6) << offset << " m from the middle";
            }
            for (const double offset : {-0.9, -0.45, 0.3, 0.7}) {
                body.stand({0.5, 0, offset});
                EXPECT_TRUE(reach(body, {2.0 + 0.5 * thickness, 0, 0}, kPace, 10.0)) << "from " << offset;
                EXPECT_TRUE(reach(body, {5.0, 0, -0.5 * offset}, kPace, 10.0)) << "from " << offset;
            }
        }
    }
}

TEST(CoursePassages, DoorwaysTooLowOrTooNarrowStopTheBody) {
    struct Opening {
        double width = 0.0;
        double high = 0.0;
        bool passed = false;
    };
    for (const Opening& door : {Opening{0.9, 1.83, true}, Opening{0.9, 1.9, true}, Opening{0.66, 2.0, true},
                                Opening{0.9, 1.78, false}, Opening{0.9, 1.5, false}, Opening{0.9, 0.6, false},
                                Opening{0.58, 2.0, false}, Opening{0.4, 2.0, false}}) {
        SCOPED_TRACE(testing::Message() << door.width << " m by " << door.high << " m");
        const auto world = floor_and(
            [&](TriangleMesh& mesh) { support::add_doorway(mesh, 2.0, 0.2, door.width, door.high); });
        AuditedBody body(*world);
        body.stand({0, 0, 0});
        ASSERT_NO_FATAL_FAILURE(body.walk(kEast, 3.0));
        if (door.passed) {
            EXPECT_NEAR(body.foot().x(), 3.0 * kPace, 1e-6);
        } else {
            EXPECT_LT(body.foot().x(), 2.0);
            EXPECT_LE(jitter(body, kEast, 1.0), 5e-4);
        }
        EXPECT_NEAR(body.foot().y(), 0.0, 1e-3);
    }
}

/// Two converging walls that end just wide enough for the body or narrower.
TEST(CoursePassages, NarrowingCorridorsStopTheBodyWhereItNoLongerFits) {
    for (const double end_width : {0.3, 0.5, 0.68}) {
        for (const double length : {2.0, 6.0}) {
            SCOPED_TRACE(testing::Message() << "to " << end_width << " m in " << length << " m");
            const auto world = floor_and([&](TriangleMesh& mesh) {
                for (const double side : {-1.0, 1.0}) {
                    const Vec3 a(1, 0, side * 1.0);
                    const Vec3 b(1 + length, 0, side * 0.5 * end_width);
                    const Vec3 up(0, 2.5, 0);
                    add_quad(mesh, a, b, b + up, a + up);
                    add_quad(mesh, b, b + Vec3(1, 0, 0), b + Vec3(1, 0, 0) + up, b + up);
                }
            });
            AuditedBody body(*world);
            body.stand({0, 0, 0.1});
            ASSERT_NO_FATAL_FAILURE(body.walk(2.0 * kEast, 6.0));
            if (end_width > 2.0 * (kRadius + kSkin)) {
                EXPECT_GT(body.foot().x(), 2.0 + length);
                continue;
            }
            // The walls' distance across is shorter than along z by the cosine of their slant.
            const double narrows = (1.0 - 0.5 * end_width) / length;
            const double fits = (kRadius + kSkin) * std::sqrt(1.0 + narrows * narrows);
            EXPECT_NEAR(body.foot().x(), 1.0 + (1.0 - fits) / narrows, 0.02);
            EXPECT_LE(jitter(body, 2.0 * kEast, 2.0), 5e-4);
            ASSERT_NO_FATAL_FAILURE(body.walk(-kEast, 1.0));
            EXPECT_LT(body.foot().x(), 1.0 + (1.0 - fits) / narrows - 0.9 * kPace);
        }
    }
}

/// A level or sloping ceiling: the body walks on as long as it fits, and stands still where it doesn't.
TEST(CoursePassages, CeilingsStopTheBodyWhereItNoLongerFits) {
    for (const double degrees : {0.0, 5.0, 20.0, 45.0, 70.0}) {
        for (const double low : {1.2, 1.75, 1.85}) {
            SCOPED_TRACE(testing::Message() << "from 2.6 m down to " << low << " m at " << degrees);
            const auto world = floor_and([&](TriangleMesh& mesh) {
                const double run = degrees > 0.0 ? (2.6 - low) / std::tan(radians(degrees)) : 0.0;
                add_quad(mesh, {1, 2.6, -3}, {1 + run, low, -3}, {1 + run, low, 3}, {1, 2.6, 3});
                add_quad(mesh, {1 + run, low, -3}, {9 + run, low, -3}, {9 + run, low, 3}, {1 + run, low, 3});
            });
            AuditedBody body(*world);
            body.stand({0, 0, 0});
            const double seconds = 12.0;
            ASSERT_NO_FATAL_FAILURE(body.walk(kEast, seconds));
            EXPECT_NEAR(body.foot().y(), 0.0, 1e-3);
            if (low > kHeight) {
                EXPECT_NEAR(body.foot().x(), seconds * kPace, 1e-6);
            } else {
                EXPECT_LE(jitter(body, kEast, 1.0), 5e-4);
                ASSERT_NO_FATAL_FAILURE(body.walk(-kEast, 0.5));
                EXPECT_EQ(body.ticks_in_air(), 0);
            }
        }
    }
}

/// A fall is as deep and as long as in the open, whatever wall the body presses against.
TEST(CoursePassages, LiftShaftWallsDoNotSlowAFall) {
    for (const double width : {0.7, 1.0, 1.6}) {
        const auto world = floor_and([&](TriangleMesh& mesh) {
            for (const double side : {-0.5 * width, 0.5 * width}) {
                for (int storey = 0; storey < 5; ++storey) {  // butted, as storeys are
                    const double low = 3.0 * storey;
                    add_quad(mesh, {-1, low, side}, {1, low, side}, {1, low + 3, side}, {-1, low + 3, side});
                    add_quad(mesh, {side, low, -1}, {side, low, 1}, {side, low + 3, 1}, {side, low + 3, -1});
                }
            }
        });
        AuditedBody body(*world);
        for (const double degrees : {0.0, 30.0, 45.0, 200.0}) {
            SCOPED_TRACE(testing::Message() << width << " m wide, walking at " << degrees);
            body.stand({0, 12.0, 0}, 0.1);
            for (int tick = 1; tick <= 90; ++tick) {  // 11 m
                ASSERT_NO_FATAL_FAILURE(body.tick(kPace * towards(degrees)));
                const double t = tick / 60.0;
                ASSERT_NEAR(body.foot().y(), 12.0 - 0.5 * 9.81 * t * t, 1e-6) << t << " s";
            }
            ASSERT_NO_FATAL_FAILURE(body.fall_down());
            EXPECT_NEAR(body.trace().fall_height, 12.0, 1e-2);
            ASSERT_NO_FATAL_FAILURE(body.walk(kPace * towards(degrees), 1.5));
            EXPECT_LE(jitter(body, kPace * towards(degrees), 1.0), 5e-4);
        }
    }
}

}  // namespace
}  // namespace campuswalk::collision::course

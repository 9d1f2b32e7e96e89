#include <cmath>

#include <gtest/gtest.h>

#include "tests/collision/course/course_scene.h"

/// The course's falls: the exact parabola at any tick rate.
namespace campuswalk::collision::course {
namespace {

constexpr double kFreeFall = 9.81;

TEST(CourseFalls, FollowTheParabolaAtEveryTickRate) {
    const auto world = floor_world();
    AuditedBody body(*world);
    for (const double rate : {10.0, 30.0, 60.0, 120.0, 144.0, 240.0}) {
        SCOPED_TRACE(rate);
        body.ticks_per_second = rate;
        body.stand({0, 15.0, 0}, 0.1);
        const double falls_for = std::sqrt(2.0 * 15.0 / kFreeFall);
        int tick = 1;
        for (; tick / rate < falls_for - 1e-3; ++tick) {
            ASSERT_NO_FATAL_FAILURE(body.tick(kEast));
            const double t = tick / rate;
            ASSERT_NEAR(body.foot().y(), 15.0 - 0.5 * kFreeFall * t * t, 1e-9) << t << " s";
            ASSERT_NEAR(body.state().vertical_speed, -kFreeFall * t, 1e-9);
            ASSERT_NEAR(body.foot().x(), kPace * t, 1e-9);
        }
        ASSERT_NO_FATAL_FAILURE(body.tick(kEast));
        EXPECT_TRUE(body.state().grounded) << "it lands within the tick of the impact";
        EXPECT_NEAR(body.trace().fall_height, 15.0, 1e-3);
    }
}

/// Off a ledge: where it leaves the ground and where it lands don't depend on the tick rate.
TEST(CourseFalls, OffALedgeLandInTheSamePlaceAtEveryTickRate) {
    const auto world = floor_and([](TriangleMesh& mesh) { support::add_box(mesh, {-6, 0, -3}, {0, 3, 3}); });
    AuditedBody body(*world);
    for (const double speed : {1.4, 5.0}) {
        double usual = 0.0;
        for (const double rate : {240.0, 30.0, 60.0, 120.0}) {
            SCOPED_TRACE(testing::Message() << rate << " Hz, " << speed << " m/s");
            body.ticks_per_second = rate;
            body.stand({-1, 3.01, 0});
            bool left = false;
            for (int i = 0; i < 5.0 * rate && !(left && body.state().grounded); ++i) {
                ASSERT_NO_FATAL_FAILURE(body.tick({speed, 0, 0}));
                left = left || !body.state().grounded;
            }
            ASSERT_TRUE(body.trace().landed);
            EXPECT_NEAR(body.foot().y(), 0.0, 1e-3);
            EXPECT_NEAR(body.trace().fall_height, 3.0, 0.3) << "it rolls off the edge first";
            if (rate == 240.0) {
                usual = body.foot().x();
            }
            // The landing counts at the end of its tick, the take-off at the start of one.
            EXPECT_NEAR(body.foot().x(), usual, 2.0 * speed / rate + 0.05);
        }
    }
}

/// Down onto a slope, an edge, a ball: wherever it lands, it isn't inside anything and comes to rest.
TEST(CourseFalls, EndAtRestOnAnythingBelow) {
    struct Below {
        const char* name = "";
        void (*put)(World& world) = nullptr;
    };
    const Below grounds[] = {
        {"slope",
         [](World& world) {
             TriangleMesh mesh;
             support::add_quad(mesh, {-3, 0, 3}, {3, 3, 3}, {3, 3, -3}, {-3, 0, -3});
             support::add_object(world, std::move(mesh));
         }},
        {"fence",
         [](World& world) {
             TriangleMesh mesh;
             support::add_quad(mesh, {0, 0, -3}, {0, 0, 3}, {0, 1, 3}, {0, 1, -3});
             support::add_object(world, std::move(mesh));
         }},
        {"ball",
         [](World& world) {
             support::add_object(world, Sphere{0.7}, {0, 0.5, 0});
         }},
        {"pole",
         [](World& world) {
             support::add_object(world, Capsule{0.05, 1.0}, {0.01, 1.0, 0.02});
         }},
    };
    for (const Below& below : grounds) {
        const auto world = floor_world();
        below.put(*world);
        AuditedBody body(*world);
        for (const double x : {-0.25, -0.1, 0.05, 0.2}) {
            SCOPED_TRACE(testing::Message() << below.name << ", " << x);
            body.stand({x, 8.0, 0.1}, 0.1);
            ASSERT_NO_FATAL_FAILURE(body.walk(Vec3::Zero(), 4.0));
            EXPECT_LE(jitter(body, Vec3::Zero(), 1.0), 5e-4) << "at rest";
            EXPECT_TRUE(body.state().grounded);
        }
    }
}

}  // namespace
}  // namespace campuswalk::collision::course

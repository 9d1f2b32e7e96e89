#include "collision/mover/sphere_rest.h"

#include <gtest/gtest.h>

#include "tests/support/dice.h"
#include "tests/support/effort.h"
#include "tests/support/plain_geometry.h"
#include "tests/support/random_scene.h"

#include <Eigen/Geometry>

namespace campuswalk::collision {
namespace {

using support::Dice;

Vec3 face_normal(const Triangle& t) {
    const Vec3 n = (t.b - t.a).cross(t.c - t.a);
    return n.norm() > 0.0 ? Vec3(n.normalized()) : Vec3::Zero();
}

double distance_to(const Triangle& t, const Vec3& p) {
    return support::distance(support::Line{p, p}, {t.a, t.b, t.c});
}

TEST(SphereRest, OnALevelFaceIsARadiusAboveIt) {
    const Triangle t{{0, 2, 0}, {0, 2, 5}, {5, 2, 0}};
    const auto rest = sphere_rest(t, face_normal(t), 1.0, 1.0, 0.3);
    ASSERT_TRUE(rest);
    EXPECT_NEAR(rest->height, 2.3, 1e-15);
    EXPECT_EQ(rest->on, Vec3(1, 2, 1));
    EXPECT_FALSE(sphere_rest(t, face_normal(t), -0.31, 1.0, 0.3)) << "it misses the face";
}

TEST(SphereRest, OnAnUprightFaceIsOnItsUpperEdge) {
    const Triangle t{{0, 0, -1}, {0, 1, 0}, {0, 1, -2}};
    const auto rest = sphere_rest(t, face_normal(t), 0.3, -1.0, 0.5);
    ASSERT_TRUE(rest);
    EXPECT_NEAR(rest->height, 1.4, 1e-15);
    EXPECT_TRUE(rest->on.isApprox(Vec3(0, 1, -1)));
}

/// The sphere touches at the returned height and is clear of the triangle everywhere above it.
TEST(SphereRest, IsTheHighestContactWithRandomTriangles) {
    Dice dice(1);
    int found = 0;
    for (int i = 0; i < support::repeats(20000); ++i) {
        const Triangle t = support::random_triangle(dice, Vec3::Zero());
        const double radius = dice.between(0.05, 0.6);
        const double x = dice.between(-1.2, 1.2);
        const double z = dice.between(-1.2, 1.2);
        SCOPED_TRACE(i);
        const auto rest = sphere_rest(t, face_normal(t), x, z, radius);
        const double top = std::max({t.a.y(), t.b.y(), t.c.y()});
        if (rest) {
            ++found;
            ASSERT_NEAR(distance_to(t, {x, rest->height, z}), radius, 1e-5);
            ASSERT_NEAR((rest->on - Vec3(x, rest->height, z)).norm(), radius, 1e-5);
            ASSERT_LT(distance_to(t, rest->on), 1e-5);
        }
        const double from = rest ? rest->height + 1e-4 : std::min({t.a.y(), t.b.y(), t.c.y()}) - radius;
        for (int k = 0; k <= 50; ++k) {
            const double y = from + k / 50.0 * (top + radius - from);
            ASSERT_GT(distance_to(t, {x, y, z}), radius - 1e-7) << y;
        }
    }
    EXPECT_GT(found, support::repeats(20000) / 5);
}

TEST(SphereRest, IsTheSameToTheLastBitWhereItIsUseful) {
    Dice dice(2);
    int useful = 0;
    for (int i = 0; i < support::repeats(50000); ++i) {
        const Triangle t = support::random_triangle(dice, Vec3::Zero());
        const double radius = dice.between(0.05, 0.6);
        const double x = dice.between(-1.2, 1.2);
        const double z = dice.between(-1.2, 1.2);
        SCOPED_TRACE(i);
        const auto rest = sphere_rest(t, face_normal(t), x, z, radius);
        const double least = rest && dice.chance(0.3) ? rest->height : dice.between(-1.5, 1.5);
        const auto again = sphere_rest(t, face_normal(t), x, z, radius, least);
        if (rest && rest->height >= least) {
            ++useful;
            ASSERT_TRUE(again);
            ASSERT_EQ(again->height, rest->height);
            ASSERT_EQ(again->on, rest->on);
        } else if (again) {
            ASSERT_LT(again->height, least);
        }
    }
    EXPECT_GT(useful, support::repeats(50000) / 10);
}

}  // namespace
}  // namespace campuswalk::collision

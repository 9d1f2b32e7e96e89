#include "collision/mover/upright_distance.h"

#include <gtest/gtest.h>

#include "tests/support/dice.h"
#include "tests/support/plain_geometry.h"
#include "tests/support/random_scene.h"

#include <Eigen/Geometry>

namespace campuswalk::collision {
namespace {

Obstacle obstacle(const Triangle& t) {
    Obstacle o;
    o.vertices = t;
    const Vec3 n = (t.b - t.a).cross(t.c - t.a);
    o.normal = n.norm() > 0.0 ? Vec3(n.normalized()) : Vec3::Zero();
    o.top = std::max({t.a.y(), t.b.y(), t.c.y()});
    return o;
}

TEST(UprightDistance, AgreesWithThePlainFormulaForRandomTriangles) {
    support::Dice dice(3);
    int faces = 0;
    int overlaps = 0;
    for (int i = 0; i < 50000; ++i) {
        const Triangle t = support::random_triangle(dice, Vec3::Zero());
        const Vec3 low = dice.in_cube(1.5);
        const Segment upright{low, low + Vec3(0, dice.chance(0.1) ? 0.0 : dice.between(0.0, 1.5), 0)};
        const Closest c = closest_upright(upright, obstacle(t));
        const double plain = support::distance(support::Line{upright.a, upright.b}, {t.a, t.b, t.c});
        ASSERT_NEAR(c.distance, plain, 1e-7) << i;
        ASSERT_NEAR((c.on_segment - c.on_shape).norm(), c.distance, 1e-9) << i;
        ASSERT_LT(support::distance(support::Line{c.on_shape, c.on_shape}, {t.a, t.b, t.c}), 1e-7) << i;
        ASSERT_GE(c.on_segment.y(), upright.a.y() - 1e-9);
        ASSERT_LE(c.on_segment.y(), upright.b.y() + 1e-9);
        faces += c.distance > 0.0 && c.feature == Feature::face ? 1 : 0;
        overlaps += c.distance <= 0.0 ? 1 : 0;
    }
    EXPECT_GT(faces, 1000);
    EXPECT_GT(overlaps, 300);
}

TEST(UprightDistance, BesideAWallIsTakenAtTheUpperEnd) {
    const Obstacle wall = obstacle({{1, -5, -9}, {1, -5, 9}, {1, 9, 0}});
    const Closest c = closest_upright({{0, 0.3, 0}, {0, 1.5, 0}}, wall);
    EXPECT_EQ(c.feature, Feature::face);
    EXPECT_EQ(c.distance, 1.0);
    EXPECT_EQ(c.on_shape, Vec3(1, 1.5, 0));
}

}  // namespace
}  // namespace campuswalk::collision

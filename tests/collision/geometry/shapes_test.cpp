#include "collision/geometry/shapes.h"

#include <gtest/gtest.h>

#include "tests/support/random_scene.h"

namespace campuswalk::collision {
namespace {

TEST(Pose, RotatesThenTranslates) {
    Pose quarter;
    quarter.rotation << 0, 0, 1, 0, 1, 0, -1, 0, 0;  // by 90 degrees about +Y: -Z goes to -X
    quarter.translation = {10, 20, 30};
    EXPECT_EQ(quarter * Vec3(0, 0, -1), Vec3(9, 20, 30));
    EXPECT_EQ(quarter.rotate(Vec3(0, 0, -1)), Vec3(-1, 0, 0));
    EXPECT_EQ(quarter.inverse_rotate(Vec3(-1, 0, 0)), Vec3(0, 0, -1));
    EXPECT_EQ(quarter.inverse_apply(Vec3(9, 20, 30)), Vec3(0, 0, -1));
}

TEST(Pose, InverseUndoesThePose) {
    support::Dice dice(1);
    for (int i = 0; i < 100; ++i) {
        const Pose X = support::random_pose(dice, 100.0);
        const Vec3 p = dice.in_cube(50.0);
        EXPECT_LT((X.inverse_apply(X * p) - p).norm(), 1e-12);
        EXPECT_LT((X.inverse_rotate(X.rotate(p)) - p).norm(), 1e-12);
        EXPECT_NEAR(X.rotate(p).norm(), p.norm(), 1e-12);
    }
}

TEST(Aabb, StartsEmptyAndGrowsByPoints) {
    Aabb box;
    EXPECT_TRUE(box.empty());
    box.extend({1, 2, 3});
    EXPECT_FALSE(box.empty());
    EXPECT_EQ(box.min, box.max);
    box.extend({-1, 5, 3});
    EXPECT_EQ(box.min, Vec3(-1, 2, 3));
    EXPECT_EQ(box.max, Vec3(1, 5, 3));
    EXPECT_EQ(box.grown(0.5).min, Vec3(-1.5, 1.5, 2.5));
    EXPECT_EQ(box.grown(0.5).max, Vec3(1.5, 5.5, 3.5));
}

TEST(Aabb, OverlapsWhatItTouches) {
    const Aabb unit{Vec3::Zero(), Vec3::Ones()};
    EXPECT_TRUE(unit.overlaps(unit));
    EXPECT_TRUE(unit.overlaps({Vec3(1, 1, 1), Vec3(2, 2, 2)}));
    EXPECT_TRUE(unit.overlaps({Vec3(0.2, 0.2, 0.2), Vec3(0.3, 0.3, 0.3)}));
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 away = 1.001 * Vec3::Unit(axis);
        EXPECT_FALSE(unit.overlaps({away, away + Vec3::Ones()})) << axis;
        EXPECT_FALSE(unit.overlaps({-away, Vec3::Ones() - away})) << axis;
    }
    EXPECT_FALSE(unit.overlaps(Aabb{}));
}

}  // namespace
}  // namespace campuswalk::collision

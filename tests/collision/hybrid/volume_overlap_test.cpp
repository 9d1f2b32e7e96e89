#include "collision/hybrid/volume_overlap.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "tests/support/dice.h"
#include "tests/support/effort.h"
#include "tests/support/mesh_pieces.h"
#include "tests/support/random_scene.h"

namespace campuswalk::collision {
namespace {

using support::Dice;
using support::repeats;

/// From micrometres to a thousand kilometres, or nothing.
double some_size(Dice& dice) {
    return dice.chance(0.15) ? 0.0 : std::pow(10.0, dice.between(-6.0, 6.0));
}

/// Grown as fitting.h specifies.
OrientedBox grown(OrientedBox box) {
    const double size = box.center.cwiseAbs().maxCoeff() + 2.0 * box.half_extents.maxCoeff();
    box.radius = box.half_extents.norm() + kOutward * size;
    box.half_extents.array() += kOutward * size;
    return box;
}

/// Any rotation, often a very small one from `near`, or none.
Mat3 some_axes(Dice& dice, const Mat3& near) {
    if (dice.chance(0.5)) {
        return support::random_pose(dice, 0.0).rotation;
    }
    const double angle = dice.chance(0.2) ? 0.0 : std::pow(10.0, dice.between(-17.0, -3.0));
    return support::turn(dice.in_cube(1.0) + Vec3(0, 0, 1.5), angle) * near;
}

OrientedBox some_box(Dice& dice, const Mat3& near, double offset) {
    OrientedBox box;
    box.axes = some_axes(dice, near);
    for (int i = 0; i < 3; ++i) {
        box.half_extents[i] = some_size(dice);
    }
    box.center = dice.in_cube(offset);
    return box;
}

/// A place in the box, often on a face, an edge or a vertex.
Vec3 place_in(Dice& dice, const OrientedBox& box) {
    Vec3 along = dice.in_cube(1.0);
    for (int i = 0; i < 3; ++i) {
        if (dice.chance(0.5)) {
            along[i] = along[i] < 0.0 ? -1.0 : 1.0;
        }
    }
    return box.axes * along.cwiseProduct(box.half_extents);
}

/// The vertex that is farthest in a direction, relative to the centre.
Vec3 farthest(const OrientedBox& box, const Vec3& direction) {
    const Vec3 along = box.axes.transpose() * direction;
    return box.axes * along.cwiseSign().cwiseProduct(box.half_extents);
}

bool any_test_separates(const OrientedBox& a, const OrientedBox& b) {
    const BoxOffset offset = offset_between(a, b);
    return apart(a, offset.in_a, b.radius) || apart(b, Vec3(-offset.in_b), a.radius) || apart(a, b, offset) ||
           apart(BoundingSphere{a.center, a.radius}, BoundingSphere{b.center, b.radius});
}

TEST(VolumeOverlap, SeparatesNothingThatSharesAPoint) {
    Dice dice(300);
    for (int i = 0; i < repeats(400000); ++i) {
        const double offset = dice.chance(0.5) ? 0.0 : some_size(dice);
        const OrientedBox a = some_box(dice, Mat3::Identity(), offset);
        OrientedBox b = some_box(dice, a.axes, offset);
        b.center = a.center + place_in(dice, a) - place_in(dice, b);
        ASSERT_FALSE(any_test_separates(grown(a), grown(b))) << i;
        ASSERT_FALSE(any_test_separates(grown(b), grown(a))) << i;
    }
}

/// A direction that is normal to a face of a box, or to an edge of each.
Vec3 separating_axis(Dice& dice, const OrientedBox& a, const OrientedBox& b) {
    Vec3 of_a = a.axes.col(dice.below(3));
    Vec3 of_b = b.axes.col(dice.below(3));
    switch (dice.below(3)) {
        case 0:
            return of_a;
        case 1:
            return of_b;
        default:
            return of_a.cross(of_b).normalized();
    }
}

TEST(VolumeOverlap, BoxesOverlapUpToTouchingButNotANanometreApart) {
    Dice dice(301);
    for (int i = 0; i < repeats(200000); ++i) {
        OrientedBox a;
        OrientedBox b;
        a.axes = support::random_pose(dice, 0.0).rotation;
        b.axes = support::random_pose(dice, 0.0).rotation;
        a.center = dice.in_cube(10.0);
        a.half_extents = dice.in_cube(2.0).cwiseAbs();
        b.half_extents = dice.in_cube(2.0).cwiseAbs();
        const Vec3 axis = separating_axis(dice, a, b);
        b.center = a.center + farthest(a, axis) + farthest(b, axis);
        ASSERT_FALSE(any_test_separates(grown(a), grown(b))) << i;
        b.center += 1e-9 * axis;
        const OrientedBox grown_a = grown(a);
        const OrientedBox grown_b = grown(b);
        ASSERT_TRUE(apart(grown_a, grown_b, offset_between(grown_a, grown_b))) << i;
    }
}

TEST(VolumeOverlap, AnyOfThreeAxesSeparatesASphereFromABox) {
    const OrientedBox box{Vec3::Zero(), Mat3::Identity(), Vec3(1, 2, 3), 4.0};
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            const Vec3 touching = side * (box.half_extents[axis] + 0.5) * Vec3::Unit(axis);
            EXPECT_FALSE(apart(box, touching, 0.5));
            EXPECT_TRUE(apart(box, Vec3(1.0001 * touching), 0.5));
        }
    }
    EXPECT_FALSE(apart(box, Vec3(1.4, 2.4, 3.4), 0.5)) << "three axes don't separate it near a vertex";
}

TEST(VolumeOverlap, SpheresOverlapUpToTheSumOfTheirRadii) {
    const BoundingSphere a{Vec3(1, 0, 0), 1.0};
    EXPECT_FALSE(apart(a, BoundingSphere{Vec3(1, 3, 0), 2.0}));
    EXPECT_TRUE(apart(a, BoundingSphere{Vec3(1, 3.0001, 0), 2.0}));
    EXPECT_FALSE(apart(a, BoundingSphere{Vec3(1, 0, 0.5), 0.0})) << "one within the other";
}

TEST(VolumeOverlap, NaNSeparatesNothing) {
    const double nan = std::nan("");
    const OrientedBox a{Vec3::Zero(), Mat3::Identity(), Vec3(1, 1, 1), 2.0};
    OrientedBox b = a;
    b.center = Vec3(nan, nan, nan);
    EXPECT_FALSE(any_test_separates(a, b));
    b = a;
    b.axes.setConstant(nan);
    EXPECT_FALSE(any_test_separates(a, b));
}

}  // namespace
}  // namespace campuswalk::collision

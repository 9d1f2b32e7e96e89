#include "scene/model/upright_box.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/angles.h"
#include "tests/support/dice.h"

namespace campuswalk::scene {
namespace {

using Eigen::Vector3d;
using support::radians;

/// The points of a box of 12 x 4 x 5 m, turned by `degrees`.
UprightBox box_of_turned(double degrees) {
    const double yaw = radians(degrees);
    const Vector3d along(std::cos(yaw), 0.0, -std::sin(yaw));
    const Vector3d across(std::sin(yaw), 0.0, std::cos(yaw));
    UprightBoxFit fit;
    for (const double a : {-6.0, 0.0, 6.0}) {
        for (const double b : {-2.5, 1.0, 2.5}) {
            for (const double y : {1.0, 5.0}) {
                fit.add(Vector3d(100, 0, -50) + a * along + b * across + y * Vector3d::UnitY());
            }
        }
    }
    return fit.box();
}

TEST(UprightBox, AlignsWithRotatedPoints) {
    for (const double degrees : {30.0, -30.0, 44.0, -20.0}) {
        const UprightBox box = box_of_turned(degrees);
        EXPECT_TRUE(box.center.isApprox(Vector3d(100, 3, -50), 1e-9)) << degrees;
        EXPECT_TRUE(box.size.isApprox(Vector3d(12, 4, 5), 1e-9)) << degrees;
        EXPECT_NEAR(std::atan2(-box.along.z(), box.along.x()) * 180.0 / std::numbers::pi, degrees, 1e-6);
    }
}

TEST(UprightBox, IsAxisAlignedUnlessRotationGainsMuch) {
    EXPECT_EQ(box_of_turned(0.0).along, Vector3d::UnitX());
    EXPECT_TRUE(box_of_turned(90.0).size.isApprox(Vector3d(5, 4, 12), 1e-9));
    UprightBoxFit disc;
    for (int i = 0; i < 360; ++i) {
        const double angle = radians(i);
        disc.add(Vector3d(std::cos(angle), 0.0, std::sin(angle)));
    }
    EXPECT_EQ(disc.box().along, Vector3d::UnitX());
}

TEST(UprightBox, MeasuresTheDepthOfAPoint) {
    const UprightBox box = box_of_turned(30.0);
    EXPECT_NEAR(box.depth_of(box.center), 2.0, 1e-9);  // to floor and ceiling
    EXPECT_NEAR(box.depth_of(box.center + 5.5 * box.along), 0.5, 1e-9);
    EXPECT_NEAR(box.depth_of(box.center + 3.5 * box.across()), -1.0, 1e-9);
}

TEST(UprightBox, ContainsAllPointsWithTheSmallestFootprint) {
    support::Dice dice(7);
    std::vector<Vector3d> points;
    UprightBoxFit fit;
    for (int i = 0; i < 5000; ++i) {  // many times the points that are stored between two hulls
        const Vector3d cube = dice.in_cube(1.0);
        points.emplace_back(9.0 * cube.x() + 0.5 * cube.z(), cube.y(), 6.0 * cube.x() + cube.z());
        fit.add(points.back());
    }
    const UprightBox box = fit.box();
    for (const Vector3d& p : points) {
        ASSERT_GE(box.depth_of(p), -1e-9);
    }
    for (int degrees = -45; degrees <= 45; ++degrees) {
        const double yaw = radians(degrees);
        const Vector3d along(std::cos(yaw), 0.0, -std::sin(yaw));
        const Vector3d across(std::sin(yaw), 0.0, std::cos(yaw));
        Eigen::Vector2d low(1e300, 1e300);
        Eigen::Vector2d high(-1e300, -1e300);
        for (const Vector3d& p : points) {
            low = low.cwiseMin(Eigen::Vector2d(p.dot(along), p.dot(across)));
            high = high.cwiseMax(Eigen::Vector2d(p.dot(along), p.dot(across)));
        }
        EXPECT_LE(box.size.x() * box.size.z(), (high - low).prod() * (1.0 + 1e-9)) << degrees;
    }
}

TEST(UprightBox, HasNoWidthForALine) {
    UprightBoxFit fit;
    fit.add({0, 0, 0});
    fit.add({3, 2, 4});
    const UprightBox box = fit.box();
    EXPECT_NEAR(box.size.maxCoeff(), 5.0, 1e-9);
    EXPECT_NEAR(box.size.minCoeff(), 0.0, 1e-9);
}

}  // namespace
}  // namespace campuswalk::scene

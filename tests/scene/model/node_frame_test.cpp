#include "scene/model/node_frame.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

namespace campuswalk::scene {
namespace {

using collision::Mat3;
using collision::Vec3;

Eigen::Matrix4d with_linear(const Mat3& linear) {
    Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
    m.topLeftCorner<3, 3>() = linear;
    m.topRightCorner<3, 1>() << 1, 2, 3;
    return m;
}

void expect_near(const Mat3& a, const Mat3& b) {
    EXPECT_LT((a - b).cwiseAbs().maxCoeff(), 1e-12) << a << "\n" << b;
}

TEST(UprightFrame, IsTheWorldFrameForAnUnrotatedNode) {
    const auto frame = upright_frame(with_linear(Mat3::Identity()));
    expect_near(frame.rotation, Mat3::Identity());
    EXPECT_EQ(frame.translation, Vec3(1, 2, 3));
}

TEST(UprightFrame, KeepsYawAndDropsScaleMirroringAndShear) {
    const Mat3 yaw = rotation_about_y(0.5);
    expect_near(upright_frame(with_linear(yaw)).rotation, yaw);
    expect_near(upright_frame(with_linear(yaw * Vec3(2, 3, 0.1).asDiagonal())).rotation, yaw);
    expect_near(upright_frame(with_linear(yaw * Vec3(1, 1, -1).asDiagonal())).rotation, yaw);
    Mat3 shear = Mat3::Identity();
    shear(1, 0) = 0.25;
    const Mat3 frame = upright_frame(with_linear(shear)).rotation;
    expect_near(frame, Mat3::Identity());
}

TEST(UprightFrame, HasYUpForNodesOfZUpFiles) {
    Mat3 z_up;
    z_up << 1, 0, 0, 0, 0, 1, 0, -1, 0;
    expect_near(upright_frame(with_linear(z_up)).rotation, Mat3::Identity());
    const Mat3 turned = z_up * Eigen::AngleAxisd(0.5, Vec3::UnitZ()).toRotationMatrix();
    expect_near(upright_frame(with_linear(turned)).rotation, rotation_about_y(0.5));
}

TEST(UprightFrame, IsRightHandedForEveryOrientation) {
    for (int i = 0; i < 200; ++i) {
        const Mat3 any =
            Eigen::Quaterniond(std::sin(i * 1.0), std::sin(i * 2.3), std::sin(i * 3.1), std::cos(i * 0.7))
                .normalized()
                .toRotationMatrix();
        const Mat3 frame = upright_frame(with_linear(any * 3.0)).rotation;
        expect_near(frame.transpose() * frame, Mat3::Identity());
        EXPECT_NEAR(frame.determinant(), 1.0, 1e-12);
        EXPECT_GE(frame(1, 1), 1.0 / std::sqrt(3.0) - 1e-9);  // some axis is at least that near to up
    }
}

TEST(UprightFrame, IsOrthonormalForACollapsedNode) {
    expect_near(upright_frame(with_linear(Mat3::Zero())).rotation, Mat3::Identity());
    const Mat3 flat = upright_frame(with_linear(Vec3(0, 1, 0).asDiagonal())).rotation;
    expect_near(flat.transpose() * flat, Mat3::Identity());
}

TEST(RotationAboutY, AgreesWithLibmWithinRounding) {
    for (int i = -2000; i < 2000; ++i) {
        const double angle = i * 0.01;
        const Mat3 rotation = rotation_about_y(angle);
        ASSERT_NEAR(rotation(0, 0), std::cos(angle), 1e-14) << angle;
        ASSERT_NEAR(rotation(0, 2), std::sin(angle), 1e-14) << angle;
    }
    // Yaw 0 looks along -Z, positive turns left.
    const Vec3 left = rotation_about_y(std::numbers::pi / 2) * Vec3(0, 0, -1);
    EXPECT_LT((left - Vec3(-1, 0, 0)).norm(), 1e-15);
}

TEST(RotationXyz, TurnsAboutAxesThatTurnAlong) {
    for (const Vec3& angles : {Vec3(0, 0, 0), Vec3(0.3, -1.2, 2.5), Vec3(-7, 4, 0.1)}) {
        const Eigen::Matrix3d expected =
            (Eigen::AngleAxisd(angles.x(), Vec3::UnitX()) * Eigen::AngleAxisd(angles.y(), Vec3::UnitY()) *
             Eigen::AngleAxisd(angles.z(), Vec3::UnitZ()))
                .toRotationMatrix();
        expect_near(rotation_xyz(angles), expected);
    }
}

TEST(RotationWithXAlong, MapsXToTheAxis) {
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 2, 0), Vec3(0, 0, -3), Vec3(1, 2, 3)}) {
        const Mat3 rotation = rotation_with_x_along(axis);
        EXPECT_LT((rotation.col(0) - axis.normalized()).norm(), 1e-15);
        expect_near(rotation.transpose() * rotation, Mat3::Identity());
        EXPECT_NEAR(rotation.determinant(), 1.0, 1e-12);
    }
}

}  // namespace
}  // namespace campuswalk::scene

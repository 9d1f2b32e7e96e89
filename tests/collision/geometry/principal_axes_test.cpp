#include "collision/geometry/principal_axes.h"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include "tests/support/dice.h"

namespace campuswalk::collision {
namespace {

void expect_principal(const Mat3& symmetric) {
    const Mat3 axes = principal_axes(symmetric);
    EXPECT_LT((axes.transpose() * axes - Mat3::Identity()).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_GT(axes.determinant(), 0.0) << "a reflection";
    Mat3 turned = axes.transpose() * symmetric * axes;
    const Vec3 eigenvalues = turned.diagonal();
    turned.diagonal().setZero();
    const double size = symmetric.cwiseAbs().maxCoeff();
    EXPECT_LE(turned.cwiseAbs().maxCoeff(), 1e-9 * size);
    EXPECT_LE(eigenvalues[0], eigenvalues[1] + 1e-9 * size);
    EXPECT_LE(eigenvalues[1], eigenvalues[2] + 1e-9 * size);
}

TEST(PrincipalAxes, AreARotationThatDiagonalizes) {
    support::Dice dice(440);
    for (int i = 0; i < 3000; ++i) {
        SCOPED_TRACE(i);
        Mat3 points;
        points << dice.in_cube(1.0), dice.in_cube(1.0), dice.in_cube(1.0);
        // From nearly a plane to nearly a line.
        points.row(0) *= dice.between(0.0, 1e-3);
        points.row(1) *= dice.between(0.0, 1.0);
        const double scale = i % 3 == 0 ? 1.0 : (i % 3 == 1 ? 1e22 : 1e-80);
        expect_principal(scale * points * points.transpose());
    }
}

TEST(PrincipalAxes, ExistForIsotropicAndDiagonalMatrices) {
    EXPECT_EQ(principal_axes(Mat3::Zero()), Mat3::Identity());
    EXPECT_EQ(principal_axes(3.0 * Mat3::Identity()), Mat3::Identity());
    expect_principal(Mat3::Constant(1.0));
    expect_principal(Vec3(3.0, 2.0, 1.0).asDiagonal());
    Mat3 barely = Vec3(1.0, 2.0, 3.0).asDiagonal();
    barely(0, 1) = barely(1, 0) = 1e-300;
    expect_principal(barely);
}

}  // namespace
}  // namespace campuswalk::collision

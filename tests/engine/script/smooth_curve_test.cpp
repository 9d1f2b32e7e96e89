#include "engine/script/smooth_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "tests/support/dice.h"

namespace campuswalk::engine {
namespace {

using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

Points curve(const Points& through) {
    Points out;
    smooth_curve(through, out);
    return out;
}

/// An independent formula for the same curve: the spline in its cubic Hermite form, with tangents from the
/// knots' divided differences. Between the second and the third point, `u` from 0 to 1.
Vector3d hermite(const std::array<Vector3d, 4>& p, double u) {
    std::array<double, 3> d{};
    for (std::size_t i = 0; i < 3; ++i) {
        d[i] = std::pow((p[i + 1] - p[i]).norm(), 0.5);
    }
    const Vector3d m1 = d[1] * ((p[1] - p[0]) / d[0] - (p[2] - p[0]) / (d[0] + d[1]) + (p[2] - p[1]) / d[1]);
    const Vector3d m2 = d[1] * ((p[2] - p[1]) / d[1] - (p[3] - p[1]) / (d[1] + d[2]) + (p[3] - p[2]) / d[2]);
    const double u2 = u * u;
    const double u3 = u2 * u;
    return (2 * u3 - 3 * u2 + 1) * p[1] + (u3 - 2 * u2 + u) * m1 + (3 * u2 - 2 * u3) * p[2] + (u3 - u2) * m2;
}

double distance_to(const Points& points, const Vector3d& point) {
    double nearest = 1e300;
    for (const Vector3d& p : points) {
        nearest = std::min(nearest, (p - point).norm());
    }
    return nearest;
}

TEST(SmoothCurve, IsTheCentripetalSpline) {
    support::Dice dice(7);
    for (int i = 0; i < 50; ++i) {
        std::array<Vector3d, 4> p;
        for (Vector3d& point : p) {
            point = Vector3d(dice.between(-9, 9), 0, dice.between(-9, 9));
        }
        const Points line = curve({p[0], p[1], p[2], p[3]});
        const auto from = std::ranges::find(line, p[1]);
        const auto to = std::ranges::find(line, p[2]);
        ASSERT_NE(from, line.end());
        ASSERT_NE(to, line.end());
        const auto segments = static_cast<double>(to - from);
        for (auto at = from; at != to; ++at) {
            ASSERT_LT((*at - hermite(p, static_cast<double>(at - from) / segments)).norm(), 1e-9) << i;
        }
    }
}

TEST(SmoothCurve, PassesThroughItsPointsInOrder) {
    const Points through = {{0, 0, 0}, {3, 0, 1}, {3, 0, -5}, {-2, 0, 4}};
    const Points line = curve(through);
    EXPECT_EQ(line.front(), through.front());
    EXPECT_EQ(line.back(), through.back());
    auto from = line.begin();
    for (const Vector3d& point : through) {
        from = std::find(from, line.end(), point);
        ASSERT_NE(from, line.end());
    }
}

TEST(SmoothCurve, IsStraightBetweenTwoPoints) {
    const Points line = curve({{1, 0, 1}, {4, 0, 5}});
    EXPECT_EQ(line.size(), 51U);
    for (const Vector3d& p : line) {
        EXPECT_NEAR((p - Vector3d(1, 0, 1)).cross(Vector3d(3, 0, 4)).norm(), 0.0, 1e-12);
    }
}

TEST(SmoothCurve, IgnoresHeightsAndRepeatedPoints) {
    EXPECT_EQ(curve({{0, 1, 0}, {0, 5, 0}, {1, 2, 0}, {1, 2, 0}}), curve({{0, 0, 0}, {1, 0, 0}}));
    EXPECT_EQ(curve({{3, 0, 3}, {3, 0, 3}}), Points({{3, 0, 3}}));
    EXPECT_EQ(curve({}), Points());
}

TEST(SmoothCurve, HasNoLoopsWherePointsAreClose) {
    // A uniform spline would overshoot the short side by metres.
    const Points line = curve({{0, 0, 0}, {10, 0, 0}, {10, 0, 0.1}, {0, 0, 0.1}});
    for (const Vector3d& p : line) {
        EXPECT_LT(p.x(), 10.2);
    }
    EXPECT_EQ(distance_to(line, {10, 0, 0.1}), 0.0);
}

}  // namespace
}  // namespace campuswalk::engine

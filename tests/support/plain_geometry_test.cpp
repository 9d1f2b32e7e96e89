#include "tests/support/plain_geometry.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace campuswalk::support {
namespace {

const Vertices kTriangle{Point(0, 0, 0), Point(4, 0, 0), Point(0, 0, 3)};

TEST(PlainGeometry, DistanceOverATriangleIsThatOfTheNearerEnd) {
    EXPECT_DOUBLE_EQ(distance(Line{{1, 0.25, 1}, {1, 2, 1}}, kTriangle), 0.25);
    EXPECT_DOUBLE_EQ(distance(Line{{1, -2, 1}, {1, -0.5, 1}}, kTriangle), 0.5);
}

TEST(PlainGeometry, DistanceThroughATriangleIsZero) {
    EXPECT_EQ(distance(Line{{1, -1, 1}, {1, 1, 1}}, kTriangle), 0.0);
    EXPECT_TRUE(passes_through({{1, -1, 1}, {1, 1, 1}}, kTriangle));
    EXPECT_FALSE(passes_through({{5, -1, 1}, {5, 1, 1}}, kTriangle));
    EXPECT_FALSE(passes_through({{1, 0.1, 1}, {1, 1, 1}}, kTriangle));
}

TEST(PlainGeometry, DistanceBesideATriangleIsToItsEdgeOrVertex) {
    EXPECT_DOUBLE_EQ(distance(Line{{-0.5, -1, 1}, {-0.5, 1, 1}}, kTriangle), 0.5);
    EXPECT_DOUBLE_EQ(distance(Line{{-0.3, -1, -0.4}, {-0.3, 1, -0.4}}, kTriangle), 0.5);
    // Beyond the long side 3x + 4z = 12, at (4, y, 3): the distance is 12 / 5.
    EXPECT_DOUBLE_EQ(distance(Line{{4, -1, 3}, {4, 1, 3}}, kTriangle), 2.4);
    EXPECT_DOUBLE_EQ(distance(Line{{-3, 4, 0}, {-3, 5, 0}}, kTriangle), 5.0);
}

TEST(PlainGeometry, DistanceToATriangleWithoutAreaIsToItsEdges) {
    const Vertices needle{Point(0, 0, 0), Point(2, 0, 0), Point(1, 0, 0)};
    EXPECT_DOUBLE_EQ(distance(Line{{1.5, 1, -1}, {1.5, 1, 1}}, needle), 1.0);
    const Vertices dot{Point(0, 0, 0), Point(0, 0, 0), Point(0, 0, 0)};
    EXPECT_DOUBLE_EQ(distance(Line{{3, 4, 0}, {3, 9, 0}}, dot), 5.0);
}

TEST(PlainGeometry, DistanceOfLinesIsAtTheirPerpendicularOrAnEnd) {
    EXPECT_DOUBLE_EQ(distance(Line{{-1, 0, 0}, {1, 0, 0}}, Line{{0, 2, -1}, {0, 2, 1}}), 2.0);
    EXPECT_DOUBLE_EQ(distance(Line{{0, 0, 0}, {1, 0, 0}}, Line{{4, 4, 0}, {9, 4, 0}}), 5.0);
    EXPECT_DOUBLE_EQ(distance(Line{{0, 0, 0}, {5, 0, 0}}, Line{{1, 3, 0}, {2, 3, 0}}), 3.0);
}

/// Every point of a dense sampling is at least as far, and one is hardly farther.
TEST(PlainGeometry, DistanceToATriangleIsTheLeastOfADenseSampling) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    const auto point = [&] { return Point(number(random), number(random), number(random)); };
    for (int trial = 0; trial < 60; ++trial) {
        const Line line{point(), point()};
        const Vertices t{point(), point(), point()};
        double least = 1e300;
        constexpr int kFine = 100;
        for (int i = 0; i <= kFine; ++i) {
            for (int j = 0; i + j <= kFine; ++j) {
                const double u = i / static_cast<double>(kFine);
                const double v = j / static_cast<double>(kFine);
                least = std::min(least, distance(Point(t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0])), line));
            }
        }
        const double exact = distance(line, t);
        ASSERT_LE(exact, least + 1e-12) << "trial " << trial;
        ASSERT_GE(exact, least - 0.05) << "trial " << trial;
    }
}

TEST(PlainGeometry, SignedDistancesOfSolidsAreNegativeInside) {
    const Point half(1, 2, 3);
    EXPECT_DOUBLE_EQ(signed_distance_to_box({0, 0, 0}, half), -1.0);
    EXPECT_DOUBLE_EQ(signed_distance_to_box({0.5, 0, 2.75}, half), -0.25);
    EXPECT_DOUBLE_EQ(signed_distance_to_box({4, 6, 0}, half), 5.0);
    EXPECT_DOUBLE_EQ(signed_distance_to_cylinder({0, 0, 0}, 2.0, 0.5), -0.5);
    EXPECT_DOUBLE_EQ(signed_distance_to_cylinder({0, 1.2, 1.6}, 3.0, 5.0), -1.0);
    EXPECT_DOUBLE_EQ(signed_distance_to_cylinder({3.5, 3, 4}, 1.0, 0.5), 5.0);
}

TEST(PlainGeometry, FindsTheLeastValueOfAConvexFunction) {
    EXPECT_NEAR(least_on_unit_interval([](double t) { return (t - 0.3) * (t - 0.3) + 2.0; }), 2.0, 1e-15);
    EXPECT_DOUBLE_EQ(least_on_unit_interval([](double t) { return 1.0 + t; }), 1.0);
    EXPECT_DOUBLE_EQ(least_on_unit_interval([](double t) { return 1.0 - t; }), 0.0);
}

}  // namespace
}  // namespace campuswalk::support

#include "collision/geometry/trigonometry.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/dice.h"

namespace campuswalk::collision {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kTolerance = 1e-15;

void expect_like_libm(double angle) {
    const SinCos ours = sin_cos(angle);
    const auto exact = static_cast<long double>(angle);
    EXPECT_NEAR(ours.sin, static_cast<double>(std::sin(exact)), kTolerance) << angle;
    EXPECT_NEAR(ours.cos, static_cast<double>(std::cos(exact)), kTolerance) << angle;
}

TEST(Trigonometry, SineAndCosineMatchLibmWithinRounding) {
    support::Dice dice(4);
    for (int i = 0; i < 20000; ++i) {
        expect_like_libm(dice.between(-2.0 * kPi, 2.0 * kPi));
        expect_like_libm(dice.between(-1000.0, 1000.0));
        expect_like_libm(dice.between(-1e-3, 1e-3));
    }
}

TEST(Trigonometry, SineAndCosineMatchLibmForThousandsOfTurns) {
    support::Dice dice(5);
    for (int i = 0; i < 20000; ++i) {
        expect_like_libm(dice.between(-2000.0 * 2.0 * kPi, 2000.0 * 2.0 * kPi));
    }
}

TEST(Trigonometry, SineAndCosineMatchLibmAtQuadrantBoundaries) {
    for (int eighth = -64; eighth <= 64; ++eighth) {
        const double angle = eighth * kPi / 4.0;
        expect_like_libm(angle);
        expect_like_libm(std::nextafter(angle, 1e9));
        expect_like_libm(std::nextafter(angle, -1e9));
    }
    EXPECT_EQ(sin_cos(0.0).sin, 0.0);
    EXPECT_EQ(sin_cos(0.0).cos, 1.0);
}

TEST(Trigonometry, AngleOfADirectionMatchesAtan2) {
    support::Dice dice(6);
    for (int i = 0; i < 20000; ++i) {
        const double size = std::pow(10.0, dice.between(-9.0, 9.0));
        const double x = size * dice.between(-1.0, 1.0);
        const double y = size * dice.between(-1.0, 1.0);
        EXPECT_NEAR(angle_of(y, x), std::atan2(y, x), 2e-15) << y << ' ' << x;
    }
}

TEST(Trigonometry, AngleOfAxesAndDiagonalsMatchesAtan2) {
    for (const double y : {-1.0, 0.0, 1.0}) {
        for (const double x : {-1.0, 0.0, 1.0}) {
            EXPECT_NEAR(angle_of(y, x), std::atan2(y, x), 1e-15) << y << ' ' << x;
        }
    }
    EXPECT_EQ(angle_of(0.0, 0.0), 0.0);
}

TEST(Trigonometry, AngleStaysInItsHalfOpenRangeAcrossTheSeam) {
    for (const double y : {0.0, -0.0, 1e-300, -1e-300, 1e-17, -1e-17, 1e-12, -1e-12}) {
        const double angle = angle_of(y, -1.0);
        EXPECT_GT(angle, -kPi) << y;
        EXPECT_LE(angle, kPi) << y;
        EXPECT_NEAR(std::abs(angle), kPi, 2e-12) << y;
    }
}

TEST(Trigonometry, WrappedAngleHasTheSameDirection) {
    support::Dice dice(7);
    for (int i = 0; i < 20000; ++i) {
        const double angle = dice.between(-1000.0, 1000.0);
        const double wrapped = wrapped_angle(angle);
        EXPECT_GT(wrapped, -kPi);
        EXPECT_LE(wrapped, kPi);
        EXPECT_NEAR(std::sin(wrapped), std::sin(angle), 1e-12);
        EXPECT_NEAR(std::cos(wrapped), std::cos(angle), 1e-12);
    }
    EXPECT_EQ(wrapped_angle(kPi), kPi);
    EXPECT_EQ(wrapped_angle(-kPi), kPi);
    EXPECT_EQ(wrapped_angle(3.0 * kPi), kPi);
    EXPECT_EQ(wrapped_angle(0.25), 0.25);
}

}  // namespace
}  // namespace campuswalk::collision

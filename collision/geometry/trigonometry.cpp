#include "collision/geometry/trigonometry.h"

#include <cmath>
#include <numbers>

namespace campuswalk::collision {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kHalfPi = 0.5 * kPi;
// pi/2 in two parts: the first has 33 bits, so that its product with a small integer is exact.
constexpr double kHalfPiHigh = 1.57079632673412561417;
constexpr double kHalfPiLow = 6.07710050650619224932e-11;

// Taylor's series; 1/17! and 1/18! times (pi/4)^17 are below rounding.

double small_sin(double x) {
    const double z = x * x;
    double sum = 0.0;
    for (int n = 17; n >= 3; n -= 2) {
        sum = -z / (n * (n - 1)) * (1.0 + sum);
    }
    return x * (1.0 + sum);
}

double small_cos(double x) {
    const double z = x * x;
    double sum = 0.0;
    for (int n = 18; n >= 2; n -= 2) {
        sum = -z / (n * (n - 1)) * (1.0 + sum);
    }
    return 1.0 + sum;
}

}  // namespace

SinCos sin_cos(double angle) {
    const double quarters = std::floor(angle / kHalfPi + 0.5);
    const double x = (angle - quarters * kHalfPiHigh) - quarters * kHalfPiLow;
    const double s = small_sin(x);
    const double c = small_cos(x);
    const auto quadrant = static_cast<long long>(quarters) & 3;
    switch (quadrant) {
        case 0:
            return {s, c};
        case 1:
            return {c, -s};
        case 2:
            return {-s, -c};
        default:
            return {-c, s};
    }
}

double angle_of(double y, double x) {
    const double length = std::sqrt(x * x + y * y);
    if (length <= 0.0) {
        return 0.0;
    }
    const double u = x / length;
    const double v = y / length;
    // A guess within 0.1 rad, then Newton's steps on the angle between the guess and the direction: the sine
    // of a small difference is the difference up to its cube, so three steps reach rounding.
    const double steep = std::abs(v) > std::abs(u) ? u / std::abs(v) : v / std::abs(u);
    double angle = std::abs(v) > std::abs(u) ? (v > 0.0 ? kHalfPi - steep : -kHalfPi + steep)
                                             : (u > 0.0 ? steep : (v >= 0.0 ? kPi - steep : -kPi - steep));
    for (int i = 0; i < 5; ++i) {
        const SinCos guess = sin_cos(angle);
        const double sine = v * guess.cos - u * guess.sin;
        angle += sine + sine * sine * sine / 6.0;
    }
    // Near the seam at pi, rounding may end on its far side.
    return angle <= -kPi || angle > kPi ? kPi : angle;
}

double wrapped_angle(double angle) {
    const double turns = std::floor(angle / (2.0 * kPi) + 0.5);
    const double wrapped = angle - turns * (2.0 * kPi);
    return wrapped <= -kPi ? wrapped + 2.0 * kPi : wrapped;
}

}  // namespace campuswalk::collision

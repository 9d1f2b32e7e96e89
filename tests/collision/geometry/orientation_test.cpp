#include "collision/geometry/orientation.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "tests/support/dice.h"
#include "tests/support/effort.h"

namespace campuswalk::collision {
namespace {

using Vec2 = Eigen::Vector2d;
using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;
using support::Dice;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// CGAL's sign assumes the opposite handedness.
int oracle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const auto exact = [](const Vec3& p) { return Exact::Point_3(p.x(), p.y(), p.z()); };
    return -CGAL::orientation(exact(a), exact(b), exact(c), exact(d));
}

int oracle(const Vec2& a, const Vec2& b, const Vec2& c) {
    const auto exact = [](const Vec2& p) { return Exact::Point_2(p.x(), p.y()); };
    return CGAL::orientation(exact(a), exact(b), exact(c));
}

/// How often each sign came up.
struct Tally {
    std::array<int, 3> of{};

    void count(int sign) {
        const int place = sign + 1;
        ++of[static_cast<std::size_t>(place)];
    }
    void expect_at_least(int each) const {
        EXPECT_GE(of[0], each);
        EXPECT_GE(of[1], each);
        EXPECT_GE(of[2], each);
    }
};

Vec3 grid_point(Dice& dice, int half) {
    const double x = dice.below(2 * half + 1) - half;
    const double y = dice.below(2 * half + 1) - half;
    return {x, y, static_cast<double>(dice.below(2 * half + 1) - half)};
}

/// Coordinates that need all their bits.
Vec3 full_point(Dice& dice, double half_size) {
    return dice.in_cube(half_size) / 3.0;
}

double moved_by_ulps(double x, int ulps) {
    for (; ulps > 0; --ulps) {
        x = std::nextafter(x, kInfinity);
    }
    for (; ulps < 0; ++ulps) {
        x = std::nextafter(x, -kInfinity);
    }
    return x;
}

TEST(Orientation, TurnsClockwiseSeenFromThePositiveSide) {
    const Vec3 a(0, 0, 0);
    const Vec3 b(1, 0, 0);
    const Vec3 c(0, 1, 0);
    EXPECT_EQ(orientation(a, b, c, Vec3(5, 7, -1)), 1);
    EXPECT_EQ(orientation(a, b, c, Vec3(5, 7, 1)), -1);
    EXPECT_EQ(orientation(a, b, c, Vec3(5, 7, 0)), 0);
    EXPECT_EQ(orientation(b, a, c, Vec3(5, 7, -1)), -1);
}

TEST(Orientation, IsPositiveForCounterClockwiseTurnsInThePlane) {
    EXPECT_EQ(orientation(Vec2(0, 0), Vec2(1, 0), Vec2(9, 0.1)), 1);
    EXPECT_EQ(orientation(Vec2(0, 0), Vec2(1, 0), Vec2(9, -0.1)), -1);
    EXPECT_EQ(orientation(Vec2(0, 0), Vec2(1, 0), Vec2(9, 0)), 0);
}

/// Points in a common plane, at scales and places where the coordinates need all their bits, then moved by a
/// few units in the last place or not at all.
TEST(Orientation, IsExactNearAPlane) {
    Dice dice(1);
    Tally tally;
    for (int i = 0; i < support::repeats(25000); ++i) {
        const Vec3 origin = dice.chance(0.7) ? full_point(dice, 1.0) : Vec3(450000.125, -3.0, 0.1);
        const Vec3 u = full_point(dice, 1.0);
        const Vec3 v = full_point(dice, 1.0);
        std::array<Vec3, 4> p;
        for (Vec3& point : p) {
            const Vec3 place = grid_point(dice, 4);
            point = origin + place.x() * u + place.y() * v;
        }
        const int axis = dice.below(3);
        p[3][axis] = moved_by_ulps(p[3][axis], dice.below(5) - 2);
        const int sign = orientation(p[0], p[1], p[2], p[3]);
        ASSERT_EQ(sign, oracle(p[0], p[1], p[2], p[3])) << i;
        tally.count(sign);
    }
    tally.expect_at_least(support::repeats(1000));
}

TEST(Orientation, IsExactNearALine) {
    Dice dice(2);
    Tally tally;
    for (int i = 0; i < support::repeats(30000); ++i) {
        const Vec2 origin = full_point(dice, dice.chance(0.7) ? 1.0 : 1e6).head<2>();
        const Vec2 u = full_point(dice, 1.0).head<2>();
        std::array<Vec2, 3> p;
        for (Vec2& point : p) {
            point = origin + (dice.below(9) - 4) * u;
        }
        p[2].y() = moved_by_ulps(p[2].y(), dice.below(5) - 2);
        const int sign = orientation(p[0], p[1], p[2]);
        ASSERT_EQ(sign, oracle(p[0], p[1], p[2])) << i;
        tally.count(sign);
    }
    tally.expect_at_least(support::repeats(2000));
}

/// Short coordinates, whose determinants need 7 bits to 63, and more.
TEST(Orientation, IsExactOnLatticesOfAllSizes) {
    Dice dice(3);
    Tally tally;
    for (int bits = 2; bits <= 50; ++bits) {
        for (int i = 0; i < support::repeats(300); ++i) {
            const int half = 2 + dice.below(3);
            const double scale = std::ldexp(1.0, bits);
            const Vec3 u = Vec3(scale * dice.in_cube(0.5)).array().round();
            const Vec3 v = Vec3(scale * dice.in_cube(0.5)).array().round();
            std::array<Vec3, 4> p;
            for (Vec3& point : p) {
                const Vec3 place = grid_point(dice, half);
                point = place.x() * u + place.y() * v;
            }
            p[3].z() += dice.below(3) - 1;
            const int sign = orientation(p[0], p[1], p[2], p[3]);
            ASSERT_EQ(sign, oracle(p[0], p[1], p[2], p[3])) << bits << ' ' << i;
            tally.count(sign);
        }
    }
    tally.expect_at_least(support::repeats(2000));
}

/// About 2^middle, give or take `spread` powers of two, within what is finite.
double any_double(Dice& dice, int middle, int spread) {
    const int exponent = middle + dice.below(2 * spread + 1) - spread;
    const double fraction =
        dice.chance(0.3) ? 1.0 : dice.between(1.0, 2.0) + dice.between(0.0, 1.0) * 0x1p-32;
    const double size = std::ldexp(fraction, std::clamp(exponent, -1074, 1022));
    return dice.chance(0.5) ? size : -size;
}

/// A few values per axis, so that points often share coordinates and determinants often vanish.
class Pool {
public:
    explicit Pool(Dice& dice) : dice_(dice) {
        for (auto& axis : values_) {
            const int middle = dice.below(2097) - 1074;
            const int spread =
                std::array<int, 5>{0, 3, 40, 200, 2000}[static_cast<std::size_t>(dice.below(5))];
            for (double& value : axis) {
                value = dice.chance(0.2) ? 0.0 : any_double(dice, middle, spread);
            }
        }
    }
    double pick(std::size_t axis) { return values_[axis][static_cast<std::size_t>(dice_.below(4))]; }

private:
    Dice& dice_;
    std::array<std::array<double, 4>, 3> values_{};
};

/// The sign doesn't change with the scale of an axis, down to the smallest double and up to the largest;
/// often products are about to underflow.
TEST(Orientation, IsIndependentOfTheAxesScales) {
    Dice dice(4);
    Tally tally;
    Tally tally_in_plane;
    for (int i = 0; i < support::repeats(40000); ++i) {
        std::array<int, 3> exponent{};
        for (int& e : exponent) {
            e = dice.below(2096) - 1074;
        }
        const int kind = dice.below(3);
        if (kind == 1) {
            exponent[0] = -100 - dice.below(800);
            exponent[1] = -1090 + dice.below(20) - exponent[0];
        } else if (kind == 2) {
            exponent[0] = -20 - dice.below(400);
            exponent[1] = -20 - dice.below(400);
            exponent[2] = -1090 + dice.below(20) - exponent[0] - exponent[1];
        }
        const auto scaled = [&](const Vec3& p) {
            return Vec3(std::ldexp(p.x(), exponent[0]), std::ldexp(p.y(), exponent[1]),
                        std::ldexp(p.z(), exponent[2]));
        };
        std::array<Vec3, 4> p;
        std::array<Vec3, 4> q;
        for (std::size_t k = 0; k < 4; ++k) {
            p[k] = grid_point(dice, 4);
            q[k] = scaled(p[k]);
        }
        const int sign = orientation(p[0], p[1], p[2], p[3]);
        ASSERT_EQ(orientation(q[0], q[1], q[2], q[3]), sign) << i;
        tally.count(sign);
        const auto flat = [](const Vec3& point) { return Vec2(point.head<2>()); };
        const int turn = orientation(flat(p[0]), flat(p[1]), flat(p[2]));
        ASSERT_EQ(orientation(flat(q[0]), flat(q[1]), flat(q[2])), turn) << i;
        tally_in_plane.count(turn);
    }
    tally.expect_at_least(support::repeats(500));
    tally_in_plane.expect_at_least(support::repeats(500));
}

TEST(Orientation, IsExactForCoordinatesOfAnySize) {
    Dice dice(5);
    Tally tally;
    Tally tally_in_plane;
    for (int i = 0; i < support::repeats(1500); ++i) {
        Pool pool(dice);
        std::array<Vec3, 4> p;
        std::array<Vec2, 3> q;
        for (Vec3& point : p) {
            point = {pool.pick(0), pool.pick(1), pool.pick(2)};
        }
        for (Vec2& point : q) {
            point = {pool.pick(0), pool.pick(1)};
        }
        ASSERT_EQ(orientation(p[0], p[1], p[2], p[3]), oracle(p[0], p[1], p[2], p[3])) << i;
        ASSERT_EQ(orientation(q[0], q[1], q[2]), oracle(q[0], q[1], q[2])) << i;
        tally.count(orientation(p[0], p[1], p[2], p[3]));
        tally_in_plane.count(orientation(q[0], q[1], q[2]));
    }
    tally.expect_at_least(support::repeats(200));
    tally_in_plane.expect_at_least(support::repeats(200));
}

/// Beside the plane (or the line) by 2^-k, and by one unit in the last place of a point whose own size is
/// about 2^-k; for all k until the last fallback has taken over.
TEST(Orientation, ResolvesStepsDownToTheSmallestDouble) {
    // Both planes and the line pass through the origin, where the points' sum is.
    const std::array<Vec3, 3> p = {Vec3(3, 0, 0.75), Vec3(0, 5, 1.25), Vec3(-3, -5, -2)};
    const std::array<Vec3, 3> q = {Vec3(7, -7, 7), Vec3(-7, 7, 0), Vec3(0, 0, -7)};
    for (int k = 0; k <= 1072; k += k < 268 ? 1 : 67) {
        const double size = std::ldexp(1.0, -k);
        for (const int side : {-1, 0, 1}) {
            ASSERT_EQ(orientation(p[0], p[1], p[2], Vec3(0, 0, side * size)), -side) << k;
            ASSERT_EQ(orientation(q[0], q[1], q[2], Vec3(side * size, 0, 0)), side) << k;
            ASSERT_EQ(orientation(Vec2(3, 7), Vec2(-6, -14), Vec2(side * size, 0)), side) << k;
            const Vec3 on(0, 5 * size, moved_by_ulps(1.25 * size, side));
            ASSERT_EQ(orientation(p[0], p[1], p[2], on), -side) << k;
            const Vec2 on_line(moved_by_ulps(3 * size, side), 7 * size);
            ASSERT_EQ(orientation(Vec2(3, 7), Vec2(-6, -14), on_line), side) << k;
        }
    }
}

}  // namespace
}  // namespace campuswalk::collision

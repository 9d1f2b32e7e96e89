#include "collision/geometry/triangle_overlap.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Geometry>

#include "collision/geometry/shapes.h"
#include "tests/support/dice.h"
#include "tests/support/effort.h"

namespace campuswalk::collision {
namespace {

using support::Dice;

// The oracle. CGAL requires triangles with area: others are passed to it as segments and points, in
// rationals, because its predicates for those aren't exact in doubles.

using Filtered = CGAL::Exact_predicates_inexact_constructions_kernel;
using Rational = CGAL::Simple_cartesian<CGAL::Exact_rational>;

template <typename Kernel>
typename Kernel::Triangle_3 exact(const Triangle& t) {
    const auto point = [](const Vec3& p) { return typename Kernel::Point_3(p.x(), p.y(), p.z()); };
    return {point(t.a), point(t.b), point(t.c)};
}

using Extent = std::variant<Rational::Point_3, Rational::Segment_3, Rational::Triangle_3>;

Extent extent(const Triangle& triangle) {
    const Rational::Triangle_3 t = exact<Rational>(triangle);
    if (!t.is_degenerate()) {
        return t;
    }
    std::array<Rational::Point_3, 3> vertices = {t[0], t[1], t[2]};
    std::sort(vertices.begin(), vertices.end());
    if (vertices[0] == vertices[2]) {
        return vertices[0];
    }
    return Rational::Segment_3(vertices[0], vertices[2]);
}

bool share_a_point(const Triangle& s, const Triangle& t) {
    const auto fast_s = exact<Filtered>(s);
    const auto fast_t = exact<Filtered>(t);
    if (!fast_s.is_degenerate() && !fast_t.is_degenerate()) {
        return CGAL::do_intersect(fast_s, fast_t);
    }
    return std::visit([](const auto& x, const auto& y) { return CGAL::do_intersect(x, y); }, extent(s),
                      extent(t));
}

// Random triangles.

Vec3 grid_point(Dice& dice) {
    const double x = dice.below(5) - 2;
    const double y = dice.below(5) - 2;
    return {x, y, static_cast<double>(dice.below(5) - 2)};
}

Triangle grid_triangle(Dice& dice) {
    const Vec3 a = grid_point(dice);
    const Vec3 b = grid_point(dice);
    return {a, b, grid_point(dice)};
}

Triangle shuffled(const Triangle& t, Dice& dice) {
    std::array<Vec3, 3> p = {t.a, t.b, t.c};
    const int first = dice.below(3);
    const int second = 1 + dice.below(2);
    std::swap(p[0], p[static_cast<std::size_t>(first)]);
    std::swap(p[1], p[static_cast<std::size_t>(second)]);
    return {p[0], p[1], p[2]};
}

template <typename Move>
Triangle moved(const Triangle& t, const Move& move) {
    return {move(t.a), move(t.b), move(t.c)};
}

/// Compares with the oracle and counts; the result must depend neither on the order of the vertices nor on
/// that of the triangles.
struct Comparison {
    int overlapping = 0;
    int apart = 0;

    [[nodiscard]] bool agrees(const Triangle& s, const Triangle& t, Dice& dice) {
        return agrees(s, t, share_a_point(s, t), dice);
    }
    [[nodiscard]] bool agrees(const Triangle& s, const Triangle& t, bool expected, Dice& dice) {
        ++(expected ? overlapping : apart);
        const bool same = overlap(s, t) == expected && overlap(t, s) == expected &&
                          overlap(shuffled(s, dice), shuffled(t, dice)) == expected;
        if (!same) {
            std::cerr.precision(17);
            for (const Vec3& p : {s.a, s.b, s.c, t.a, t.b, t.c}) {
                std::cerr << p.transpose() << '\n';
            }
        }
        return same;
    }
    void expect_at_least(int each) const {
        EXPECT_GE(overlapping, each);
        EXPECT_GE(apart, each);
    }
};

/// A rotation up to rounding.
Mat3 random_rotation(Dice& dice) {
    Eigen::Quaterniond q;
    do {
        q.vec() = dice.in_cube(1.0);
        q.w() = dice.between(-1.0, 1.0);
    } while (q.norm() < 0.1);
    return q.normalized().toRotationMatrix();
}

double beside(double x, int ulps) {
    const double towards =
        ulps < 0 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
    return ulps == 0 ? x : std::nextafter(x, towards);
}

/// Each coordinate up or down by one unit in the last place, or left as it is.
Vec3 jittered(const Vec3& p, Dice& dice) {
    const double x = beside(p.x(), dice.below(3) - 1);
    const double y = beside(p.y(), dice.below(3) - 1);
    return {x, y, beside(p.z(), dice.below(3) - 1)};
}

/// On the grid's quarters, a vertex of t lies on s: on a vertex, the middle of an edge, or inside.
std::pair<Triangle, Triangle> touching(Dice& dice) {
    const Triangle s = grid_triangle(dice);
    Triangle t = grid_triangle(dice);
    switch (dice.below(4)) {
        case 0:
            t.a = s.b;
            break;
        case 1:
            t.a = 0.5 * (s.a + s.b);
            break;
        case 2:
            t.a = 0.25 * (s.a + s.b + 2.0 * s.c);
            break;
        default:
            t.a = s.a;
            t.b = s.b;
    }
    return {s, t};
}

const Triangle kFloor{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
constexpr double kNanometre = 1e-9;

TEST(TriangleOverlap, TouchingIsOverlap) {
    const Vec3 up(0, 0, 1);
    const auto above = [&](const Vec3& p) { return Triangle{p, p + Vec3(1, 0, 1), p + Vec3(0, 1, 2)}; };
    EXPECT_TRUE(overlap(kFloor, above({1, 1, 0}))) << "vertex on face";
    EXPECT_TRUE(overlap(kFloor, above({2, 2, 0}))) << "vertex on edge";
    EXPECT_TRUE(overlap(kFloor, above({4, 0, 0}))) << "vertex on vertex";
    EXPECT_TRUE(overlap(kFloor, {{3, 3, -1}, {1, 1, 1}, {3, 3, 1}})) << "edge on edge, crossing";
    EXPECT_TRUE(overlap(kFloor, {{1, 0, 0}, {2, 0, 0}, {1, 0, 1}})) << "edge along edge";
    EXPECT_TRUE(overlap(kFloor, {{1, 1, 0}, {2, 1, 0}, {1, 1, 1}})) << "edge on face";
    EXPECT_TRUE(overlap(kFloor, {{0, 0, 0}, {4, 0, 0}, {2, -1, 3}})) << "shared edge";
    EXPECT_TRUE(overlap(kFloor, kFloor)) << "coincident";
    EXPECT_TRUE(overlap(kFloor, {{0, 0, 0}, {4, 0, 0}, {0, -4, 0}})) << "shared edge in one plane";
    EXPECT_TRUE(overlap(kFloor, {{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}})) << "shared vertex in one plane";
    EXPECT_TRUE(overlap(kFloor, {{1, 1, 0}, {1.5, 1, 0}, {1, 1.5, 0}})) << "one within the other";
    EXPECT_TRUE(overlap(kFloor, {{1, 1, -1}, {1, 1, 1}, {9, 9, 0}})) << "through the face";
}

TEST(TriangleOverlap, AnyGapIsNoOverlap) {
    constexpr double kMin = std::numeric_limits<double>::denorm_min();
    const auto above = [&](const Vec3& p) { return Triangle{p, p + Vec3(1, 0, 1), p + Vec3(0, 1, 2)}; };
    const double beyond = std::nextafter(2.0, 3.0);
    EXPECT_FALSE(overlap(kFloor, above({1, 1, kMin})));
    EXPECT_FALSE(overlap(kFloor, above({2, beyond, 0})));
    EXPECT_FALSE(overlap(kFloor, above({std::nextafter(4.0, 5.0), 0, 0})));
    EXPECT_FALSE(overlap(kFloor, moved(kFloor, [&](const Vec3& p) { return Vec3(p.x(), p.y(), kMin); })));
    EXPECT_FALSE(overlap(kFloor, {{0, -kMin, 0}, {4, -kMin, 0}, {0, -4, 0}}));
    EXPECT_FALSE(overlap(kFloor, {{2, beyond, 0}, {3, beyond, 0}, {3, 4, 0}})) << "in one plane";
    EXPECT_FALSE(overlap(kFloor, {{5, 5, -1}, {5, 5, 1}, {9, 9, 0}})) << "through the plane beside the face";
}

TEST(TriangleOverlap, TrianglesWithoutAreaAreSegmentsAndPoints) {
    const auto needle = [](const Vec3& from, const Vec3& to) {
        return Triangle{0.5 * (from + to), to, from};
    };
    const auto point = [](const Vec3& p) { return Triangle{p, p, p}; };
    EXPECT_TRUE(overlap(kFloor, needle({1, 1, -1}, {1, 1, 1}))) << "through the face";
    EXPECT_TRUE(overlap(kFloor, needle({1, 1, 0}, {1, 1, 1}))) << "down to the face";
    EXPECT_FALSE(overlap(kFloor, needle({1, 1, 0.5}, {1, 1, 1})));
    EXPECT_TRUE(overlap(kFloor, needle({1, 1, 0}, {9, 9, 0}))) << "in the plane";
    EXPECT_FALSE(overlap(kFloor, needle({3, 3, 0}, {9, 9, 0})));
    EXPECT_TRUE(overlap(kFloor, point({1, 1, 0})));
    EXPECT_TRUE(overlap(kFloor, point({2, 2, 0})));
    EXPECT_FALSE(overlap(kFloor, point({3, 2, 0})));
    EXPECT_FALSE(overlap(kFloor, point({1, 1, 1})));
    EXPECT_TRUE(overlap(needle({0, 0, 0}, {2, 4, 6}), needle({1, 2, 0}, {1, 2, 4}))) << "crossing";
    EXPECT_FALSE(overlap(needle({0, 0, 0}, {2, 4, 6}), needle({1, 2, 0}, {1, 2, 2})));
    EXPECT_TRUE(overlap(needle({0, 0, 0}, {2, 4, 6}), needle({1, 2, 3}, {3, 6, 9}))) << "on one line";
    EXPECT_FALSE(overlap(needle({0, 0, 0}, {2, 4, 6}), needle({3, 6, 9}, {4, 8, 12})));
    EXPECT_FALSE(overlap(needle({0, 0, 0}, {2, 4, 6}), needle({1, 0, 0}, {3, 4, 6}))) << "parallel";
    EXPECT_TRUE(overlap(needle({0, 0, 0}, {2, 4, 6}), point({1, 2, 3})));
    EXPECT_FALSE(overlap(needle({0, 0, 0}, {2, 4, 6}), point({1, 2, 4})));
    EXPECT_TRUE(overlap(point({1, 2, 3}), point({1, 2, 3})));
    EXPECT_FALSE(overlap(point({1, 2, 3}), point({1, 2, 4})));
}

TEST(TriangleOverlap, ResolvesANanometreFarFromTheOrigin) {
    for (const double far : {0.0, 1000.0, 450000.125}) {
        const Vec3 origin(far, 2.0 * far, -far);
        const auto placed = [&](const Triangle& t) {
            return moved(t, [&](const Vec3& p) -> Vec3 { return origin + p; });
        };
        for (const double gap : {-kNanometre, 0.0, kNanometre}) {
            const Triangle vertex_down{{1, 1, gap}, {2, 1, 1}, {1, 2, 2}};
            const Triangle above = moved(kFloor, [&](const Vec3& p) { return Vec3(p.x(), p.y(), gap); });
            const Triangle behind{{0, -gap, 0}, {4, -gap, 0}, {2, -3, 2}};
            EXPECT_EQ(overlap(placed(kFloor), placed(vertex_down)), gap <= 0.0) << far << ' ' << gap;
            EXPECT_EQ(overlap(placed(kFloor), placed(above)), gap == 0.0) << far << ' ' << gap;
            EXPECT_EQ(overlap(placed(kFloor), placed(behind)), gap <= 0.0) << far << ' ' << gap;
        }
    }
}

TEST(TriangleOverlap, EqualsTheOracleInGeneralPosition) {
    Dice dice(1);
    Comparison comparison;
    for (int i = 0; i < support::repeats(50000); ++i) {
        const auto triangle = [&](const Vec3& at) {
            const Vec3 a = at + dice.in_cube(1.0);
            const Vec3 b = at + dice.in_cube(1.0);
            return Triangle{a, b, at + dice.in_cube(1.0)};
        };
        const Triangle s = triangle(Vec3::Zero());
        const Triangle t = triangle(dice.in_cube(0.5));
        ASSERT_TRUE(comparison.agrees(s, t, dice)) << i;
    }
    comparison.expect_at_least(support::repeats(5000));
}

/// All degenerate cases at once; then again at scales and places that leave the coordinates exact, from the
/// smallest double to the largest.
TEST(TriangleOverlap, EqualsTheOracleOnATinyGridAtEveryScale) {
    Dice dice(2);
    Comparison comparison;
    for (int i = 0; i < support::repeats(80000); ++i) {
        const Triangle s = grid_triangle(dice);
        const Triangle t = grid_triangle(dice);
        const bool expected = share_a_point(s, t);
        ASSERT_TRUE(comparison.agrees(s, t, expected, dice)) << i;
        const std::array<int, 3> exponent = {dice.below(2096) - 1074, dice.below(2096) - 1074,
                                             dice.below(2096) - 1074};
        const auto stretched = [&](const Vec3& p) {
            return Vec3(std::ldexp(p.x(), exponent[0]), std::ldexp(p.y(), exponent[1]),
                        std::ldexp(p.z(), exponent[2]));
        };
        ASSERT_EQ(overlap(moved(s, stretched), moved(t, stretched)), expected) << i;
        for (const double scale : {0x1p-20, 0x1p20}) {
            const auto scaled = [&](const Vec3& p) -> Vec3 { return scale * p; };
            const auto placed = [&](const Vec3& p) -> Vec3 { return scale * p + Vec3::Constant(450000.125); };
            ASSERT_EQ(overlap(moved(s, scaled), moved(t, scaled)), expected) << i << ' ' << scale;
            ASSERT_EQ(overlap(moved(s, placed), moved(t, placed)), expected) << i << ' ' << scale;
        }
    }
    comparison.expect_at_least(support::repeats(5000));
}

TEST(TriangleOverlap, EqualsTheOracleForNeedlesAndPoints) {
    Dice dice(3);
    Comparison comparison;
    const auto flattened = [&](Triangle t) {
        switch (dice.below(4)) {
            case 0:
                t.b = t.a;
                t.c = t.a;
                break;
            case 1:
                t.c = t.a;
                break;
            case 2:
                t.c = t.a + 0.5 * dice.below(4) * (t.b - t.a);
                break;
            default:
                break;
        }
        return t;
    };
    for (int i = 0; i < support::repeats(10000); ++i) {
        const auto [s, t] = touching(dice);
        ASSERT_TRUE(comparison.agrees(flattened(s), flattened(t), dice)) << i;
    }
    comparison.expect_at_least(support::repeats(1000));
}

/// Rounding after a rotation decides which of them touch.
TEST(TriangleOverlap, EqualsTheOracleWhereTouchingTrianglesAreRotatedAndRounded) {
    Dice dice(4);
    Comparison comparison;
    for (int i = 0; i < support::repeats(30000); ++i) {
        const auto [s, t] = touching(dice);
        const Mat3 rotation = random_rotation(dice);
        const Vec3 origin = dice.chance(0.5) ? Vec3(0, 0, 0) : Vec3(450000.125, 0.3, -7.1);
        const bool jitter = dice.chance(0.5);
        const auto rotated = [&](const Vec3& p) -> Vec3 {
            const Vec3 q = rotation * p + origin;
            return jitter ? jittered(q, dice) : q;
        };
        ASSERT_TRUE(comparison.agrees(moved(s, rotated), moved(t, rotated), dice)) << i;
    }
    comparison.expect_at_least(support::repeats(2000));
}

/// Few values per axis, so that they often touch.
TEST(TriangleOverlap, EqualsTheOracleForCoordinatesOfAnySize) {
    Dice dice(5);
    Comparison comparison;
    for (int i = 0; i < support::repeats(300); ++i) {
        std::array<std::array<double, 4>, 3> values{};
        for (auto& axis : values) {
            for (double& value : axis) {
                const int exponent = dice.below(2098) - 1074;
                value = dice.chance(0.2) ? 0.0 : std::ldexp(dice.between(-1.0, 1.0), exponent);
            }
        }
        const auto point = [&]() -> Vec3 {
            const auto pick = [&](std::size_t axis) {
                return values[axis][static_cast<std::size_t>(dice.below(4))];
            };
            const double x = pick(0);
            const double y = pick(1);
            return {x, y, pick(2)};
        };
        const auto triangle = [&] {
            const Vec3 a = point();
            const Vec3 b = point();
            return Triangle{a, b, point()};
        };
        const Triangle s = triangle();
        const Triangle t = triangle();
        const bool expected = std::visit(
            [](const auto& x, const auto& y) { return CGAL::do_intersect(x, y); }, extent(s), extent(t));
        ASSERT_TRUE(comparison.agrees(s, t, expected, dice)) << i;
    }
    comparison.expect_at_least(support::repeats(30));
}

/// Seen from above, a terrain's triangles are disjoint but for shared vertices and edges.
TEST(TriangleOverlap, OnlyNeighboursOverlapInATerrain) {
    constexpr int kSide = 6;
    Dice dice(6);
    std::array<std::array<double, kSide + 1>, kSide + 1> height{};
    for (auto& row : height) {
        for (double& h : row) {
            h = dice.chance(0.5) ? 0.0 : dice.between(-1.0, 1.0);
        }
    }
    struct Tile {
        Triangle triangle;
        std::array<int, 3> vertices{};
    };
    std::vector<Tile> tiles;
    const auto add = [&](std::array<std::array<int, 2>, 3> at) {
        const auto vertex = [&](std::size_t i) {
            const auto [x, y] = at[i];
            return Vec3(0.1 * x, 0.3 * y, height[static_cast<std::size_t>(x)][static_cast<std::size_t>(y)]);
        };
        const auto name = [&](std::size_t i) { return at[i][0] + 100 * at[i][1]; };
        tiles.push_back({{vertex(0), vertex(1), vertex(2)}, {name(0), name(1), name(2)}});
    };
    for (int x = 0; x < kSide; ++x) {
        for (int y = 0; y < kSide; ++y) {
            add({{{x, y}, {x + 1, y}, {x, y + 1}}});
            add({{{x + 1, y}, {x + 1, y + 1}, {x, y + 1}}});
        }
    }
    for (const Tile& s : tiles) {
        for (const Tile& t : tiles) {
            const bool neighbours =
                std::find_first_of(s.vertices.begin(), s.vertices.end(), t.vertices.begin(),
                                   t.vertices.end()) != s.vertices.end();
            ASSERT_EQ(overlap(s.triangle, t.triangle), neighbours);
        }
    }
}

}  // namespace
}  // namespace campuswalk::collision

#include "collision/geometry/convex_distance.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "tests/support/effort.h"
#include "tests/support/mesh_pieces.h"
#include "tests/support/plain_solids.h"
#include "tests/support/random_scene.h"

namespace campuswalk::collision {
namespace {

using support::Dice;
using support::Line;

ConvexSolid solid_of(const Object& object) {
    return std::visit(
        [&](const auto& shape) {
            if constexpr (std::is_same_v<std::decay_t<decltype(shape)>,
                                         std::shared_ptr<const MeshCollider>>) {
                return ConvexSolid{};
            } else {
                return convex_solid(shape, object.X_world_shape);
            }
        },
        object.shape);
}

double distance_of(const Object& a, const Object& b) {
    return distance_between(solid_of(a), solid_of(b));
}

Object placed(const Shape& shape, const Vec3& at) {
    Object object;
    object.shape = shape;
    object.X_world_shape.translation = at;
    return object;
}

Object random_object(Dice& dice, double reach) {
    Object object;
    object.shape = support::random_solid(dice);
    object.X_world_shape = support::random_pose(dice, reach);
    return object;
}

/// A box or a wheel.
Object random_edged_object(Dice& dice, double reach) {
    Object object = random_object(dice, reach);
    while (!std::holds_alternative<Box>(object.shape) && !std::holds_alternative<Wheel>(object.shape)) {
        object = random_object(dice, reach);
    }
    return object;
}

// The oracle: the plain formulas' signed distances of single lines, and a search among the lines that fill a
// body. The distance is a convex function of the line's place.

template <typename Convex>
double least_between(double low, double high, const Convex& f) {
    double least = std::min(f(low), f(high));
    for (int i = 0; i < 40; ++i) {
        const double third = (high - low) / 3.0;
        const double left = f(low + third);
        const double right = f(high - third);
        least = std::min({least, left, right});
        (left < right ? high : low) = left < right ? high - third : low + third;
    }
    return least;
}

/// How far the points of a box or a wheel are from `other`, negative inside.
double searched_distance(const Object& edged, const Object& other) {
    const auto* box = std::get_if<Box>(&edged.shape);
    const auto* wheel = std::get_if<Wheel>(&edged.shape);
    const double half_x = box != nullptr ? box->half_extents.x() : wheel->half_width;
    const double half_y = box != nullptr ? box->half_extents.y() : wheel->radius;
    const auto half_z = [&](double y) {
        return box != nullptr ? box->half_extents.z()
                              : std::sqrt(std::max(0.0, wheel->radius * wheel->radius - y * y));
    };
    const Pose& X = edged.X_world_shape;
    return least_between(-half_x, half_x, [&](double x) {
        return least_between(-half_y, half_y, [&](double y) {
            return support::signed_distance(other,
                                            Line{X * Vec3(x, y, -half_z(y)), X * Vec3(x, y, half_z(y))});
        });
    });
}

double searched_distance(const Triangle& t, const Object& other) {
    return least_between(0.0, 1.0, [&](double s) {
        return support::signed_distance(other, Line{t.a + s * (t.c - t.a), t.b + s * (t.c - t.b)});
    });
}

TEST(DistanceBetweenSolids, OfBoxesAndWheelsAgreesWithASearch) {
    Dice dice(90);
    int apart = 0;
    int overlapping = 0;
    for (int i = 0; i < support::repeats(60); ++i) {
        const Object a = random_edged_object(dice, 1.0);
        const Object b = random_object(dice, 1.0);
        const double searched = searched_distance(a, b);
        ASSERT_NEAR(distance_of(a, b), std::max(0.0, searched), 1e-6) << i;
        ASSERT_NEAR(distance_of(b, a), distance_of(a, b), 1e-12) << i;
        apart += searched > 1e-3 ? 1 : 0;
        overlapping += searched < -1e-3 ? 1 : 0;
    }
    EXPECT_GT(apart, support::repeats(60) / 8);
    EXPECT_GT(overlapping, support::repeats(60) / 8);
}

TEST(DistanceBetweenSolids, OfSpheresAndCapsulesFollowsFromTheirSegments) {
    Dice dice(91);
    int apart = 0;
    for (int i = 0; i < support::repeats(4000); ++i) {
        const Object a = random_object(dice, 1.5);
        const double radius = dice.between(0.01, 0.5);
        const double half_length = dice.chance(0.3) ? 0.0 : dice.between(0.0, 1.0);
        Object b;
        b.shape = half_length > 0.0 ? Shape(Capsule{radius, half_length}) : Shape(Sphere{radius});
        b.X_world_shape = support::random_pose(dice, 1.5);
        const Vec3 half = b.X_world_shape.rotate(Vec3(0, half_length, 0));
        const Vec3& middle = b.X_world_shape.translation;
        const double exact =
            support::signed_distance(a, Line{Vec3(middle - half), Vec3(middle + half)}) - radius;
        ASSERT_NEAR(distance_of(a, b), std::max(0.0, exact), 1e-8) << i;
        apart += exact > 0.0 ? 1 : 0;
    }
    EXPECT_GT(apart, support::repeats(1000));
}

/// Fifteen axes: two boxes are apart if and only if one of them shows a gap.
double widest_gap(const Box& a, const Pose& A, const Box& b, const Pose& B) {
    std::vector<Vec3> axes;
    for (int i = 0; i < 3; ++i) {
        axes.push_back(A.rotation.col(i));
        axes.push_back(B.rotation.col(i));
        for (int j = 0; j < 3; ++j) {
            axes.push_back(Vec3(A.rotation.col(i)).cross(Vec3(B.rotation.col(j))));
        }
    }
    double widest = -1e300;
    for (const Vec3& axis : axes) {
        if (axis.norm() > 1e-6) {
            const Vec3 n = axis.normalized();
            const double reach = (A.rotation.transpose() * n).cwiseAbs().dot(a.half_extents) +
                                 (B.rotation.transpose() * n).cwiseAbs().dot(b.half_extents);
            widest = std::max(widest, std::abs(n.dot(B.translation - A.translation)) - reach);
        }
    }
    return widest;
}

TEST(DistanceBetweenSolids, OfBoxesIsZeroIfNoAxisSeparatesThem) {
    Dice dice(92);
    int apart = 0;
    const int rounds = support::repeats(20000);
    for (int i = 0; i < rounds; ++i) {
        const Box a{dice.in_cube(0.7).cwiseAbs().array() + 0.01};
        const Box b{dice.in_cube(0.7).cwiseAbs().array() + 0.01};
        const Pose A = support::random_pose(dice, 0.7);
        const Pose B = support::random_pose(dice, 0.7);
        const double gap = widest_gap(a, A, b, B);
        const double distance = distance_between(convex_solid(a, A), convex_solid(b, B));
        ASSERT_GE(distance, gap - 1e-12) << i;
        if (std::abs(gap) > 1e-12) {
            ASSERT_EQ(distance > 0.0, gap > 0.0) << i << ' ' << gap;
        }
        apart += gap > 0.0 ? 1 : 0;
    }
    EXPECT_GT(apart, rounds / 10);
    EXPECT_LT(apart, rounds - rounds / 10);
}

TEST(DistanceBetweenSolids, IsExactForParallelSolids) {
    const Box box{{0.5, 1.0, 1.5}};
    const Wheel wheel{0.3, 0.1};
    EXPECT_DOUBLE_EQ(distance_of(placed(box, {0, 0, 0}), placed(box, {1.25, 0.5, 1})), 0.25);
    EXPECT_DOUBLE_EQ(distance_of(placed(box, {0, 0, 0}), placed(box, {4, 6, 0.1})), 5.0);
    EXPECT_NEAR(distance_of(placed(wheel, {0, 0, 0}), placed(wheel, {0.7, 0, 0})), 0.5, 1e-14);
    EXPECT_NEAR(distance_of(placed(wheel, {0, 0, 0}), placed(wheel, {0.1, 0.8, 0.6})), 0.4, 1e-14);
    EXPECT_NEAR(distance_of(placed(wheel, {0, 0, 0}), placed(box, {0, 1.5, 0.3})), 0.2, 1e-14);
    EXPECT_NEAR(distance_of(placed(Sphere{0.5}, {0, 0, 0}), placed(Sphere{0.25}, {3, 0, 4})), 4.25, 1e-14);
}

TEST(DistanceBetweenSolids, IsZeroForNestedSolids) {
    const Object box = placed(Box{{5, 5, 5}}, {0, 0, 0});
    for (const Vec3& at : {Vec3(0, 0, 0), Vec3(1, 2, 3), Vec3(4.9, -4.9, 0)}) {
        for (const Shape& shape : {Shape(Box{{0.1, 0.2, 0.3}}), Shape(Sphere{0.05}), Shape(Capsule{0.1, 0.2}),
                                   Shape(Wheel{1, 2})}) {
            EXPECT_EQ(distance_of(box, placed(shape, at)), 0.0);
            EXPECT_EQ(distance_of(placed(shape, at), placed(shape, at)), 0.0);
        }
    }
}

/// Touching, and a nanometre more or less, here and far from the world's origin.
TEST(DistanceBetweenSolids, IsZeroUpToTouchingAndPositiveBeyond) {
    struct Case {
        Shape a;
        Shape b;
        Vec3 between = Vec3::Zero();
    };
    const Case cases[] = {{Box{{0.5, 0.5, 0.5}}, Box{{0.5, 0.5, 0.5}}, {1, 0.25, 0}},
                          {Box{{0.5, 0.5, 0.5}}, Box{{0.5, 0.5, 0.5}}, {1, 1, 1}},
                          {Box{{0.5, 0.5, 0.5}}, Sphere{0.25}, {0.75, 0, 0.125}},
                          {Box{{0.5, 0.5, 0.5}}, Wheel{0.25, 0.125}, {0, 0.75, 0.25}},
                          {Wheel{0.25, 0.125}, Wheel{0.5, 0.25}, {0.375, 0.5, 0}},
                          {Wheel{0.25, 0.125}, Wheel{0.5, 0.25}, {0.25, 0.45, 0.6}},
                          {Wheel{0.25, 0.125}, Capsule{0.25, 0.5}, {0, 1, 0}},
                          {Capsule{0.25, 0.5}, Capsule{0.25, 0.5}, {0.3, 0, 0.4}},
                          {Sphere{0.25}, Sphere{0.5}, {0.25, -0.5, 0.5}}};
    for (const Case& c : cases) {
        for (const Vec3& origin : {Vec3(0, 0, 0), Vec3(84616, 12.5, 447750)}) {
            const Object a = placed(c.a, origin);
            const double farther = 1.0 + 1e-8;
            EXPECT_LT(distance_of(a, placed(c.b, origin + c.between)), 1e-9);
            EXPECT_EQ(distance_of(a, placed(c.b, origin + c.between / farther)), 0.0);
            EXPECT_GT(distance_of(a, placed(c.b, origin + c.between * farther)), 0.0);
        }
        EXPECT_EQ(distance_of(placed(c.a, {0, 0, 0}), placed(c.b, c.between)), 0.0);
    }
}

/// A plate at any pose, under any point of the rim. Points of the rim whose heights differ by less than the
/// rounding error h can't be told apart: those within sqrt(2 r h) of the nearest one. A search that ends
/// there overestimates a gap g by r h / g.
TEST(DistanceBetweenSolids, OfAWheelAboveAPlateIsTheGap) {
    Dice dice(93);
    const double rounding = 16.0 * 4.0 * 0x1p-52;  // sixteen roundings of coordinates of 4 m and more
    for (int i = 0; i < support::repeats(2000); ++i) {
        const Pose plate = support::random_pose(dice, 2.0);
        const Wheel wheel{dice.between(0.1, 1.0), dice.between(0.01, 0.5)};
        const double gap = dice.chance(0.5) ? 0.0 : std::pow(10.0, dice.between(-7.0, 0.0));
        Pose rolling;
        rolling.rotation = plate.rotation * support::turn(Vec3::UnitY(), dice.between(-3.0, 3.0)) *
                           support::turn(Vec3::UnitX(), dice.between(-3.0, 3.0));
        rolling.translation =
            plate * Vec3(dice.between(-1, 1), 0.1 + wheel.radius + gap, dice.between(-1, 1));
        const double distance =
            distance_between(convex_solid(wheel, rolling), convex_solid(Box{{3, 0.1, 3}}, plate));
        ASSERT_NEAR(distance, gap, gap > 0.0 ? 1e-13 + wheel.radius * rounding / gap : 0.0) << i;
    }
}

TEST(DistanceToTriangle, AgreesWithASearch) {
    Dice dice(94);
    int apart = 0;
    int overlapping = 0;
    for (int i = 0; i < support::repeats(1500); ++i) {
        const Object solid = random_object(dice, 1.0);
        const Triangle t = support::random_triangle(dice, dice.in_cube(1.0));
        const double searched = searched_distance(t, solid);
        ASSERT_NEAR(distance_between(solid_of(solid), t), std::max(0.0, searched), 1e-6) << i;
        apart += searched > 1e-3 ? 1 : 0;
        overlapping += searched < -1e-3 ? 1 : 0;
    }
    EXPECT_GT(apart, support::repeats(1500) / 15);
    EXPECT_GT(overlapping, support::repeats(1500) / 15);
}

/// The part of a polygon where `side * x <= most`.
std::vector<Vec3> clipped(const std::vector<Vec3>& polygon, double side, double most) {
    std::vector<Vec3> inside;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3& p = polygon[i];
        const Vec3& q = polygon[(i + 1) % polygon.size()];
        const double beyond_p = side * p.x() - most;
        const double beyond_q = side * q.x() - most;
        if (beyond_p <= 0.0) {
            inside.push_back(p);
        }
        if ((beyond_p < 0.0 && beyond_q > 0.0) || (beyond_p > 0.0 && beyond_q < 0.0)) {
            inside.push_back(p + beyond_p / (beyond_p - beyond_q) * (q - p));
        }
    }
    return inside;
}

/// The polygon's distance to the x axis.
double least_axis_distance(const std::vector<Vec3>& polygon) {
    double least = 1e300;
    int above = 0;
    int below = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Eigen::Vector2d p = polygon[i].tail<2>();
        const Eigen::Vector2d d = polygon[(i + 1) % polygon.size()].tail<2>() - p;
        const double length2 = d.squaredNorm();
        const double part = length2 > 0.0 ? std::clamp(-p.dot(d) / length2, 0.0, 1.0) : 0.0;
        least = std::min(least, (p + part * d).norm());
        const double turn = p.x() * d.y() - p.y() * d.x();
        above += turn > 0.0 ? 1 : 0;
        below += turn < 0.0 ? 1 : 0;
    }
    const bool around_the_axis = (above == 0) != (below == 0);
    return around_the_axis ? 0.0 : least;
}

/// In closed form: the part of the triangle between the wheel's flat sides, and its distance to the axle.
TEST(DistanceToTriangle, OfAWheelIsZeroWhereClippingLeavesAPart) {
    Dice dice(95);
    int overlapping = 0;
    const int rounds = support::repeats(20000);
    for (int i = 0; i < rounds; ++i) {
        const Wheel wheel{dice.between(0.05, 0.6), dice.between(0.02, 0.5)};
        const Pose X = support::random_pose(dice, 0.5);
        const Triangle t = support::random_triangle(dice, dice.in_cube(0.6));
        const std::vector<Vec3> whole = {X.inverse_apply(t.a), X.inverse_apply(t.b), X.inverse_apply(t.c)};
        const auto reaches = [&](double slack) {
            const double most = wheel.half_width + slack;
            const std::vector<Vec3> part = clipped(clipped(whole, 1.0, most), -1.0, most);
            return !part.empty() && least_axis_distance(part) <= wheel.radius + slack;
        };
        const bool overlaps = distance_between(convex_solid(wheel, X), t) <= 0.0;
        if (reaches(1e-9) == reaches(-1e-9)) {
            ASSERT_EQ(overlaps, reaches(0.0)) << i;
        }
        overlapping += overlaps ? 1 : 0;
    }
    EXPECT_GT(overlapping, rounds / 10);
    EXPECT_LT(overlapping, rounds - rounds / 10);
}

}  // namespace
}  // namespace campuswalk::collision

#include "collision/geometry/closest.h"

#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "tests/support/effort.h"
#include "tests/support/plain_solids.h"
#include "tests/support/random_scene.h"

namespace campuswalk::collision {
namespace {

using support::Dice;
using support::Line;
using support::vertices_of;

constexpr double kRounding = 1e-9;

Line line_of(const Segment& s) {
    return {s.a, s.b};
}

/// Long, short, upright, level or a single point.
Segment random_segment(Dice& dice) {
    Segment s{dice.in_cube(2.0), dice.in_cube(2.0)};
    switch (dice.below(5)) {
        case 0:
            s.b = s.a + dice.in_cube(0.1);
            break;
        case 1:
            s.b = s.a + Vec3(0, dice.between(0.0, 2.0), 0);
            break;
        case 2:
            s.b = s.a;
            break;
        default:
            break;
    }
    return s;
}

/// The distance is that of the two points, and each of them lies on its shape.
void expect_consistent(const Closest& c, const Segment& segment, double off_shape) {
    EXPECT_NEAR((c.on_segment - c.on_shape).norm(), c.distance, kRounding);
    EXPECT_LT(support::distance(c.on_segment, line_of(segment)), kRounding);
    EXPECT_LT(off_shape, kRounding);
}

TEST(ClosestOnSegment, IsTheFootOfThePerpendicularOrAnEnd) {
    const Segment s{{0, 0, 0}, {4, 0, 0}};
    EXPECT_EQ(closest_on_segment(s, {1, 5, 2}), Vec3(1, 0, 0));
    EXPECT_EQ(closest_on_segment(s, {-3, 5, 2}), Vec3(0, 0, 0));
    EXPECT_EQ(closest_on_segment(s, {9, 5, 2}), Vec3(4, 0, 0));
    EXPECT_EQ(closest_on_segment({{1, 1, 1}, {1, 1, 1}}, {9, 5, 2}), Vec3(1, 1, 1));
}

TEST(ClosestOnSegment, AddsComponentsInTheSameOrderOnEveryProcessor) {
    // x + (y + z) is 1 + 2^-52; Eigen's packets of two would make it (x + y) + z, which is 1.
    const Vec3 nearest = closest_on_segment({Vec3::Zero(), Vec3::Ones()}, Vec3(1.0, 0x1p-53, 0x1p-53));

    EXPECT_EQ(nearest.x(), (1.0 + 0x1p-52) / 3.0);
}

TEST(ClosestOnTriangle, AgreesWithThePlainFormula) {
    Dice dice(20);
    for (int i = 0; i < 20000; ++i) {
        const Triangle t = support::random_triangle(dice, dice.in_cube(1.0));
        const Vec3 p = dice.in_cube(3.0);
        Feature feature{};
        const Vec3 q = closest_on_triangle(t, p, feature);
        const double exact = support::distance(Line{p, p}, vertices_of(t));
        ASSERT_NEAR((p - q).norm(), exact, kRounding) << i;
        ASSERT_LT(support::distance(Line{q, q}, vertices_of(t)), kRounding) << i;
    }
}

TEST(ClosestOnTriangle, ReportsAFaceOnlyOverTheInterior) {
    const Triangle t{{0, 0, 0}, {4, 0, 0}, {0, 0, 3}};
    const auto feature_at = [&](const Vec3& p) {
        Feature feature{};
        closest_on_triangle(t, p, feature);
        return feature;
    };
    EXPECT_EQ(feature_at({1, 2, 1}), Feature::face);
    EXPECT_EQ(feature_at({1, -2, 1}), Feature::face);
    EXPECT_EQ(feature_at({1, 2, -1}), Feature::edge);
    EXPECT_EQ(feature_at({-1, 2, -1}), Feature::edge);
    EXPECT_EQ(feature_at({3, 0, 3}), Feature::edge);
}

TEST(ClosestSegments, AgreeWithThePlainFormula) {
    Dice dice(21);
    for (int i = 0; i < 20000; ++i) {
        const Segment s = random_segment(dice);
        const Segment t = random_segment(dice);
        const Closest c = closest(s, t);
        ASSERT_NEAR(c.distance, support::distance(line_of(s), line_of(t)), kRounding) << i;
        expect_consistent(c, s, support::distance(c.on_shape, line_of(t)));
    }
}

TEST(ClosestSegments, AgreeWithThePlainFormulaWhenParallel) {
    Dice dice(22);
    for (int i = 0; i < 2000; ++i) {
        const Segment s{dice.in_cube(1.0), dice.in_cube(1.0)};
        const Vec3 move = dice.in_cube(3.0);
        const double stretch = dice.between(-2.0, 2.0);
        const Segment t{s.a + move, s.a + move + stretch * (s.b - s.a)};
        const Closest c = closest(s, t);
        ASSERT_NEAR(c.distance, support::distance(line_of(s), line_of(t)), 1e-7) << i;
    }
}

TEST(ClosestSegmentAndTriangle, AgreeWithThePlainFormula) {
    Dice dice(23);
    int piercing = 0;
    for (int i = 0; i < 20000; ++i) {
        const Segment s = random_segment(dice);
        const Triangle t = support::random_triangle(dice, dice.in_cube(1.0));
        const Closest c = closest(s, t);
        ASSERT_NEAR(c.distance, support::distance(line_of(s), vertices_of(t)), kRounding) << i;
        expect_consistent(c, s, support::distance(Line{c.on_shape, c.on_shape}, vertices_of(t)));
        piercing += c.distance == 0.0 ? 1 : 0;
    }
    EXPECT_GT(piercing, 200);
}

TEST(ClosestSegmentAndTriangle, OverAFaceAreApartAlongItsNormal) {
    Dice dice(24);
    int faces = 0;
    for (int i = 0; i < 5000; ++i) {
        const Segment s = random_segment(dice);
        const Triangle t = support::random_triangle(dice, dice.in_cube(1.0));
        const Closest c = closest(s, t);
        if (c.feature == Feature::face && c.distance > 1e-3) {
            const Vec3 normal = (t.b - t.a).cross(t.c - t.a);
            const Vec3 gap = (c.on_segment - c.on_shape) / c.distance;
            EXPECT_GT(std::abs(gap.dot(normal.normalized())), 1.0 - 1e-6) << i;
            ++faces;
        }
    }
    EXPECT_GT(faces, 100);
}

/// Beside an upright wall every point of an upright segment is equally near: rounding must not turn the face
/// into an edge.
TEST(ClosestSegmentAndTriangle, ParallelToAFaceReportTheFace) {
    Dice dice(28);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 along = Vec3(dice.between(-1, 1), 0, dice.between(0.1, 1)).normalized();
        const Vec3 out = along.cross(Vec3::UnitY());
        const Vec3 at = dice.in_cube(50.0);
        const Triangle t{at - 3 * along, at + 3 * along, at + 3 * along + Vec3(0, 5, 0)};
        const double gap = dice.between(0.01, 1.0);
        const Vec3 low = at + gap * out + dice.between(-2.5, -1.3) * along + Vec3(0, 0.3, 0);
        const Closest c = closest(Segment{low, low + Vec3(0, 1.2, 0)}, t);
        ASSERT_EQ(c.feature, Feature::face) << i;
        ASSERT_NEAR(c.distance, gap, kRounding) << i;
    }
}

class ClosestToSolid : public ::testing::TestWithParam<std::uint32_t> {};

Closest closest_to(const Segment& segment, const Object& object) {
    return std::visit(
        [&](const auto& solid) {
            if constexpr (std::is_same_v<std::decay_t<decltype(solid)>,
                                         std::shared_ptr<const MeshCollider>>) {
                return Closest{};
            } else {
                return closest(segment, solid, object.X_world_shape);
            }
        },
        object.shape);
}

TEST_P(ClosestToSolid, AgreesWithThePlainFormula) {
    Dice dice(GetParam());
    int apart = 0;
    for (int i = 0; i < support::repeats(2000); ++i) {
        Object object;
        object.shape = support::random_solid(dice);
        object.X_world_shape = support::random_pose(dice, 1.0);
        const Segment s = random_segment(dice);
        const Closest c = closest_to(s, object);
        const double exact = support::signed_distance(object, line_of(s));
        // Where they touch, a search along the segment finds the place to 1e-10 only.
        ASSERT_NEAR(c.distance, std::max(0.0, exact), 1e-8) << i;
        const double off = support::signed_distance(object, Line{c.on_shape, c.on_shape});
        expect_consistent(c, s, std::max(0.0, off));
        apart += c.distance > 0.0 ? 1 : 0;
    }
    EXPECT_GT(apart, support::repeats(800));
}

INSTANTIATE_TEST_SUITE_P(Seeds, ClosestToSolid, ::testing::Values(25U, 26U, 27U));

TEST(ClosestToBox, DistinguishesFacesFromEdges) {
    const Box box{{1, 1, 1}};
    const auto feature_at = [&](const Vec3& p) { return closest(Segment{p, p}, box, Pose{}).feature; };
    EXPECT_EQ(feature_at({3, 0.5, 0.5}), Feature::face);
    EXPECT_EQ(feature_at({3, 3, 0.5}), Feature::edge);
    EXPECT_EQ(feature_at({3, 3, 3}), Feature::edge);
}

TEST(ClosestToWheel, DistinguishesFacesFromTheRim) {
    const Wheel wheel{1.0, 0.2};
    const auto feature_at = [&](const Vec3& p) { return closest(Segment{p, p}, wheel, Pose{}).feature; };
    EXPECT_EQ(feature_at({3, 0.5, 0.5}), Feature::face);
    EXPECT_EQ(feature_at({0.1, 3, 0}), Feature::face);
    EXPECT_EQ(feature_at({3, 3, 0}), Feature::edge);
}

TEST(MinimiseConvex, FindsTheMinimum) {
    EXPECT_NEAR(minimise_convex([](double t) { return (t - 0.3) * (t - 0.3); }), 0.3, 1e-7);
    EXPECT_EQ(minimise_convex([](double t) { return t; }), 0.0);
    EXPECT_EQ(minimise_convex([](double t) { return -t; }), 1.0);
    EXPECT_NEAR(minimise_convex([](double t) { return std::abs(t - 0.7); }), 0.7, 1e-9);
}

}  // namespace
}  // namespace campuswalk::collision

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <gtest/gtest.h>

#include "collision/geometry/closest.h"
#include "collision/geometry/ray.h"
#include "collision/mesh/mesh_query.h"
#include "tests/support/dice.h"
#include "tests/support/effort.h"
#include "tests/support/mesh_pieces.h"

/// Segments and triangles on a small integer grid intersect in every degenerate way: at vertices, along
/// edges, within planes. CGAL's exact predicates decide which of them do.
namespace campuswalk::collision {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using support::Dice;

/// Far above rounding and far below the smallest gap between disjoint things on the grid.
constexpr double kNanometre = 1e-9;
constexpr int kGrid = 4;

Vec3 grid_point(Dice& dice) {
    const double x = dice.below(2 * kGrid + 1) - kGrid;
    const double y = dice.below(2 * kGrid + 1) - kGrid;
    return {x, y, static_cast<double>(dice.below(2 * kGrid + 1) - kGrid)};
}

Kernel::Point_3 exact(const Vec3& p) {
    return {p.x(), p.y(), p.z()};
}

Kernel::Triangle_3 exact(const Triangle& t) {
    return {exact(t.a), exact(t.b), exact(t.c)};
}

Kernel::Segment_3 exact(const Segment& s) {
    return {exact(s.a), exact(s.b)};
}

/// A pair that CGAL's predicates accept: neither is degenerate.
struct Pair {
    Segment segment;
    Triangle triangle;

    explicit Pair(Dice& dice) {
        do {
            segment = {grid_point(dice), grid_point(dice)};
            triangle = {grid_point(dice), grid_point(dice), grid_point(dice)};
        } while (exact(segment).is_degenerate() || exact(triangle).is_degenerate());
    }
    bool intersect() const { return CGAL::do_intersect(exact(segment), exact(triangle)); }
    /// The segment passes from one side to the other, through the inside.
    bool cross() const {
        const auto side = [&](const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
            return CGAL::orientation(exact(p), exact(q), exact(r), exact(s));
        };
        const Triangle& t = triangle;
        const auto from = side(t.a, t.b, t.c, segment.a);
        const auto to = side(t.a, t.b, t.c, segment.b);
        const auto u = side(segment.a, segment.b, t.a, t.b);
        const auto v = side(segment.a, segment.b, t.b, t.c);
        const auto w = side(segment.a, segment.b, t.c, t.a);
        return from != CGAL::COPLANAR && from == -to && u != CGAL::COPLANAR && u == v && v == w;
    }
};

TEST(ExactTriangle, DistanceIsZeroOnlyWhereTheyIntersect) {
    Dice dice(120);
    int intersecting = 0;
    int touching = 0;
    for (int i = 0; i < support::repeats(40000); ++i) {
        const Pair pair(dice);
        const double distance = closest(pair.segment, pair.triangle).distance;
        if (pair.intersect()) {
            ASSERT_LT(distance, kNanometre) << i;
            ++intersecting;
            touching += pair.cross() ? 0 : 1;
        } else {
            ASSERT_GT(distance, 1e-4) << i;
        }
    }
    EXPECT_GT(intersecting, support::repeats(1000));
    EXPECT_GT(touching, support::repeats(200)) << "degenerate intersections are among them";
}

TEST(ExactTriangle, RaysHitWhatTheyCrossAndNothingTheyMiss) {
    Dice dice(121);
    int crossing = 0;
    for (int i = 0; i < support::repeats(40000); ++i) {
        const Pair pair(dice);
        const auto found = hit(Ray{pair.segment.a, pair.segment.b}, pair.triangle);
        if (pair.cross()) {
            ASSERT_TRUE(found) << i;
            ++crossing;
        } else if (!pair.intersect()) {
            ASSERT_FALSE(found) << i;
        }
    }
    EXPECT_GT(crossing, support::repeats(400));
}

TEST(ExactTriangle, TheTreeFindsExactlyTheIntersectingTriangles) {
    Dice dice(122);
    std::size_t found = 0;
    for (int m = 0; m < support::repeats(40); ++m) {
        TriangleMesh mesh;
        std::vector<Triangle> triangles;
        for (int i = 0; i < 100; ++i) {
            triangles.push_back(Pair(dice).triangle);
            support::add_triangle(mesh, triangles.back().a, triangles.back().b, triangles.back().c);
        }
        const MeshCollider collider(mesh, m % 2 == 0 ? TreeKind::bvh8 : TreeKind::hybrid);
        for (int i = 0; i < 20; ++i) {
            const Segment segment = Pair(dice).segment;
            std::vector<std::uint32_t> expected;
            for (std::uint32_t t = 0; t < triangles.size(); ++t) {
                if (CGAL::do_intersect(exact(segment), exact(triangles[t]))) {
                    expected.push_back(t);
                }
            }
            std::vector<std::uint32_t> near;
            triangles_near(collider, segment, kNanometre, near);
            ASSERT_EQ(near, expected) << m << ' ' << i;
            found += near.size();
        }
    }
    EXPECT_GT(found, 200U);
}

}  // namespace
}  // namespace campuswalk::collision

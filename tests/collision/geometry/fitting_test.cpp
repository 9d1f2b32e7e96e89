#include "collision/geometry/fitting.h"

#include <cmath>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "tests/collision/hybrid/paper_volumes.h"
#include "tests/support/mesh_pieces.h"
#include "tests/support/random_scene.h"

namespace campuswalk::collision {
namespace {

std::vector<std::uint32_t> all_of(const TriangleMesh& mesh) {
    std::vector<std::uint32_t> triangles(mesh.triangles.size());
    std::iota(triangles.begin(), triangles.end(), 0U);
    return triangles;
}

double distance_to_edge(const Vec3& p, const Vec3& a, const Vec3& b) {
    return (b - a).cross(p - a).norm() / (b - a).norm();
}

TEST(Incentre, IsKnownForTheThreeFourFiveTriangle) {
    const Vec3 center = incentre({Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 3, 0)});
    EXPECT_LT((center - Vec3(1, 1, 0)).norm(), 1e-15);
}

TEST(Incentre, IsInsideAndEquidistantFromTheEdges) {
    support::Dice dice(12);
    for (int i = 0; i < 1000; ++i) {
        const Triangle t{dice.in_cube(1.0), dice.in_cube(1.0), dice.in_cube(1.0)};
        const Vec3 p = incentre(t);
        const Vec3 normal = (t.b - t.a).cross(t.c - t.a);
        const double radius = normal.norm() / ((t.b - t.a).norm() + (t.c - t.b).norm() + (t.a - t.c).norm());
        EXPECT_NEAR(distance_to_edge(p, t.a, t.b), radius, 1e-12);
        EXPECT_NEAR(distance_to_edge(p, t.b, t.c), radius, 1e-12);
        EXPECT_NEAR(distance_to_edge(p, t.c, t.a), radius, 1e-12);
        EXPECT_GT(normal.dot((t.b - t.a).cross(p - t.a)), 0.0);
        EXPECT_GT(normal.dot((t.c - t.b).cross(p - t.b)), 0.0);
        EXPECT_GT(normal.dot((t.a - t.c).cross(p - t.c)), 0.0);
    }
}

TEST(Incentre, OfATriangleWithoutAreaIsOnIt) {
    const Vec3 a(1, 2, 3);
    EXPECT_EQ(incentre({a, a, a}), a);
    const Vec3 p = incentre({a, a, a + Vec3(1, 0, 0)});
    EXPECT_LT((p - a).norm(), 1e-15) << "between the two long edges";
    const Vec3 q = incentre({a, a + Vec3(1, 0, 0), a + Vec3(3, 0, 0)});
    EXPECT_LT((q - (a + Vec3(1, 0, 0))).norm(), 1e-15) << "at the vertex between the others";
}

TEST(Fitting, FollowsThePaperOnRandomMeshes) {
    support::Dice dice(13);
    for (int i = 0; i < 300; ++i) {
        SCOPED_TRACE(i);
        const TriangleMesh mesh = support::random_mesh(dice, 1 + dice.below(40), dice.between(0.0, 5.0));
        const auto triangles = all_of(mesh);
        EXPECT_TRUE(is_outer_sphere(fit_outer_sphere(mesh, triangles), mesh, triangles));
        EXPECT_TRUE(is_inner_box(fit_inner_box(mesh, triangles), mesh, triangles));
    }
}

TEST(Fitting, ConsidersOnlyTheGivenTriangles) {
    support::Dice dice(14);
    const TriangleMesh mesh = support::random_mesh(dice, 50, 5.0);
    const std::vector<std::uint32_t> some{3, 17, 18, 40};
    EXPECT_TRUE(is_outer_sphere(fit_outer_sphere(mesh, some), mesh, some));
    EXPECT_TRUE(is_inner_box(fit_inner_box(mesh, some), mesh, some));
    EXPECT_FALSE(is_outer_sphere(fit_outer_sphere(mesh, some), mesh, all_of(mesh)));
    EXPECT_FALSE(is_inner_box(fit_inner_box(mesh, some), mesh, all_of(mesh)));
}

TEST(Fitting, ADistantBeamKeepsItsOwnAxis) {
    // With products about the origin instead of the mean the first axis would point at (100, 40, -70).
    const Vec3 along = Vec3(1, 2, 2) / 3.0;
    const Vec3 at(100, 40, -70);
    TriangleMesh beam;
    const Vec3 side = 0.1 * along.unitOrthogonal();
    support::add_quad(beam, at - 5 * along - side, at + 5 * along - side, at + 5 * along + side,
                      at - 5 * along + side);
    const OrientedBox box = fit_inner_box(beam, all_of(beam));
    int longest = 0;
    EXPECT_NEAR(box.half_extents.maxCoeff(&longest), 5.0, 5e-3);
    EXPECT_GT(std::abs(box.axes.col(longest).dot(along)), 0.99);
}

TEST(Fitting, AxesAreOrthonormalToATenthOfTheOutwardMargin) {
    support::Dice dice(17);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 at = dice.chance(0.3) ? Vec3(450000, 60, -448000) : Vec3(0, 0, 0);
        const Vec3 along = std::pow(10.0, dice.between(-6.0, 6.0)) * dice.in_cube(1.0);
        const double width = std::pow(10.0, dice.between(-9.0, 3.0));
        TriangleMesh mesh;
        for (int k = 0; k < 1 + dice.below(4); ++k) {
            support::add_triangle(mesh, at + dice.in_cube(width), at + along, at + dice.in_cube(width));
        }
        const Mat3 axes = fit_inner_box(mesh, all_of(mesh)).axes;
        EXPECT_LT((axes.transpose() * axes - Mat3::Identity()).norm(), 0.1 * kOutward) << i;
    }
}

TEST(Fitting, ASinglePointHasVolumesOfZeroSize) {
    TriangleMesh dot;
    support::add_triangle(dot, {1, 2, 3}, {1, 2, 3}, {1, 2, 3});
    const auto triangles = all_of(dot);
    EXPECT_TRUE(is_outer_sphere(fit_outer_sphere(dot, triangles), dot, triangles));
    EXPECT_TRUE(is_inner_box(fit_inner_box(dot, triangles), dot, triangles));
    EXPECT_LT(fit_inner_box(dot, triangles).radius, 1e-10);
}

}  // namespace
}  // namespace campuswalk::collision

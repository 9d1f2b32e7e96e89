#include "collision/mesh/mesh_contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "tests/collision/mesh/loop_queries.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/effort.h"
#include "tests/support/mesh_pieces.h"
#include "tests/support/random_scene.h"

namespace campuswalk::collision {
namespace {

using support::Dice;
using support::repeats;

/// A minimum number of contacts, scaled like `repeats`.
std::size_t at_least(int plain) {
    return static_cast<std::size_t>(repeats(plain));
}

/// Checks both queries with every SIMD target against the loop over all pairs; returns how many overlap.
std::size_t expect_exact(const MeshCollider& a, const MeshCollider& b, const Pose& X_a_b) {
    const std::vector<TrianglePair> expected = support::loop_contacts(a.mesh(), b.mesh(), X_a_b);
    std::vector<TrianglePair> in_order;
    std::optional<TrianglePair> found_first;
    for (const SimdTarget simd_target : supported_simd_targets()) {
        SCOPED_TRACE(static_cast<int>(simd_target));
        std::vector<TrianglePair> pairs{{77, 77}};
        QueryStatistics counters;
        all_contacts(a, b, X_a_b, pairs, &counters, simd_target);
        const auto first = first_contact(a, b, X_a_b, &counters, simd_target);
        EXPECT_EQ(first.has_value(), !expected.empty());
        EXPECT_TRUE(!first || std::binary_search(expected.begin(), expected.end(), *first));
        if (simd_target == SimdTarget::sse42) {
            in_order = pairs;
            found_first = first;
        }
        EXPECT_EQ(pairs, in_order);
        EXPECT_EQ(first, found_first);
        std::sort(pairs.begin(), pairs.end());
        EXPECT_EQ(pairs, expected);
    }
    return expected.size();
}

/// So far from a mesh's origin that float32 has steps of 3 cm.
const Vec3 kFar(450000.0, 60.0, -448000.0);

TEST(MeshContacts, AgreeWithALoopOverAllPairs) {
    Dice dice(410);
    std::size_t found = 0;
    for (int i = 0; i < repeats(150); ++i) {
        SCOPED_TRACE(i);
        const MeshCollider a(support::random_mesh(dice, 1 + dice.below(150), dice.between(0.5, 4.0)));
        const MeshCollider b(support::random_mesh(dice, 1 + dice.below(150), dice.between(0.5, 4.0)));
        found += expect_exact(a, b, support::random_pose(dice, 3.0));
    }
    EXPECT_GT(found, at_least(1000));
}

TEST(MeshContacts, OfSurfacesWithSharedVerticesAgreeWithTheLoop) {
    Dice dice(411);
    const MeshCollider a(support::ball(26));
    const MeshCollider b(support::ball(19));
    for (int i = 0; i < repeats(10); ++i) {
        SCOPED_TRACE(i);
        Pose X = support::random_pose(dice, 1.0);
        EXPECT_GT(expect_exact(a, b, X), 0U);
        X.translation = X.translation.normalized() * 1.99;
        expect_exact(a, b, X);
    }
}

TEST(MeshContacts, OnALatticeAgreeWithTheLoop) {
    Dice dice(412);
    std::size_t found = 0;
    for (int i = 0; i < repeats(120); ++i) {
        SCOPED_TRACE(i);
        const MeshCollider a(support::lattice_soup(dice, 60, Vec3::Zero()));
        const MeshCollider b(support::lattice_soup(dice, 60, Vec3::Zero()));
        const Mat3 turn = support::lattice_turn(dice);
        const Vec3 middle(3, 3, 3);
        const Vec3 shift(dice.below(9) - 4, dice.below(9) - 4, dice.below(9) - 4);
        found += expect_exact(a, b, {turn, middle - turn * middle + shift});
    }
    EXPECT_GT(found, at_least(10000));
}

TEST(MeshContacts, OfAMeshWithItselfIncludeEveryTriangle) {
    Dice dice(413);
    for (int i = 0; i < repeats(20); ++i) {
        const MeshCollider mesh(support::random_mesh(dice, 80, 2.0));
        EXPECT_GE(expect_exact(mesh, mesh, {}), mesh.mesh().triangles.size());
    }
    const MeshCollider ball(support::ball(20));
    EXPECT_GE(expect_exact(ball, ball, {}), ball.mesh().triangles.size());
}

TEST(MeshContacts, OfCoplanarFloorsVanishWithTheSmallestGap) {
    TriangleMesh coarse;
    TriangleMesh fine;
    support::add_floor(coarse, 4.0, 0.0, 1.0);
    support::add_floor(fine, 4.0, 0.0, 0.5);
    const MeshCollider a(coarse);
    const MeshCollider b(fine);
    EXPECT_GT(expect_exact(a, b, {}), fine.triangles.size());
    EXPECT_GT(expect_exact(a, b, {Mat3::Identity(), Vec3(0.3, 0.0, -0.7)}), 0U);
    EXPECT_EQ(expect_exact(a, b, {Mat3::Identity(), Vec3(8.0, 0.0, 8.0)}), 1U) << "vertex to vertex";
    EXPECT_EQ(expect_exact(a, b, {Mat3::Identity(), Vec3(std::nextafter(8.0, 9.0), 0.0, 0.0)}), 0U);
    for (const double gap : {1e-9, -1e-9, 5e-324}) {
        EXPECT_EQ(expect_exact(a, b, {Mat3::Identity(), Vec3(0.0, gap, 0.0)}), 0U);
    }
}

TEST(MeshContacts, OfNeedlesAgreeWithTheLoop) {
    Dice dice(414);
    std::size_t found = 0;
    for (int i = 0; i < repeats(50); ++i) {
        SCOPED_TRACE(i);
        const MeshCollider a(support::needles(dice, 40));
        const MeshCollider b(dice.chance(0.5) ? a.mesh() : support::needles(dice, 40));
        const Pose still;
        found += expect_exact(a, b, dice.chance(0.5) ? still : support::random_pose(dice, 0.01));
    }
    EXPECT_GT(found, at_least(300));
}

TEST(MeshContacts, OfTrianglesWithoutAreaAgreeWithTheLoop) {
    Dice dice(415);
    std::size_t found = 0;
    for (int i = 0; i < repeats(25); ++i) {
        SCOPED_TRACE(i);
        TriangleMesh flat = support::lattice_soup(dice, 50, Vec3::Zero());
        for (auto& t : flat.triangles) {
            t[2] = dice.chance(0.5) ? t[0] : t[1];
            t[1] = dice.chance(0.3) ? t[0] : t[1];
        }
        const MeshCollider a(flat);
        found += expect_exact(a, MeshCollider(support::lattice_soup(dice, 50, Vec3::Zero())), {});
        found += expect_exact(a, a, {});
    }
    EXPECT_GT(found, at_least(1000));
}

TEST(MeshContacts, FarFromAnOriginAgreeWithTheLoop) {
    Dice dice(416);
    std::size_t found = 0;
    for (int i = 0; i < repeats(60); ++i) {
        SCOPED_TRACE(i);
        const MeshCollider near(dice.chance(0.5) ? support::lattice_soup(dice, 60, Vec3::Zero())
                                                 : support::random_mesh(dice, 60, 4.0));
        const MeshCollider far(support::lattice_soup(dice, 60, kFar));
        const Mat3 turn =
            dice.chance(0.3) ? support::lattice_turn(dice) : support::random_pose(dice, 0.0).rotation;
        found += expect_exact(far, near, {turn, kFar + dice.in_cube(2.0)});
        found += expect_exact(near, far, {turn, dice.in_cube(2.0) - turn * kFar});
        found += expect_exact(far, far, {turn, kFar - turn * kFar});
    }
    EXPECT_GT(found, at_least(1000));
}

TEST(MeshContacts, IncludeTouchingTrianglesFarFromAnOriginDespiteRounding) {
    // The transform rounds b's vertices to steps of 6e-11 m, and points have no size that a slack could be
    // proportional to.
    Dice dice(417);
    std::size_t found = 0;
    for (int i = 0; i < repeats(300); ++i) {
        SCOPED_TRACE(i);
        const Pose X{support::random_pose(dice, 0.0).rotation, kFar + dice.in_cube(100.0)};
        const MeshCollider b(support::random_mesh(dice, 20, 2.0));
        TriangleMesh touching;  // each has a vertex, or all three, at a vertex of b
        for (const auto& p : b.mesh().positions) {
            const Vec3 at = b_vertex_in_a(X, p);
            const double size = dice.chance(0.3) ? 0.0 : 1.0;
            support::add_triangle(touching, at, at + dice.in_cube(size), at + dice.in_cube(size));
        }
        found += expect_exact(MeshCollider(touching), b, X);
    }
    EXPECT_GT(found, at_least(1000));
}

TEST(MeshContacts, IncludeCoincidentPoints) {
    Dice dice(418);
    for (int i = 0; i < repeats(200); ++i) {
        SCOPED_TRACE(i);
        // Integer coordinates and a permutation of the axes: nothing is rounded, the points coincide exactly.
        const Mat3 turn = support::lattice_turn(dice);
        const Vec3 at(dice.below(1000), dice.below(1000), dice.below(1000));
        const Vec3 shift(dice.below(1000), dice.below(1000), dice.below(1000));
        TriangleMesh point;
        support::add_triangle(point, at, at, at);
        TriangleMesh image;
        const Vec3 there = turn * at + shift;
        support::add_triangle(image, there, there, there);
        EXPECT_EQ(expect_exact(MeshCollider(image), MeshCollider(point), {turn, shift}), 1U);
    }
}

TEST(MeshContacts, IncludePointsThatCoincideAfterRounding) {
    // Nothing here has a size, only the coordinates are large; and the transform of boxes rounds differently
    // from that of vertices.
    Dice dice(423);
    std::size_t found = 0;
    for (int i = 0; i < repeats(400); ++i) {
        SCOPED_TRACE(i);
        Pose X{support::random_pose(dice, 0.0).rotation, Vec3::Zero()};
        const Eigen::Vector3f from = dice.in_cube(1000.0).cast<float>();
        const Eigen::Vector3f to = (kFar + dice.in_cube(100.0)).cast<float>();
        X.translation = to.cast<double>() - b_vertex_in_a(X, from);
        TriangleMesh point;
        point.positions.assign(3, from);
        point.triangles = {{0, 1, 2}};
        TriangleMesh image = point;
        image.positions.assign(3, to);
        found += expect_exact(MeshCollider(image), MeshCollider(point), X);
    }
    EXPECT_GT(found, at_least(100));
}

TEST(MeshContacts, OfEdgesThatAlmostTouchAgreeWithTheLoop) {
    Dice dice(424);
    std::size_t found = 0;
    std::size_t apart = 0;
    for (int i = 0; i < repeats(3000); ++i) {
        SCOPED_TRACE(i);
        // Two edges through points that lie a few units of float32 apart, each triangle on its own side.
        const Pose X = support::random_pose(dice, 1.0);
        const Vec3 at = dice.in_cube(1.0);
        const Vec3 e = dice.in_cube(1.0);
        const Vec3 f = dice.in_cube(1.0);
        const Vec3 away = e.cross(f).normalized();
        const Vec3 nearly = at + dice.between(-2e-7, 2e-7) * away;
        TriangleMesh one;
        support::add_triangle(one, at - e, at + dice.between(0.2, 1.0) * e, at + away + dice.in_cube(0.5));
        TriangleMesh other;
        support::add_triangle(other, X.inverse_apply(nearly - f), X.inverse_apply(nearly + f),
                              X.inverse_apply(nearly - away + dice.in_cube(0.5)));
        const std::size_t pairs = expect_exact(MeshCollider(one), MeshCollider(other), X);
        found += pairs;
        apart += 1 - pairs;
    }
    EXPECT_GT(found, at_least(500));
    EXPECT_GT(apart, at_least(500));
}

TEST(MeshContacts, AtAnyScaleAgreeWithTheLoop) {
    Dice dice(419);
    for (const double scale : {1e-38, 1e-30, 1e-12, 1e-6, 1e6, 1e10}) {
        SCOPED_TRACE(scale);
        std::size_t found = 0;
        for (int i = 0; i < repeats(20); ++i) {
            TriangleMesh one = support::random_mesh(dice, 60, 3.0);
            TriangleMesh other = support::random_mesh(dice, 60, 3.0);
            for (TriangleMesh* mesh : {&one, &other}) {
                for (auto& p : mesh->positions) {
                    p *= static_cast<float>(scale);
                }
            }
            Pose X = support::random_pose(dice, 1.0);
            X.translation *= scale;
            found += expect_exact(MeshCollider(one), MeshCollider(other), X);
        }
        EXPECT_GT(found, at_least(100));
    }
}

TEST(MeshContacts, AgreeWithTheLoopForAPoseThatIsNearlyARotation) {
    Dice dice(420);
    std::size_t found = 0;
    for (int i = 0; i < repeats(60); ++i) {
        SCOPED_TRACE(i);
        const MeshCollider a(support::ball(12));
        const MeshCollider b(support::random_mesh(dice, 80, 2.0));
        Pose X = support::random_pose(dice, 1.0);
        X.rotation = X.rotation.cast<float>().cast<double>().eval();
        if (dice.chance(0.5)) {
            X.rotation(dice.below(3), dice.below(3)) += dice.between(-4e-4, 4e-4);
        }
        found += expect_exact(a, b, X);
    }
    EXPECT_GT(found, at_least(500));
}

TEST(MeshContacts, AreNoneBetweenSeparateMeshes) {
    Dice dice(421);
    const MeshCollider mesh(support::random_mesh(dice, 20, 3.0));
    EXPECT_EQ(expect_exact(mesh, mesh, {Mat3::Identity(), Vec3(100, 0, 0)}), 0U);
    EXPECT_EQ(expect_exact(mesh, mesh, {Mat3::Identity(), 1e200 * Vec3(1, 1, 1)}), 0U);
    TriangleMesh inner = support::ball(20);
    for (auto& p : inner.positions) {
        p *= 0.95F;
    }
    EXPECT_EQ(expect_exact(MeshCollider(support::ball(20)), MeshCollider(inner), {}), 0U);
}

TEST(MeshContacts, RefuseAnInvalidPose) {
    Dice dice(422);
    const MeshCollider mesh(support::random_mesh(dice, 5, 1.0));
    std::vector<TrianglePair> pairs;
    Pose mirrored;
    mirrored.rotation(0, 0) = -1.0;
    Pose stretched;
    stretched.rotation *= 1.01;
    Pose not_a_number;
    not_a_number.translation.y() = std::numeric_limits<double>::quiet_NaN();
    Pose infinite;
    infinite.translation.x() = std::numeric_limits<double>::infinity();
    for (const Pose& X : {mirrored, stretched, not_a_number, infinite}) {
        EXPECT_THROW(all_contacts(mesh, mesh, X, pairs), std::invalid_argument);
        EXPECT_THROW(first_contact(mesh, mesh, X), std::invalid_argument);
    }
}

TEST(MeshContacts, CountTheirWork) {
    const MeshCollider a(support::ball(26));
    std::vector<TrianglePair> pairs;
    QueryStatistics apart;
    all_contacts(a, a, {Mat3::Identity(), Vec3(2.5, 0, 0)}, pairs, &apart);
    EXPECT_EQ(apart.volume_tests, 1U) << "only the outer spheres";
    EXPECT_EQ(apart.primitive_tests, 0U);
    QueryStatistics all;
    all_contacts(a, a, {Mat3::Identity(), Vec3(1.0, 0.1, 0.2)}, pairs, &all);
    EXPECT_GE(all.primitive_tests, pairs.size());
    EXPECT_LT(all.primitive_tests, 20 * pairs.size()) << "boxes and planes reject most pairs";
    EXPECT_LT(all.volume_tests, a.mesh().triangles.size() * 10);
    QueryStatistics first;
    EXPECT_TRUE(first_contact(a, a, {Mat3::Identity(), Vec3(1.0, 0.1, 0.2)}, &first));
    EXPECT_LT(first.volume_tests, all.volume_tests / 10);
    EXPECT_LE(first.transform_updates, 12U) << "hardly more than one straight descent";
}

}  // namespace
}  // namespace campuswalk::collision

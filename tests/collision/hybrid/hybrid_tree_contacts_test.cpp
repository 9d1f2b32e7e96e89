#include "collision/hybrid/hybrid_tree_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "collision/geometry/triangle_overlap.h"
#include "tests/support/effort.h"
#include "tests/support/mesh_pieces.h"
#include "tests/support/random_scene.h"
#include "tools/campuswalk_bench/engines/node_tests.h"

namespace campuswalk::collision {
namespace {

using support::Dice;
using support::repeats;

/// The paper's node test, and those of the benchmark.
enum class NodeTest { hybrid, box, sphere, mixed };
constexpr std::array kNodeTests = {NodeTest::hybrid, NodeTest::box, NodeTest::sphere, NodeTest::mixed};

void all_contacts(const HybridMesh& a, const HybridMesh& b, const Pose& X_a_b, NodeTest test,
                  std::vector<TrianglePair>& out, HybridContactStatistics& work) {
    switch (test) {
        case NodeTest::hybrid:
            return all_contacts(a, b, X_a_b, out, work);
        case NodeTest::box:
            return all_contacts_by<tools::bench::BoxNodeTest>(a, b, X_a_b, out, work);
        case NodeTest::sphere:
            return all_contacts_by<tools::bench::SphereNodeTest>(a, b, X_a_b, out, work);
        case NodeTest::mixed:
            return all_contacts_by<tools::bench::MixedNodeTest>(a, b, X_a_b, out, work);
    }
}

std::optional<TrianglePair> first_contact(const HybridMesh& a, const HybridMesh& b, const Pose& X_a_b,
                                          NodeTest test, HybridContactStatistics& work) {
    switch (test) {
        case NodeTest::box:
            return first_contact_by<tools::bench::BoxNodeTest>(a, b, X_a_b, work);
        case NodeTest::sphere:
            return first_contact_by<tools::bench::SphereNodeTest>(a, b, X_a_b, work);
        case NodeTest::mixed:
            return first_contact_by<tools::bench::MixedNodeTest>(a, b, X_a_b, work);
        case NodeTest::hybrid:
            break;
    }
    return first_contact(a, b, X_a_b, work);
}

/// A minimum number of contacts, scaled like `repeats`.
std::size_t at_least(int plain) {
    return static_cast<std::size_t>(repeats(plain));
}

struct Body {
    TriangleMesh mesh;
    HybridTree tree;

    explicit Body(TriangleMesh from, std::uint32_t leaf_triangles = HybridTreeSettings{}.leaf_triangles)
        : mesh(std::move(from)), tree(build_hybrid_tree(mesh, {leaf_triangles})) {}
    HybridMesh view() const { return {mesh, tree}; }
};

/// Every triangle against every triangle.
std::vector<TrianglePair> loop_contacts(const TriangleMesh& a, const TriangleMesh& b, const Pose& X_a_b) {
    std::vector<TrianglePair> pairs;
    for (std::uint32_t i = 0; i < a.triangles.size(); ++i) {
        const Triangle first = vertices(a, i);
        for (std::uint32_t j = 0; j < b.triangles.size(); ++j) {
            const auto& v = b.triangles[j];
            const Triangle second{b_vertex_in_a(X_a_b, b.positions[v[0]]),
                                  b_vertex_in_a(X_a_b, b.positions[v[1]]),
                                  b_vertex_in_a(X_a_b, b.positions[v[2]])};
            if (overlap(first, second)) {
                pairs.push_back({i, j});
            }
        }
    }
    return pairs;
}

/// Checks every query with every node test against the loop; returns how many pairs there are.
std::size_t expect_exact(const Body& a, const Body& b, const Pose& X_a_b) {
    const std::vector<TrianglePair> expected = loop_contacts(a.mesh, b.mesh, X_a_b);
    for (const NodeTest test : kNodeTests) {
        SCOPED_TRACE(static_cast<int>(test));
        std::vector<TrianglePair> pairs{{77, 77}};
        HybridContactStatistics counters;
        all_contacts(a.view(), b.view(), X_a_b, test, pairs, counters);
        const auto first = first_contact(a.view(), b.view(), X_a_b, test, counters);
        EXPECT_EQ(first.has_value(), !pairs.empty());
        if (first && !pairs.empty()) {
            EXPECT_EQ(*first, pairs.front());
        }
        std::sort(pairs.begin(), pairs.end());
        EXPECT_EQ(pairs, expected);
    }
    return expected.size();
}

HybridContactStatistics count(const Body& a, const Body& b, const Pose& X_a_b, NodeTest test) {
    HybridContactStatistics counters;
    std::vector<TrianglePair> pairs;
    all_contacts(a.view(), b.view(), X_a_b, test, pairs, counters);
    return counters;
}

/// Triangles with integer coordinates: they touch at vertices, along edges and in planes; some have no area.
TriangleMesh lattice_soup(Dice& dice, int triangles, const Vec3& at) {
    const auto vertex = [&] {
        const double x = dice.below(7);
        const double y = dice.below(7);
        return Vec3(at + Vec3(x, y, dice.below(7)));
    };
    TriangleMesh mesh;
    for (int i = 0; i < triangles; ++i) {
        const Vec3 p = vertex();
        const Vec3 q = vertex();
        support::add_triangle(mesh, p, q, dice.chance(0.1) ? q : vertex());
    }
    return mesh;
}

/// One of the rotations that map the axes onto each other.
Mat3 lattice_turn(Dice& dice) {
    Mat3 turn = Mat3::Zero();
    const int first = dice.below(3);
    const int second = (first + 1 + dice.below(2)) % 3;
    turn(0, first) = dice.chance(0.5) ? 1.0 : -1.0;
    turn(1, second) = dice.chance(0.5) ? 1.0 : -1.0;
    turn.row(2) = turn.row(0).cross(turn.row(1));
    return turn;
}

/// A sphere of radius 1 in 2 n (n - 1) triangles.
TriangleMesh ball(int n) {
    const auto at = [&](int i, int j) {
        const double up = std::numbers::pi * i / n;
        const double around = 2.0 * std::numbers::pi * (j % n) / n;
        return Vec3(std::sin(up) * std::cos(around), std::cos(up), std::sin(up) * std::sin(around));
    };
    TriangleMesh mesh;
    for (int j = 0; j < n; ++j) {
        support::add_triangle(mesh, at(0, j), at(1, j), at(1, j + 1));
        for (int i = 1; i + 1 < n; ++i) {
            support::add_quad(mesh, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
        }
        support::add_triangle(mesh, at(n - 1, j), at(n, j), at(n - 1, j + 1));
    }
    return mesh;
}

TEST(HybridContacts, AgreeWithALoopOverAllPairs) {
    Dice dice(310);
    std::size_t found = 0;
    for (int i = 0; i < repeats(150); ++i) {
        SCOPED_TRACE(i);
        const auto leaf = static_cast<std::uint32_t>(1 + dice.below(5));
        const Body a(support::random_mesh(dice, 1 + dice.below(120), dice.between(0.5, 4.0)), leaf);
        const Body b(support::random_mesh(dice, 1 + dice.below(120), dice.between(0.5, 4.0)), leaf);
        found += expect_exact(a, b, support::random_pose(dice, 3.0));
    }
    EXPECT_GT(found, at_least(1000));
}

TEST(HybridContacts, OfSmoothSurfacesAgreeWithTheLoop) {
    Dice dice(311);
    const Body a(ball(24));
    const Body b(ball(17));
    for (int i = 0; i < repeats(6); ++i) {
        SCOPED_TRACE(i);
        Pose X = support::random_pose(dice, 1.0);
        EXPECT_GT(expect_exact(a, b, X), 0U);
        X.translation = X.translation.normalized() * 1.99;
        expect_exact(a, b, X);
    }
}

TEST(HybridContacts, OnALatticeAgreeWithTheLoop) {
    Dice dice(312);
    std::size_t found = 0;
    for (int i = 0; i < repeats(120); ++i) {
        SCOPED_TRACE(i);
        const Body a(lattice_soup(dice, 60, Vec3::Zero()));
        const Body b(lattice_soup(dice, 60, Vec3::Zero()));
        const Mat3 turn = lattice_turn(dice);
        const Vec3 middle(3, 3, 3);
        const Vec3 shift(dice.below(9) - 4, dice.below(9) - 4, dice.below(9) - 4);
        found += expect_exact(a, b, {turn, middle - turn * middle + shift});
    }
    EXPECT_GT(found, at_least(10000));
}

TEST(HybridContacts, OfAMeshWithItselfIncludeEveryTriangle) {
    Dice dice(313);
    for (int i = 0; i < repeats(20); ++i) {
        const TriangleMesh mesh = support::random_mesh(dice, 80, 2.0);
        const Body a(mesh);
        EXPECT_GE(expect_exact(a, a, {}), mesh.triangles.size());
        const Body other(mesh, 5);  // the same triangles in another tree
        EXPECT_GE(expect_exact(a, other, {}), mesh.triangles.size());
    }
}

TEST(HybridContacts, OfCoplanarFloorsVanishWithTheSmallestGap) {
    TriangleMesh coarse;
    TriangleMesh fine;
    support::add_floor(coarse, 4.0, 0.0, 1.0);
    support::add_floor(fine, 4.0, 0.0, 0.5);
    const Body a(coarse);
    const Body b(fine);
    EXPECT_GT(expect_exact(a, b, {}), fine.triangles.size());
    EXPECT_GT(expect_exact(a, b, {Mat3::Identity(), Vec3(0.3, 0.0, -0.7)}), 0U);
    const auto beside = [&](double x, double z) {
        return expect_exact(a, b, {Mat3::Identity(), Vec3(x, 0.0, z)});
    };
    EXPECT_EQ(beside(8.0, 0.0), 30U + 38U + 7U) << "edges on edges, vertices on edges, vertices on vertices";
    EXPECT_EQ(beside(8.0, 8.0), 1U) << "vertex to vertex";
    EXPECT_EQ(beside(std::nextafter(8.0, 9.0), 0.0), 0U);
    for (const double gap : {1e-9, -1e-9, 5e-324}) {
        EXPECT_EQ(expect_exact(a, b, {Mat3::Identity(), Vec3(0.0, gap, 0.0)}), 0U);
    }
}

/// Needles of a metre to ten kilometres, as thin as float32 allows, crossing or nearly parallel.
TriangleMesh needles(Dice& dice, int count) {
    TriangleMesh mesh;
    const Vec3 common = dice.in_cube(1.0).normalized();
    for (int i = 0; i < count; ++i) {
        const Vec3 direction = dice.chance(0.5) ? common : Vec3(dice.in_cube(1.0));
        const Vec3 along = std::pow(10.0, dice.between(0.0, 4.0)) * direction;
        const Vec3 at = dice.in_cube(1.0) - dice.between(0.0, 1.0) * along;
        const double width = dice.chance(0.3) ? 0.0 : std::pow(10.0, dice.between(-7.0, -1.0));
        support::add_triangle(mesh, at, at + along, at + dice.in_cube(width));
    }
    return mesh;
}

TEST(HybridContacts, OfNeedlesAgreeWithTheLoop) {
    Dice dice(314);
    std::size_t found = 0;
    for (int i = 0; i < repeats(50); ++i) {
        SCOPED_TRACE(i);
        const TriangleMesh mesh = needles(dice, 40);
        const Body a(mesh);
        const Body b(dice.chance(0.5) ? mesh : needles(dice, 40));
        const Pose still;
        found += expect_exact(a, b, dice.chance(0.5) ? still : support::random_pose(dice, 0.01));
    }
    EXPECT_GT(found, at_least(300));
}

TEST(HybridContacts, OfTrianglesWithoutAreaAgreeWithTheLoop) {
    Dice dice(315);
    std::size_t found = 0;
    for (int i = 0; i < repeats(25); ++i) {
        SCOPED_TRACE(i);
        TriangleMesh flat = lattice_soup(dice, 50, Vec3::Zero());
        for (auto& t : flat.triangles) {
            t[2] = dice.chance(0.5) ? t[0] : t[1];
            t[1] = dice.chance(0.3) ? t[0] : t[1];
        }
        const Body a(flat);
        found += expect_exact(a, Body(lattice_soup(dice, 50, Vec3::Zero())), {});
        found += expect_exact(a, a, {});
    }
    EXPECT_GT(found, at_least(1000));
}

/// How far UTM coordinates are from their origin, metres; float32 has steps of 3 cm there.
const Vec3 kFar(450000.0, 60.0, -448000.0);

TEST(HybridContacts, FarFromAnOriginAgreeWithTheLoop) {
    Dice dice(316);
    std::size_t found = 0;
    for (int i = 0; i < repeats(60); ++i) {
        SCOPED_TRACE(i);
        const Body near(dice.chance(0.5) ? lattice_soup(dice, 60, Vec3::Zero())
                                         : support::random_mesh(dice, 60, 4.0));
        const Body far(lattice_soup(dice, 60, kFar));
        const Mat3 turn = dice.chance(0.3) ? lattice_turn(dice) : support::random_pose(dice, 0.0).rotation;
        found += expect_exact(far, near, {turn, kFar + dice.in_cube(2.0)});
        found += expect_exact(near, far, {turn, dice.in_cube(2.0) - turn * kFar});
        found += expect_exact(far, far, {turn, kFar - turn * kFar});
    }
    EXPECT_GT(found, at_least(1000));
}

TEST(HybridContacts, IncludeTouchingTrianglesFarFromAnOriginDespiteRounding) {
    // The transform rounds b's vertices to steps of 6e-11 m, differently in every node: what touches after
    // that must not be lost to bounds that were rounded differently.
    Dice dice(317);
    std::size_t found = 0;
    for (int i = 0; i < repeats(300); ++i) {
        SCOPED_TRACE(i);
        const Mat3 turn = support::random_pose(dice, 0.0).rotation;
        const Pose X{turn, kFar + dice.in_cube(100.0)};
        const Body b(support::random_mesh(dice, 20, 2.0));
        TriangleMesh touching;  // each has a vertex at a vertex of b, as far as float32 allows
        for (const auto& p : b.mesh.positions) {
            const Vec3 at = b_vertex_in_a(X, p);
            support::add_triangle(touching, at, at + dice.in_cube(1.0), at + dice.in_cube(1.0));
        }
        found += expect_exact(Body(touching), b, X);
    }
    EXPECT_GT(found, at_least(1000));
}

TEST(HybridContacts, AgreeWithTheLoopForAPoseThatIsNoRotation) {
    Dice dice(318);
    std::size_t found = 0;
    for (int i = 0; i < repeats(60); ++i) {
        SCOPED_TRACE(i);
        const Body a(support::random_mesh(dice, 80, 2.0));
        const Body b(support::random_mesh(dice, 80, 2.0));
        Pose X = support::random_pose(dice, 1.0);
        switch (dice.below(4)) {
            case 0:  // of float32's precision
                X.rotation = X.rotation.cast<float>().cast<double>().eval();
                break;
            case 1:  // mirrored
                X.rotation.col(dice.below(3)) *= -1.0;
                break;
            case 2:  // stretched
                X.rotation.col(dice.below(3)) *= 2.5;
                break;
            default:  // flattened
                X.rotation.col(dice.below(3)).setZero();
        }
        found += expect_exact(a, b, X);
    }
    EXPECT_GT(found, at_least(1000));
}

TEST(HybridContacts, AreNoneForSeparateOrEmptyMeshes) {
    Dice dice(319);
    const Body mesh(support::random_mesh(dice, 20, 3.0));
    const Body nothing(TriangleMesh{});
    EXPECT_EQ(expect_exact(mesh, mesh, {Mat3::Identity(), Vec3(100, 0, 0)}), 0U);
    EXPECT_EQ(expect_exact(mesh, mesh, {Mat3::Identity(), 1e200 * Vec3(1, 1, 1)}), 0U);
    EXPECT_EQ(expect_exact(mesh, nothing, {}), 0U);
    EXPECT_EQ(expect_exact(nothing, mesh, {}), 0U);
    EXPECT_EQ(expect_exact(nothing, nothing, {}), 0U);
}

TEST(HybridContacts, AreNoneBetweenNestedSurfaces) {
    TriangleMesh inner = ball(16);
    for (auto& p : inner.positions) {
        p *= 0.9F;
    }
    EXPECT_EQ(expect_exact(Body(ball(16)), Body(inner), {}), 0U);
}

TEST(HybridContacts, ComeInTheSameOrderEachTime) {
    Dice dice(320);
    const Body a(support::random_mesh(dice, 200, 2.0));
    const Body b(support::random_mesh(dice, 200, 2.0));
    const Pose X = support::random_pose(dice, 1.0);
    HybridContactStatistics counters;
    std::vector<TrianglePair> one;
    std::vector<TrianglePair> two;
    all_contacts(a.view(), b.view(), X, NodeTest::hybrid, one, counters);
    all_contacts(Body(a.mesh).view(), Body(b.mesh).view(), X, NodeTest::hybrid, two, counters);
    EXPECT_FALSE(one.empty());
    EXPECT_EQ(one, two);
}

TEST(HybridContactStatistics, FarAwayOnlyTheRootsAreTested) {
    const Body a(ball(8));
    for (const NodeTest test : kNodeTests) {
        const HybridContactStatistics c = count(a, a, {Mat3::Identity(), Vec3(9, 0, 0)}, test);
        EXPECT_EQ(c.volume_tests, 1U);
        EXPECT_EQ(c.transform_updates, 1U) << "a move costs one node's transform";
        EXPECT_EQ(c.primitive_tests, 0U);
        EXPECT_EQ(c.outer, test == NodeTest::box ? 0U : 1U);
        EXPECT_EQ(c.outer + c.inner + c.box, 1U);
    }
}

TEST(HybridContactStatistics, CountEveryOverlappingPairAsDescendedOrTested) {
    Dice dice(321);
    for (int i = 0; i < repeats(20); ++i) {
        const Body a(support::random_mesh(dice, 150, 2.0), 1);
        const Body b(support::random_mesh(dice, 150, 2.0), 1);
        const Pose X = support::random_pose(dice, 2.0);
        for (const NodeTest test : kNodeTests) {
            const HybridContactStatistics c = count(a, b, X, test);
            const std::uint64_t overlapping = c.volume_tests - c.outer - c.inner - c.box;
            // With one triangle per leaf, primitive_tests counts the overlapping pairs of leaves. Every other
            // overlapping pair has two children that are tested.
            EXPECT_EQ(c.volume_tests, 1 + 2 * (overlapping - c.primitive_tests));
            EXPECT_LE(c.transform_updates, c.volume_tests);
            EXPECT_EQ(c.transform_updates % 2, 1U) << "the root and both children of some nodes of b";
        }
    }
}

TEST(HybridContactStatistics, AreLowerWithMoreLayers) {
    Dice dice(322);
    HybridContactStatistics all;
    for (int i = 0; i < repeats(20); ++i) {
        const Body a(support::random_mesh(dice, 150, 2.0));
        const Body b(support::random_mesh(dice, 150, 2.0));
        const Pose X = support::random_pose(dice, 2.0);
        const HybridContactStatistics hybrid = count(a, b, X, NodeTest::hybrid);
        const HybridContactStatistics box = count(a, b, X, NodeTest::box);
        const HybridContactStatistics mixed = count(a, b, X, NodeTest::mixed);
        const HybridContactStatistics sphere = count(a, b, X, NodeTest::sphere);
        EXPECT_LE(hybrid.volume_tests, box.volume_tests);
        EXPECT_LE(hybrid.volume_tests, mixed.volume_tests);
        EXPECT_LE(mixed.volume_tests, sphere.volume_tests);
        EXPECT_LE(hybrid.primitive_tests, box.primitive_tests);
        EXPECT_LE(mixed.primitive_tests, sphere.primitive_tests);
        EXPECT_EQ(box.outer + box.inner, 0U);
        EXPECT_EQ(sphere.inner + sphere.box, 0U);
        EXPECT_EQ(mixed.box, 0U);
        all += hybrid;
        all.outer += hybrid.outer;
        all.inner += hybrid.inner;
        all.box += hybrid.box;
    }
    EXPECT_GT(all.outer, 0U);
    EXPECT_GT(all.inner, 0U);
    EXPECT_GT(all.box, 0U);
    EXPECT_LT(all.outer + all.inner + all.box, all.volume_tests);
}

TEST(HybridContactStatistics, AccumulateAndStopAtTheFirstContact) {
    const Body a(ball(20));
    const Pose X{Mat3::Identity(), Vec3(1, 0, 0)};
    const HybridContactStatistics once = count(a, a, X, NodeTest::hybrid);
    HybridContactStatistics twice;
    std::vector<TrianglePair> pairs;
    all_contacts(a.view(), a.view(), X, NodeTest::hybrid, pairs, twice);
    all_contacts(a.view(), a.view(), X, NodeTest::hybrid, pairs, twice);
    EXPECT_EQ(twice.volume_tests, 2 * once.volume_tests);
    EXPECT_EQ(twice.primitive_tests, 2 * once.primitive_tests);
    EXPECT_EQ(twice.transform_updates, 2 * once.transform_updates);
    EXPECT_EQ(twice.outer, 2 * once.outer);
    EXPECT_EQ(twice.inner, 2 * once.inner);
    EXPECT_EQ(twice.box, 2 * once.box);
    HybridContactStatistics first;
    EXPECT_TRUE(first_contact(a.view(), a.view(), X, NodeTest::hybrid, first));
    EXPECT_LT(5 * first.volume_tests, once.volume_tests);
    EXPECT_LT(5 * first.primitive_tests, once.primitive_tests);
}

}  // namespace
}  // namespace campuswalk::collision

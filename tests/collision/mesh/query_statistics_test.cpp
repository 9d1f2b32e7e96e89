#include "collision/base/query_statistics.h"

#include <vector>

#include <gtest/gtest.h>

#include "collision/geometry/closest.h"
#include "collision/mesh/mesh_query.h"
#include "tests/support/mesh_pieces.h"
#include "tests/support/random_scene.h"

namespace campuswalk::collision {
namespace {

using support::Dice;

TriangleMesh tiled_floor() {
    TriangleMesh mesh;
    support::add_floor(mesh, 16.0, 0.0, 0.5);
    return mesh;
}

QueryStatistics count_near(const MeshCollider& mesh, const Segment& segment, double radius) {
    QueryStatistics counters;
    std::vector<std::uint32_t> near;
    triangles_near(mesh, segment, radius, near, &counters);
    return counters;
}

/// The nodes that a query must test: the root and both children of every node that has a triangle in reach;
/// and those it would test by the outer spheres alone.
struct NodeCounts {
    std::uint64_t needed = 0;
    std::uint64_t by_spheres_alone = 0;
    std::uint64_t triangles_needed = 0;
};

class NodeCounter {
public:
    NodeCounter(const MeshCollider& mesh, const Segment& segment, double radius)
        : mesh_(mesh), segment_(segment), radius_(radius) {}

    NodeCounts count() {
        ++counts_.needed;
        count_needed(0);
        count_by_spheres(0);
        return counts_;
    }

private:
    bool in_reach(std::uint32_t triangle) const {
        return closest(segment_, vertices(mesh_.mesh(), triangle)).distance <= radius_;
    }

    bool count_needed(std::uint32_t index) {
        const HybridNode& node = mesh_.hybrid_tree().nodes[index];
        bool reached = false;
        if (node.is_leaf()) {
            for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
                reached = in_reach(mesh_.hybrid_tree().order[i]) || reached;
            }
            counts_.triangles_needed += reached ? node.count : 0;
            return reached;
        }
        const bool left = count_needed(node.first);
        const bool right = count_needed(node.first + 1);
        counts_.needed += left || right ? 2 : 0;
        return left || right;
    }

    void count_by_spheres(std::uint32_t index) {
        const HybridNode& node = mesh_.hybrid_tree().nodes[index];
        ++counts_.by_spheres_alone;
        const Vec3 middle = 0.5 * (segment_.a + segment_.b);
        const double reach = 0.5 * (segment_.b - segment_.a).norm() + radius_ + node.outer.radius;
        if (!node.is_leaf() && (middle - node.outer.center).norm() <= reach + 1e-12) {
            count_by_spheres(node.first);
            count_by_spheres(node.first + 1);
        }
    }

    const MeshCollider& mesh_;
    Segment segment_;
    double radius_;
    NodeCounts counts_;
};

TEST(QueryStatistics, AddUp) {
    QueryStatistics sum{1, 2, 3};
    sum += {10, 20, 30};
    EXPECT_EQ(sum.volume_tests, 11U);
    EXPECT_EQ(sum.primitive_tests, 22U);
    EXPECT_EQ(sum.transform_updates, 33U);
}

TEST(QueryStatistics, FarAwayOnlyTheRootIsTested) {
    for (const TreeKind tree_kind : {TreeKind::bvh8, TreeKind::hybrid}) {
        const MeshCollider mesh(tiled_floor(), tree_kind);
        const QueryStatistics counters = count_near(mesh, {{900, 0, 0}, {900, 2, 0}}, 0.3);
        EXPECT_EQ(counters.volume_tests, 1U);
        EXPECT_EQ(counters.primitive_tests, 0U);
        EXPECT_EQ(counters.transform_updates, 1U);
    }
}

TEST(QueryStatistics, WithEverythingInReachEveryNodeAndTriangleIsTested) {
    const MeshCollider hybrid(tiled_floor(), TreeKind::hybrid);
    const QueryStatistics of_hybrid = count_near(hybrid, {{0, 0, 0}, {0, 2, 0}}, 500.0);
    EXPECT_EQ(of_hybrid.volume_tests, hybrid.hybrid_tree().nodes.size());
    EXPECT_EQ(of_hybrid.primitive_tests, hybrid.mesh().triangles.size());
    EXPECT_EQ(of_hybrid.transform_updates, 1U);

    const MeshCollider bvh8(tiled_floor());
    std::size_t boxes = 1;  // the outer sphere
    for (const Bvh8Node& node : bvh8.bvh8().nodes) {
        boxes += node.count;
    }
    const QueryStatistics of_bvh8 = count_near(bvh8, {{0, 0, 0}, {0, 2, 0}}, 500.0);
    EXPECT_EQ(of_bvh8.volume_tests, boxes);
    EXPECT_EQ(of_bvh8.primitive_tests, bvh8.mesh().triangles.size());
    EXPECT_EQ(of_bvh8.transform_updates, 1U);
}

TEST(QueryStatistics, LieBetweenTheNecessaryTestsAndThoseOfSpheresAlone) {
    Dice dice(50);
    std::uint64_t tested = 0;
    std::uint64_t by_spheres = 0;
    for (int m = 0; m < 10; ++m) {
        const MeshCollider mesh(m % 2 == 0 ? support::random_mesh(dice, 400, 6.0) : tiled_floor(),
                                TreeKind::hybrid);
        for (int i = 0; i < 20; ++i) {
            const Vec3 a = dice.in_cube(6.0);
            const Segment segment{a, a + Vec3(0, 1.2, 0)};
            const QueryStatistics counters = count_near(mesh, segment, 0.4);
            const NodeCounts counts = NodeCounter(mesh, segment, 0.4).count();
            ASSERT_GE(counters.volume_tests, counts.needed);
            ASSERT_LE(counters.volume_tests, counts.by_spheres_alone);
            ASSERT_GE(counters.primitive_tests, counts.triangles_needed);
            ASSERT_EQ(counters.transform_updates, 1U);
            tested += counters.volume_tests;
            by_spheres += counts.by_spheres_alone;
        }
    }
    EXPECT_LT(tested, by_spheres) << "the inner layer rejects nodes that the spheres accept";
}

TEST(QueryStatistics, OfASmallQueryInALargeMeshStaySmall) {
    for (const TreeKind tree_kind : {TreeKind::bvh8, TreeKind::hybrid}) {
        const MeshCollider mesh(tiled_floor(), tree_kind);  // 8192 triangles
        const QueryStatistics counters = count_near(mesh, {{3.3, 0.2, 4.1}, {3.3, 1.5, 4.1}}, 0.3);
        EXPECT_LT(counters.volume_tests, 200U);
        EXPECT_LT(counters.primitive_tests, 100U);
        EXPECT_GT(counters.primitive_tests, 0U);
    }
}

TEST(QueryStatistics, OfARayThatMissesStaySmall) {
    for (const TreeKind tree_kind : {TreeKind::bvh8, TreeKind::hybrid}) {
        const MeshCollider mesh(tiled_floor(), tree_kind);
        QueryStatistics counters;
        EXPECT_FALSE(first_on_ray(mesh, {{3, 0.01, 3}, {4, 5.0, 3}}, &counters));
        EXPECT_LT(counters.volume_tests, 200U);
        EXPECT_EQ(counters.transform_updates, 1U);
    }
}

}  // namespace
}  // namespace campuswalk::collision

#include "collision/hybrid/hybrid_tree.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/collision/hybrid/paper_volumes.h"
#include "tests/support/mesh_pieces.h"
#include "tests/support/random_scene.h"

namespace campuswalk::collision {
namespace {

/// The part of HybridTree::order under each node, by walking down from the root.
struct Subtree {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    int depth = 0;
};

class TreeCheck {
public:
    TreeCheck(const TriangleMesh& mesh, const HybridTree& tree) : mesh_(mesh), tree_(tree) {}

    void run(std::uint32_t leaf_triangles) {
        const Subtree whole = check(0, leaf_triangles, 0);
        EXPECT_EQ(whole.begin, 0U);
        EXPECT_EQ(whole.end, mesh_.triangles.size());
        EXPECT_EQ(visited_, tree_.nodes.size()) << "every node is reached from the root once";
        std::vector<std::uint32_t> order = tree_.order;
        std::sort(order.begin(), order.end());
        for (std::size_t i = 0; i < order.size(); ++i) {
            ASSERT_EQ(order[i], i) << "every triangle is in one leaf";
        }
        // The builder guarantees at most 15/16 of the triangles on the next level.
        const double levels = std::log(static_cast<double>(mesh_.triangles.size())) / std::log(16.0 / 15.0);
        EXPECT_LE(whole.depth, levels + 2.0);
    }

private:
    Subtree check(std::uint32_t index, std::uint32_t leaf_triangles, int depth) {
        const HybridNode& node = tree_.nodes[index];
        ++visited_;
        Subtree here{node.first, node.first + node.count, depth};
        if (node.is_leaf()) {
            EXPECT_LE(node.count, leaf_triangles);
        } else {
            const Subtree left = check(node.first, leaf_triangles, depth + 1);
            const Subtree right = check(node.first + 1, leaf_triangles, depth + 1);
            EXPECT_EQ(left.end, right.begin) << "the children's triangles lie side by side";
            EXPECT_GT(right.end - left.begin, leaf_triangles) << "nothing is split needlessly";
            here = {left.begin, right.end, std::max(left.depth, right.depth)};
        }
        EXPECT_LT(here.begin, here.end);
        const Triangles triangles = Triangles(tree_.order).subspan(here.begin, here.end - here.begin);
        EXPECT_TRUE(is_outer_sphere(node.outer, mesh_, triangles)) << "node " << index;
        EXPECT_TRUE(is_inner_box(node.inner, mesh_, triangles)) << "node " << index;
        return here;
    }

    const TriangleMesh& mesh_;
    const HybridTree& tree_;
    std::size_t visited_ = 0;
};

void expect_well_built(const TriangleMesh& mesh) {
    for (const std::uint32_t leaf_triangles : {1U, 4U, 9U}) {
        SCOPED_TRACE(leaf_triangles);
        const HybridTree tree = build_hybrid_tree(mesh, {leaf_triangles});
        TreeCheck(mesh, tree).run(leaf_triangles);
    }
}

TEST(HybridTree, FollowsThePaperAtEveryNode) {
    support::Dice dice(15);
    for (int i = 0; i < 20; ++i) {
        SCOPED_TRACE(i);
        expect_well_built(support::random_mesh(dice, 1 + dice.below(300), dice.between(0.5, 20.0)));
    }
}

TEST(HybridTree, FollowsThePaperOnRegularMeshes) {
    TriangleMesh floor;
    support::add_floor(floor, 10.0, 0.0, 1.0);
    expect_well_built(floor);
    TriangleMesh stairs;
    support::add_stairs(stairs, 1000.0, -2000.0, 2.0, 0.17, 0.3, 40);
    expect_well_built(stairs);
}

TEST(HybridTree, HalvesCoincidentTrianglesByCount) {
    TriangleMesh mesh;
    for (int i = 0; i < 100; ++i) {
        support::add_triangle(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    }
    expect_well_built(mesh);
}

TEST(HybridTree, StaysShallowWhereSizesGrowGeometrically) {
    // Each triangle is twice as far out: splitting at the mean alone would split off one at a time.
    TriangleMesh mesh;
    for (int i = 0; i < 100; ++i) {
        const double at = std::ldexp(1.0, i - 50);
        support::add_triangle(mesh, {at, 0, 0}, {1.5 * at, 0, 0}, {at, at, 0});
    }
    expect_well_built(mesh);
}

TEST(HybridTree, OfAnEmptyMeshIsEmpty) {
    const HybridTree tree = build_hybrid_tree(TriangleMesh{});
    EXPECT_TRUE(tree.nodes.empty());
    EXPECT_TRUE(tree.order.empty());
}

TEST(HybridTree, IsDeterministic) {
    support::Dice dice(16);
    const TriangleMesh mesh = support::random_mesh(dice, 500, 5.0);
    const HybridTree one = build_hybrid_tree(mesh);
    const HybridTree two = build_hybrid_tree(mesh);
    EXPECT_EQ(one.order, two.order);
    ASSERT_EQ(one.nodes.size(), two.nodes.size());
    for (std::size_t i = 0; i < one.nodes.size(); ++i) {
        EXPECT_EQ(one.nodes[i].inner.axes, two.nodes[i].inner.axes);
        EXPECT_EQ(one.nodes[i].outer.radius, two.nodes[i].outer.radius);
    }
}

}  // namespace
}  // namespace campuswalk::collision

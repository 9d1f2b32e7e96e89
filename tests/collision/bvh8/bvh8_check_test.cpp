#include "collision/bvh8/bvh8_check.h"

#include <functional>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/random_scene.h"

namespace campuswalk::collision {
namespace {

constexpr std::size_t kTriangles = 2000;

TriangleMesh mesh_of_many_triangles() {
    support::Dice dice(7);
    TriangleMesh mesh;
    for (std::uint32_t t = 0; t < kTriangles; ++t) {
        const Vec3 place = dice.in_cube(50.0);
        for (int c = 0; c < 3; ++c) {
            mesh.positions.push_back((place + dice.in_cube(1.0)).cast<float>());
        }
        mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    return mesh;
}

class Bvh8Check : public testing::Test {
protected:
    /// What is wrong with the tree after `damage`; empty if nothing is found.
    std::string fault(const std::function<void(Bvh8&)>& damage) const {
        Bvh8 tree = tree_;
        damage(tree);
        const char* found = fault_of(tree, kTriangles);
        return found == nullptr ? "" : found;
    }
    /// The first node whose first child is a leaf.
    std::size_t node_above_leaf() const {
        std::size_t n = 0;
        while ((tree_.nodes[n].leaves & 1) == 0) {
            ++n;
        }
        return n;
    }

    const Bvh8 tree_ = build_bvh8(mesh_of_many_triangles());
};

TEST_F(Bvh8Check, AcceptsATreeAsItWasBuilt) {
    EXPECT_EQ(fault([](Bvh8&) {}), "");
    TriangleMesh one;
    one.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    one.triangles = {{0, 1, 2}};
    EXPECT_EQ(fault_of(build_bvh8(one), 1), nullptr);
}

TEST_F(Bvh8Check, RejectsNodesThatFormNoTree) {
    ASSERT_EQ(tree_.nodes[0].leaves & 1, 0);
    const std::size_t low = node_above_leaf();
    const auto last_node = static_cast<std::uint32_t>(tree_.nodes.size());
    const auto last_leaf = static_cast<std::uint32_t>(tree_.leaves.size());
    const std::string no_tree = fault([](Bvh8& t) { t.nodes[0].count = 0; });
    EXPECT_NE(no_tree, "");
    const std::string no_root = fault([](Bvh8& t) { t.nodes.clear(); });
    EXPECT_NE(no_root, "");
    EXPECT_NE(no_root, no_tree);
    EXPECT_EQ(fault([](Bvh8& t) { t.nodes[0].child[0] = 0; }), no_tree) << "a circle";
    EXPECT_EQ(fault([&](Bvh8& t) { t.nodes[0].child[0] = last_node; }), no_tree);
    EXPECT_EQ(fault([](Bvh8& t) { t.nodes[0].child[0] = t.nodes[0].child[1]; }), no_tree) << "two parents";
    EXPECT_EQ(fault([&](Bvh8& t) { t.nodes[low].child[0] = last_leaf; }), no_tree);
    EXPECT_EQ(fault([](Bvh8& t) { t.nodes[0].count = 9; }), no_tree);
    EXPECT_EQ(fault([](Bvh8& t) { t.nodes[0].leaves ^= 1; }), no_tree);
    EXPECT_EQ(fault([](Bvh8& t) { t.nodes.emplace_back().count = 1; }), no_tree) << "in no tree";
    EXPECT_EQ(fault([](Bvh8& t) { t.leaves.push_back(t.leaves[0]); }), no_tree) << "in no tree";
    EXPECT_EQ(fault([](Bvh8& t) {
                  t.nodes[1].count = 1;
                  t.nodes[1].leaves |= 2;
              }),
              no_tree)
        << "a leaf that is no child";
}

/// Traversal stacks have room for 64 levels.
TEST_F(Bvh8Check, RejectsATreeThatIsTooDeep) {
    const auto chain = [&](std::uint32_t levels) {
        Bvh8 tree;
        tree.leaves = {tree_.leaves[0]};
        for (std::uint32_t n = 0; n < levels; ++n) {
            Bvh8Node& node = tree.nodes.emplace_back();
            node.count = 1;
            node.child[0] = n + 1;
        }
        tree.nodes.back().child[0] = 0;
        tree.nodes.back().leaves = 1;
        return tree;
    };
    EXPECT_EQ(fault_of(chain(65), kTriangles), nullptr);
    EXPECT_NE(fault_of(chain(66), kTriangles), nullptr);
}

TEST_F(Bvh8Check, RejectsLeavesThatReferToNothingInTheMesh) {
    const std::string foreign = fault([](Bvh8& t) { t.leaves[3].triangle[0] = kTriangles; });
    EXPECT_NE(foreign, "");
    EXPECT_EQ(fault([](Bvh8& t) { t.leaves[3].triangle[15] = kTriangles; }), foreign) << "an unused slot";
    EXPECT_EQ(fault([](Bvh8& t) { t.leaves[3].vertex_of[1][15] = 16; }), foreign);
    EXPECT_EQ(fault([](Bvh8& t) { t.leaves[3].vertex_count = 17; }), foreign);
    EXPECT_EQ(fault([](Bvh8& t) { t.leaves[3].triangle_count = 17; }), foreign);
    EXPECT_EQ(fault([](Bvh8& t) { t.leaves[3].triangle_count = 0; }), foreign);
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(fault([](Bvh8& t) { t.leaves[3].vertex[2][15] = kNan; }), foreign);
    EXPECT_EQ(fault([](Bvh8& t) { t.leaves[3].origin[0] = -std::numeric_limits<float>::infinity(); }),
              foreign);
    const std::string not_finite = fault([](Bvh8& t) { t.reach = kNan; });
    EXPECT_NE(not_finite, "");
    EXPECT_NE(not_finite, foreign);
    EXPECT_EQ(fault([](Bvh8& t) { t.outer.radius = kNan; }), not_finite);
}

}  // namespace
}  // namespace campuswalk::collision

#include "collision/bvh8/bvh8_check.h"

#include <functional>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/random_scene.h"

namespace campuswalk::collision {
namespace {

constexpr std::size_t kTriangles = 2000;

TriangleMesh mesh_of_many() {
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
    /// Of the tree as `spoil` leaves it; empty if it is found to be whole.
    std::string fault(const std::function<void(Bvh8&)>& spoil) const {
        Bvh8 tree = tree_;
        spoil(tree);
        const char* found = fault_of(tree, kTriangles);
        return found == nullptr ? "" : found;
    }
    /// A node whose first child is a leaf, and one whose first child isn't.
    std::size_t node_above_leaf() const {
        std::size_t n = 0;
        while ((tree_.nodes[n].leaves & 1) == 0) {
            ++n;
        }
        return n;
    }

    const Bvh8 tree_ = build_bvh8(mesh_of_many());
};

TEST_F(Bvh8Check, FindsNothingWrongWithWhatWasBuilt) {
    EXPECT_EQ(fault([](Bvh8&) {}), "");
    TriangleMesh one;
    one.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    one.triangles = {{0, 1, 2}};
    EXPECT_EQ(fault_of(build_bvh8(one), 1), nullptr);
}

TEST_F(Bvh8Check, FindsNodesThatMakeNoTree) {
    ASSERT_EQ(tree_.nodes[0].leaves & 1, 0);
    const std::size_t low = node_above_leaf();
    const auto last_node = static_cast<std::uint32_t>(tree_.nodes.size());
    const auto last_leaf = static_cast<std::uint32_t>(tree_.leaves.size());
    const std::string kNoTree = "the tree's nodes don't make a tree";
    EXPECT_EQ(fault([](Bvh8& t) { t.nodes.clear(); }), "the tree has no root");
    EXPECT_EQ(fault([](Bvh8& t) { t.nodes[0].child[0] = 0; }), kNoTree) << "a circle";
    EXPECT_EQ(fault([&](Bvh8& t) { t.nodes[0].child[0] = last_node; }), kNoTree);
    EXPECT_EQ(fault([](Bvh8& t) { t.nodes[0].child[0] = t.nodes[0].child[1]; }), kNoTree) << "two parents";
    EXPECT_EQ(fault([&](Bvh8& t) { t.nodes[low].child[0] = last_leaf; }), kNoTree);
    EXPECT_EQ(fault([](Bvh8& t) { t.nodes[0].count = 0; }), kNoTree);
    EXPECT_EQ(fault([](Bvh8& t) { t.nodes[0].count = 9; }), kNoTree);
    EXPECT_EQ(fault([](Bvh8& t) { t.nodes[0].leaves ^= 1; }), kNoTree);
    EXPECT_EQ(fault([](Bvh8& t) { t.nodes.emplace_back().count = 1; }), kNoTree) << "in no tree";
    EXPECT_EQ(fault([](Bvh8& t) { t.leaves.push_back(t.leaves[0]); }), kNoTree) << "in no tree";
    EXPECT_EQ(fault([](Bvh8& t) {
                  t.nodes[1].count = 1;
                  t.nodes[1].leaves |= 2;
              }),
              kNoTree)
        << "a leaf that is no child";
}

/// Queries' agendas have room for 64 levels.
TEST_F(Bvh8Check, FindsATreeThatIsTooDeep) {
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

TEST_F(Bvh8Check, FindsLeavesWithWhatIsNotThere) {
    const std::string kForeign = "a leaf of the tree has what isn't in the mesh";
    EXPECT_EQ(fault([](Bvh8& t) { t.leaves[3].triangle[0] = kTriangles; }), kForeign);
    EXPECT_EQ(fault([](Bvh8& t) { t.leaves[3].triangle[15] = kTriangles; }), kForeign) << "an unused slot";
    EXPECT_EQ(fault([](Bvh8& t) { t.leaves[3].vertex_of[1][15] = 16; }), kForeign);
    EXPECT_EQ(fault([](Bvh8& t) { t.leaves[3].vertices = 17; }), kForeign);
    EXPECT_EQ(fault([](Bvh8& t) { t.leaves[3].triangles = 17; }), kForeign);
    EXPECT_EQ(fault([](Bvh8& t) { t.leaves[3].triangles = 0; }), kForeign);
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(fault([](Bvh8& t) { t.leaves[3].vertex[2][15] = kNan; }), kForeign);
    EXPECT_EQ(fault([](Bvh8& t) { t.leaves[3].origin[0] = -std::numeric_limits<float>::infinity(); }),
              kForeign);
    EXPECT_EQ(fault([](Bvh8& t) { t.reach = kNan; }), "the tree is nowhere");
    EXPECT_EQ(fault([](Bvh8& t) { t.outer.radius = kNan; }), "the tree is nowhere");
}

}  // namespace
}  // namespace campuswalk::collision

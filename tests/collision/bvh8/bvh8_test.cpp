#include "collision/bvh8/bvh8.h"

#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "tests/support/contact_scenes.h"
#include "tests/support/effort.h"
#include "tests/support/random_scene.h"

namespace campuswalk::collision {
namespace {

using support::Dice;

template <std::size_t N>
Vec3 point(const std::array<float, N>& o) {
    return {o[0], o[1], o[2]};
}

/// Walks a tree and checks what queries rely on.
class Inspector {
public:
    Inspector(const TriangleMesh& mesh, const Bvh8& tree)
        : mesh_(mesh), tree_(tree), seen_(mesh.triangles.size()) {}

    void inspect() {
        inspect_node(0);
        for (std::size_t t = 0; t < seen_.size(); ++t) {
            EXPECT_EQ(seen_[t], 1) << "triangle " << t;
        }
    }
    std::size_t deepest() const { return deepest_; }

private:
    /// Triangles below a node.
    std::vector<std::uint32_t> inspect_node(std::uint32_t index, std::size_t depth = 1) {
        deepest_ = std::max(deepest_, depth);
        const Bvh8Node& node = tree_.nodes[index];
        constexpr decltype(Bvh8Node::axes) kStraight = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
        EXPECT_EQ(node.rotated, node.axes != kStraight);
        EXPECT_GE(node.count, 1);
        EXPECT_LE(node.count, kBvh8Children);
        std::vector<std::uint32_t> all;
        for (std::size_t i = 0; i < node.count; ++i) {
            const bool leaf = (node.leaves >> i & 1) != 0;
            const auto below =
                leaf ? inspect_leaf(tree_.leaves[node.child[i]]) : inspect_node(node.child[i], depth + 1);
            expect_held(node, i, below);
            all.insert(all.end(), below.begin(), below.end());
        }
        return all;
    }

    void expect_held(const Bvh8Node& node, std::size_t child, const std::vector<std::uint32_t>& triangles) {
        for (const std::uint32_t t : triangles) {
            const Triangle vertices = collision::vertices(mesh_, t);
            for (const Vec3& p : {vertices.a, vertices.b, vertices.c}) {
                const Vec3 d = p - point(node.origin);
                EXPECT_LE(d.norm(), node.radius);
                for (std::size_t k = 0; k < 3; ++k) {
                    const Vec3 axis(node.axes[0][k], node.axes[1][k], node.axes[2][k]);
                    EXPECT_NEAR(axis.norm(), 1.0, 1e-6);
                    EXPECT_LE(std::abs(axis.dot(d) - static_cast<double>(node.center[k][child])),
                              static_cast<double>(node.half[k][child]));
                }
            }
        }
    }

    std::vector<std::uint32_t> inspect_leaf(const Bvh8Leaf& leaf) {
        EXPECT_GE(leaf.triangle_count, 1);
        EXPECT_LE(leaf.triangle_count, kLeafTriangles);
        EXPECT_LE(leaf.vertex_count, kLeafVertices);
        std::vector<std::uint32_t> all;
        for (std::size_t slot = 0; slot < leaf.triangle_count; ++slot) {
            const std::uint32_t t = leaf.triangle[slot];
            ++seen_[t];
            all.push_back(t);
            const Triangle given = collision::vertices(mesh_, t);
            const Triangle found = collision::vertices(mesh_, leaf, slot);
            EXPECT_TRUE(found.a == given.a && found.b == given.b && found.c == given.c);
            for (std::size_t c = 0; c < 3; ++c) {
                expect_vertex(leaf, slot, c, mesh_.positions[mesh_.triangles[t][c]].cast<double>());
            }
        }
        for (std::size_t slot = leaf.triangle_count; slot < kLeafTriangles; ++slot) {
            EXPECT_LT(leaf.plane[3][slot], -1e29F) << "everything lies above the plane of an unused slot";
        }
        return all;
    }

    void expect_vertex(const Bvh8Leaf& leaf, std::size_t slot, std::size_t c, const Vec3& position) {
        const std::size_t at = leaf.vertex_of[c][slot];
        ASSERT_LT(at, leaf.vertex_count);
        const Vec3 stored(leaf.vertex[0][at], leaf.vertex[1][at], leaf.vertex[2][at]);
        const Vec3 local = position - point(leaf.origin);
        const double unit = kFloatUnit * static_cast<double>(leaf.radius);
        EXPECT_LE((stored - local).cwiseAbs().maxCoeff(), unit);
        EXPECT_LE(local.norm(), leaf.radius);
        const Vec3 normal(leaf.plane[0][slot], leaf.plane[1][slot], leaf.plane[2][slot]);
        EXPECT_LE(std::abs(normal.dot(local) - static_cast<double>(leaf.plane[3][slot])), 4.0 * unit);
        const double along = point(leaf.facing).dot(stored);
        EXPECT_LE(along, static_cast<double>(leaf.high) + 4.0 * unit);
        EXPECT_GE(along, static_cast<double>(leaf.low) - 4.0 * unit);
    }

    const TriangleMesh& mesh_;
    const Bvh8& tree_;
    std::vector<int> seen_;
    std::size_t deepest_ = 0;
};

TEST(Bvh8, HoldsEveryTriangleOnce) {
    Dice dice(430);
    for (int i = 0; i < support::repeats(40); ++i) {
        SCOPED_TRACE(i);
        const TriangleMesh mesh = support::random_mesh(dice, 1 + dice.below(400), dice.between(0.5, 40.0));
        Inspector(mesh, build_bvh8(mesh)).inspect();
    }
    for (const TriangleMesh& mesh : {support::needles(dice, 200), support::ball(40),
                                     support::lattice_soup(dice, 300, Vec3(450000, 60, -448000))}) {
        Inspector(mesh, build_bvh8(mesh)).inspect();
    }
}

TEST(Bvh8, FillsLeavesIfTrianglesShareVertices) {
    const TriangleMesh mesh = support::ball(60);
    const Bvh8 tree = build_bvh8(mesh);
    EXPECT_GT(mesh.triangles.size(), 9 * tree.leaves.size());
    EXPECT_LT(tree.nodes.size(), tree.leaves.size() / 3);
}

TEST(Bvh8, StaysShallowIfTrianglesCannotBeSeparated) {
    TriangleMesh same;
    same.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    same.triangles.assign(20000, {0, 1, 2});
    const Bvh8 tree = build_bvh8(same);
    Inspector inspector(same, tree);
    inspector.inspect();
    EXPECT_LE(inspector.deepest(), 8U);
}

TEST(Bvh8, IsDeterministic) {
    Dice dice(431);
    const TriangleMesh mesh = support::random_mesh(dice, 500, 5.0);
    const Bvh8 one = build_bvh8(mesh);
    const Bvh8 two = build_bvh8(mesh);
    ASSERT_EQ(one.leaves.size(), two.leaves.size());
    for (std::size_t i = 0; i < one.leaves.size(); ++i) {
        EXPECT_EQ(one.leaves[i].triangle, two.leaves[i].triangle);
    }
}

}  // namespace
}  // namespace campuswalk::collision

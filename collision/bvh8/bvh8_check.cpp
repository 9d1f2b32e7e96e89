#include "collision/bvh8/bvh8_check.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace campuswalk::collision {

namespace {

/// What a query's agenda has room for: see tree_traversal.h.
constexpr std::uint8_t kDeepest = 64;

/// Not 0 if any isn't finite. By the exponent's bits and without a way out, for lanes' sake.
template <std::size_t N>
std::uint32_t not_finite(const std::array<float, N>& numbers) {
    constexpr std::uint32_t kExponent = 0x7F800000;
    std::uint32_t found = 0;
    for (const float number : numbers) {
        found |= (std::bit_cast<std::uint32_t>(number) & kExponent) == kExponent ? 1U : 0U;
    }
    return found;
}

std::uint32_t not_finite(const Bvh8Leaf& leaf) {
    return not_finite(leaf.origin) | not_finite(leaf.vertex[0]) | not_finite(leaf.vertex[1]) |
           not_finite(leaf.vertex[2]);
}

/// Not 0 if a triangle has a corner that no leaf has.
std::uint8_t beyond_vertices(const Bvh8Leaf& leaf) {
    static_assert(std::has_single_bit(kLeafVertices));
    std::uint8_t all = 0;
    for (const auto& of_triangle : leaf.vertex_of) {
        for (const std::uint8_t vertex : of_triangle) {
            all = static_cast<std::uint8_t>(all | vertex);
        }
    }
    return static_cast<std::uint8_t>(all & ~(kLeafVertices - 1));
}

bool is_sound(const Bvh8Leaf& leaf, std::size_t mesh_triangles) {
    std::uint32_t last = 0;
    for (const std::uint32_t triangle : leaf.triangle) {
        last = std::max(last, triangle);
    }
    return last < mesh_triangles && leaf.vertices >= 1 && leaf.vertices <= kLeafVertices &&
           leaf.triangles >= 1 && leaf.triangles <= kLeafTriangles &&
           (beyond_vertices(leaf) | not_finite(leaf)) == 0;
}

/// Follows every way down from the root: children come after their parents, and nothing has two.
class Inspection {
public:
    explicit Inspection(const Bvh8& tree)
        : tree_(tree), node_depth_(tree.nodes.size()), leaf_seen_(tree.leaves.size()) {}

    bool is_whole() {
        std::size_t nodes_seen = 1;
        std::size_t leaves_seen = 0;
        for (std::size_t n = 0; n < tree_.nodes.size(); ++n) {
            const Bvh8Node& node = tree_.nodes[n];
            if (node.count < 1 || node.count > kBvh8Children || node.leaves >> node.count != 0) {
                return false;
            }
            for (std::size_t i = 0; i < node.count; ++i) {
                const bool leaf = (node.leaves >> i & 1) != 0;
                if (!(leaf ? see_leaf(node.child[i]) : see_node(n, node.child[i]))) {
                    return false;
                }
                ++(leaf ? leaves_seen : nodes_seen);
            }
        }
        return nodes_seen == tree_.nodes.size() && leaves_seen == tree_.leaves.size();
    }

private:
    bool see_node(std::size_t parent, std::uint32_t child) {
        if (child <= parent || child >= node_depth_.size() || node_depth_[child] != 0 ||
            node_depth_[parent] == kDeepest) {
            return false;
        }
        node_depth_[child] = static_cast<std::uint8_t>(node_depth_[parent] + 1);
        return true;
    }
    bool see_leaf(std::uint32_t leaf) {
        if (leaf >= leaf_seen_.size() || leaf_seen_[leaf]) {
            return false;
        }
        leaf_seen_[leaf] = true;
        return true;
    }

    const Bvh8& tree_;
    std::vector<std::uint8_t> node_depth_;  ///< 0 for the root and for what hasn't been seen
    std::vector<bool> leaf_seen_;
};

}  // namespace

const char* fault_of(const Bvh8& tree, std::size_t mesh_triangles) {
    if (tree.nodes.empty()) {
        return "the tree has no root";
    }
    if (!Inspection(tree).is_whole()) {
        return "the tree's nodes don't make a tree";
    }
    if (!std::isfinite(tree.reach) || !tree.outer.center.allFinite() || !std::isfinite(tree.outer.radius)) {
        return "the tree is nowhere";
    }
    for (const Bvh8Leaf& leaf : tree.leaves) {
        if (!is_sound(leaf, mesh_triangles)) {
            return "a leaf of the tree has what isn't in the mesh";
        }
    }
    return nullptr;
}

}  // namespace campuswalk::collision

#include "collision/bvh8/bvh8_check.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace campuswalk::collision {

namespace {

/// The depth that a query's stack has room for: see tree_traversal.h.
constexpr std::uint8_t kMaxDepth = 64;

/// Not 0 if any number isn't finite. By the bits of the exponent and without early exit, to be vectorized.
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

/// Not 0 if a triangle's vertex index is out of range.
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
    return last < mesh_triangles && leaf.vertex_count >= 1 && leaf.vertex_count <= kLeafVertices &&
           leaf.triangle_count >= 1 && leaf.triangle_count <= kLeafTriangles &&
           (beyond_vertices(leaf) | not_finite(leaf)) == 0;
}

/// Follows all links from the root: children must come after their parents, and each has only one.
class Inspection {
public:
    explicit Inspection(const Bvh8& tree)
        : tree_(tree), node_depth_(tree.nodes.size()), leaf_visited_(tree.leaves.size()) {}

    bool is_tree() {
        std::size_t node_count = 1;
        std::size_t leaf_count = 0;
        for (std::size_t n = 0; n < tree_.nodes.size(); ++n) {
            const Bvh8Node& node = tree_.nodes[n];
            if (node.count < 1 || node.count > kBvh8Children || node.leaves >> node.count != 0) {
                return false;
            }
            for (std::size_t i = 0; i < node.count; ++i) {
                const bool leaf = (node.leaves >> i & 1) != 0;
                if (!(leaf ? visit_leaf(node.child[i]) : visit_node(n, node.child[i]))) {
                    return false;
                }
                ++(leaf ? leaf_count : node_count);
            }
        }
        return node_count == tree_.nodes.size() && leaf_count == tree_.leaves.size();
    }

private:
    bool visit_node(std::size_t parent, std::uint32_t child) {
        if (child <= parent || child >= node_depth_.size() || node_depth_[child] != 0 ||
            node_depth_[parent] == kMaxDepth) {
            return false;
        }
        node_depth_[child] = static_cast<std::uint8_t>(node_depth_[parent] + 1);
        return true;
    }
    bool visit_leaf(std::uint32_t leaf) {
        if (leaf >= leaf_visited_.size() || leaf_visited_[leaf]) {
            return false;
        }
        leaf_visited_[leaf] = true;
        return true;
    }

    const Bvh8& tree_;
    std::vector<std::uint8_t> node_depth_;  ///< 0 for the root and for nodes not visited yet
    std::vector<bool> leaf_visited_;
};

}  // namespace

const char* fault_of(const Bvh8& tree, std::size_t mesh_triangles) {
    if (tree.nodes.empty()) {
        return "the tree has no root";
    }
    if (!Inspection(tree).is_tree()) {
        return "the tree's nodes don't form a tree";
    }
    if (!std::isfinite(tree.reach) || !tree.outer.center.allFinite() || !std::isfinite(tree.outer.radius)) {
        return "the tree's bounds aren't finite";
    }
    for (const Bvh8Leaf& leaf : tree.leaves) {
        if (!is_sound(leaf, mesh_triangles)) {
            return "a leaf of the tree has invalid triangles or vertices";
        }
    }
    return nullptr;
}

}  // namespace campuswalk::collision

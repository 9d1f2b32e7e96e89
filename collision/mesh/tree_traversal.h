#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>
#include <variant>

#include "collision/base/query_statistics.h"
#include "collision/bvh8/box_lanes.h"
#include "collision/bvh8/bvh8.h"
#include "collision/hybrid/hybrid_tree.h"
#include "collision/mesh/mesh_collider.h"

namespace campuswalk::collision {

// One traversal for all queries of one mesh, whichever tree it has; only rays have a faster one of the BVH8
// (collision/bvh8/kernels/bvh8_rays.cpp). A query is a volume and a function that visits triangles. The
// volume returns lower bounds of what the query looks for, or kApart; the visitor returns the limit above
// which nothing interests the query any more. Both are fractions of a ray's or sweep's path and squared
// distances from a point, capsule or box; in the hybrid tree a capsule's or box's bounds are 0 or kApart:
//
//     double bound(const BoundingSphere&) const          of a node's outer layer, or of a whole mesh
//     double bound(const OrientedBox&) const             of a node's inner layer
//     void bounds(frame, centers, halves, bounds) const  of N boxes side by side: float32 in a BVH8, one in
//                                                        doubles for a node of the hybrid tree
//     double visit(triangle, limit)                      returns the new limit
//     double visit(leaf, slot, limit)                    likewise, if the query prefers a BVH8 leaf's copy
//
// A tree has three functions: `push_root`, `open_node` and `open_leaf`.

/// Nodes and leaves that are still to be visited.
class TraversalStack {
public:
    /// Uninitialized, so that a query doesn't set all 512 first.
    struct Entry {
        double bound;
        std::uint32_t index;
        bool leaf;
    };

    bool empty() const { return depth_ == 0; }
    Entry pop() { return entries_[--depth_]; }

    /// Sorts the entries pushed through it: the one with the lowest bound is popped first.
    class Siblings {
    public:
        explicit Siblings(TraversalStack& stack) : stack_(stack), first_(stack.depth_) {}

        void push(const Entry& entry) {
            std::size_t at = stack_.depth_++;
            for (; at > first_ && stack_.entries_[at - 1].bound < entry.bound; --at) {
                stack_.entries_[at] = stack_.entries_[at - 1];
            }
            stack_.entries_[at] = entry;
        }

    private:
        TraversalStack& stack_;
        std::size_t first_;
    };

private:
    /// Enough for 2^32 triangles. The paper's tree: a child has at most 15/16 of its parent's triangles,
    /// which is 345 levels with one entry each. The BVH8: the largest of eight children, split off seven
    /// times, has at most (15/16)^7 of its parent's, which is 64 levels with seven entries each.
    std::array<Entry, 512> entries_;
    std::size_t depth_ = 0;
};

// The paper's tree: outer spheres first, and the inner layer where they leave it open. A capsule or box is
// tested by eq. (1) (volume_overlap.h), a ray or sweep by its distance from the sphere's centre.

template <typename Volume>
void push_node(const HybridTree& tree, std::uint32_t index, const Volume& volume, double limit,
               TraversalStack::Siblings& siblings, QueryStatistics& work) {
    const HybridNode& node = tree.nodes[index];
    ++work.volume_tests;
    ++work.sphere_tests;
    const double by_sphere = volume.bound(node.outer);
    if (by_sphere > limit) {
        return;
    }
    ++work.box_tests;
    if (const double bound = std::max(by_sphere, volume.bound(node.inner)); !(bound > limit)) {
        siblings.push({bound, index, node.is_leaf()});
    }
}

template <typename Volume>
void push_root(const HybridTree& tree, const Volume& volume, double limit, TraversalStack& stack,
               QueryStatistics& work) {
    TraversalStack::Siblings siblings(stack);
    push_node(tree, 0, volume, limit, siblings, work);
}

template <typename Volume>
void open_node(const HybridTree& tree, std::uint32_t index, const Volume& volume, double limit,
               TraversalStack& stack, QueryStatistics& work) {
    TraversalStack::Siblings siblings(stack);
    const std::uint32_t left = tree.nodes[index].first;
    for (const std::uint32_t child : {left + 1, left}) {
        push_node(tree, child, volume, limit, siblings, work);
    }
}

template <typename Volume, typename Visit>
void open_leaf(const HybridTree& tree, std::uint32_t index, const Volume&, double& limit, const Visit& visit,
               QueryStatistics& work) {
    const HybridNode& leaf = tree.nodes[index];
    for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
        ++work.primitive_tests;
        limit = visit(tree.order[i], limit);
    }
}

// The BVH8: the mesh's sphere, then eight boxes at once.

template <typename Volume>
void push_root(const Bvh8& tree, const Volume& volume, double limit, TraversalStack& stack,
               QueryStatistics& work) {
    ++work.volume_tests;
    ++work.sphere_tests;
    if (const double bound = volume.bound(tree.outer); !(bound > limit)) {
        TraversalStack::Siblings(stack).push({bound, 0, false});
    }
}

template <typename Volume>
void open_node(const Bvh8& tree, std::uint32_t index, const Volume& volume, double limit,
               TraversalStack& stack, QueryStatistics& work) {
    TraversalStack::Siblings siblings(stack);
    const Bvh8Node& node = tree.nodes[index];
    work.volume_tests += node.count;
    work.box_tests += node.count;
    alignas(32) std::array<float, kBvh8Children> bounds;
    volume.bounds(BoxFrame(node), node.center, node.half, bounds);
    for (std::size_t i = 0; i < node.count; ++i) {
        if (const double bound = bounds[i]; !(bound > limit)) {
            siblings.push({bound, node.child[i], (node.leaves >> i & 1) != 0});
        }
    }
}

template <typename Volume, typename Visit>
void open_leaf(const Bvh8& tree, std::uint32_t index, const Volume& volume, double& limit, const Visit& visit,
               QueryStatistics& work) {
    const Bvh8Leaf& leaf = tree.leaves[index];
    const LeafBoxes boxes(leaf);
    alignas(32) std::array<float, kLeafTriangles> bounds;
    volume.bounds(BoxFrame(leaf), boxes.center, boxes.half, bounds);
    for (std::size_t i = 0; i < leaf.triangle_count; ++i) {
        if (!(static_cast<double>(bounds[i]) > limit)) {
            ++work.primitive_tests;
            if constexpr (std::is_invocable_v<const Visit&, const Bvh8Leaf&, std::size_t, double>) {
                limit = visit(leaf, i, limit);
            } else {
                limit = visit(leaf.triangle[i], limit);
            }
        }
    }
}

/// Calls `visit` with the triangles whose bound isn't above the limit, those with low bounds first.
template <typename Volume, typename Visit>
void traverse(const MeshCollider& mesh, const Volume& volume, double limit, const Visit& visit,
              QueryStatistics* statistics) {
    QueryStatistics work{.transform_updates = 1};
    const auto traverse_tree = [&](const auto& tree) {
        TraversalStack stack;
        push_root(tree, volume, limit, stack, work);
        while (!stack.empty()) {
            const TraversalStack::Entry next = stack.pop();
            if (next.bound > limit) {
                continue;
            }
            if (next.leaf) {
                open_leaf(tree, next.index, volume, limit, visit, work);
            } else {
                open_node(tree, next.index, volume, limit, stack, work);
            }
        }
    };
    std::visit(traverse_tree, mesh.tree());
    add_to(statistics, work);
}

}  // namespace campuswalk::collision

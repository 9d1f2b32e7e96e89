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

// One way down for queries of one mesh. A tree says how a descent starts and how it opens a node and a leaf;
// rays have a faster way down the BVH8 (collision/bvh8/kernels/bvh8_rays.h). A query is a volume and what it
// does with a triangle. The volume gives lower bounds of what the query looks for (a fraction, a squared
// distance), or kApart; the query sets the limit above which nothing interests it any more:
//
//     double bound(const BoundingSphere&) const          of a node's outer layer, or of a whole mesh
//     double bound(const OrientedBox&) const             of a node's inner layer
//     void bounds(frame, centers, halves, bounds) const  of N float32 boxes side by side
//     double meet(triangle, limit)                       answers the new limit
//     double meet(leaf, slot, limit)                     likewise, if the query prefers a wide leaf's copy

/// Parts of a tree that are still to be looked at.
class TraversalStack {
public:
    /// Without initialisers: each query would set all that could wait.
    struct Entry {
        double bound;
        std::uint32_t index;
        bool leaf;
    };

    bool empty() const { return depth_ == 0; }
    Entry take() { return waiting_[--depth_]; }

    /// Entries that are added one after the other leave the lowest bound first.
    class Siblings {
    public:
        explicit Siblings(TraversalStack& stack) : stack_(stack), first_(stack.depth_) {}

        void add(const Entry& entry) {
            std::size_t at = stack_.depth_++;
            for (; at > first_ && stack_.waiting_[at - 1].bound < entry.bound; --at) {
                stack_.waiting_[at] = stack_.waiting_[at - 1];
            }
            stack_.waiting_[at] = entry;
        }

    private:
        TraversalStack& stack_;
        std::size_t first_;
    };

private:
    /// Enough for 2^32 triangles. The paper's tree: a child has at most 15/16 of its parent, which is 345
    /// levels of one that waits. The wide tree: the largest of eight children, split off seven times, has at
    /// most (15/16)^7 of its parent, which is 64 levels of seven that wait.
    std::array<Entry, 512> waiting_;
    std::size_t depth_ = 0;
};

/// The paper's two layers: outer spheres first, eq. (1), and the inner layer where they leave it open.
template <typename Volume>
void add_node(const HybridTree& tree, std::uint32_t index, const Volume& volume, double limit,
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
        siblings.add({bound, index, node.is_leaf()});
    }
}

template <typename Volume>
void start(const HybridTree& tree, const Volume& volume, double limit, TraversalStack& stack,
           QueryStatistics& work) {
    TraversalStack::Siblings siblings(stack);
    add_node(tree, 0, volume, limit, siblings, work);
}

template <typename Volume>
void start(const Bvh8& tree, const Volume& volume, double limit, TraversalStack& stack,
           QueryStatistics& work) {
    ++work.volume_tests;
    ++work.sphere_tests;
    if (const double bound = volume.bound(tree.outer); !(bound > limit)) {
        TraversalStack::Siblings(stack).add({bound, 0, false});
    }
}

template <typename Volume>
void open_node(const HybridTree& tree, std::uint32_t index, const Volume& volume, double limit,
               TraversalStack& stack, QueryStatistics& work) {
    TraversalStack::Siblings siblings(stack);
    const std::uint32_t left = tree.nodes[index].first;
    for (const std::uint32_t child : {left + 1, left}) {
        add_node(tree, child, volume, limit, siblings, work);
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
            siblings.add({bound, node.child[i], (node.leaves >> i & 1) != 0});
        }
    }
}

template <typename Volume, typename Meet>
void open_leaf(const HybridTree& tree, std::uint32_t index, const Volume&, double& limit, const Meet& meet,
               QueryStatistics& work) {
    const HybridNode& leaf = tree.nodes[index];
    for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
        ++work.primitive_tests;
        limit = meet(tree.order[i], limit);
    }
}

template <typename Volume, typename Meet>
void open_leaf(const Bvh8& tree, std::uint32_t index, const Volume& volume, double& limit, const Meet& meet,
               QueryStatistics& work) {
    const Bvh8Leaf& leaf = tree.leaves[index];
    const LeafBoxes boxes(leaf);
    alignas(32) std::array<float, kLeafTriangles> bounds;
    volume.bounds(BoxFrame(leaf), boxes.center, boxes.half, bounds);
    for (std::size_t i = 0; i < leaf.triangles; ++i) {
        if (!(static_cast<double>(bounds[i]) > limit)) {
            ++work.primitive_tests;
            if constexpr (std::is_invocable_v<const Meet&, const Bvh8Leaf&, std::size_t, double>) {
                limit = meet(leaf, i, limit);
            } else {
                limit = meet(leaf.triangle[i], limit);
            }
        }
    }
}

template <typename Tree, typename Volume, typename Meet>
void descend(const Tree& tree, const Volume& volume, double limit, const Meet& meet, QueryStatistics& work) {
    TraversalStack stack;
    start(tree, volume, limit, stack, work);
    while (!stack.empty()) {
        const TraversalStack::Entry next = stack.take();
        if (next.bound > limit) {
            continue;
        }
        if (next.leaf) {
            open_leaf(tree, next.index, volume, limit, meet, work);
        } else {
            open_node(tree, next.index, volume, limit, stack, work);
        }
    }
}

/// Hands `meet` the triangles whose bound isn't above the limit, those of low bounds first.
template <typename Volume, typename Meet>
void descend(const MeshCollider& mesh, const Volume& volume, double limit, const Meet& meet,
             QueryStatistics* statistics) {
    QueryStatistics work{.transform_updates = 1};
    std::visit([&](const auto& tree) { descend(tree, volume, limit, meet, work); }, mesh.tree());
    add_to(statistics, work);
}

}  // namespace campuswalk::collision

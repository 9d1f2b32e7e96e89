#pragma once

#include <cstdint>
#include <vector>

#include "collision/geometry/fitting.h"
#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::collision {

/// A node of the paper's hybrid bounding-volume tree, in the mesh's frame: an outer sphere, tested first, and
/// inside it an inner layer of an oriented box and a sphere about the box's centre.
struct HybridNode {
    BoundingSphere outer;
    OrientedBox inner;
    /// Leaf: its first entry of HybridTree::order. Inner node: its left child; the right one is first + 1.
    std::uint32_t first = 0;
    std::uint32_t count = 0;  ///< leaf: number of entries; inner node: 0

    bool is_leaf() const { return count > 0; }
};

/// Plain data, built by `build_hybrid_tree`. nodes[0] is the root.
struct HybridTree {
    std::vector<HybridNode> nodes;
    std::vector<std::uint32_t> order;  ///< triangle indices, contiguous for each leaf
};

struct HybridTreeSettings {
    /// Small leaves need fewer triangle tests, large ones fewer node tests. Mesh against mesh (teapot,
    /// cylinder), leaves of one and leaves of four both take 1.2 times as long as leaves of two.
    std::uint32_t leaf_triangles = 2;
};

/// Builds the tree from the top down: fits each node to its triangles, then splits them in two (see
/// hybrid_tree_split.h).
HybridTree build_hybrid_tree(const TriangleMesh& mesh, const HybridTreeSettings& settings = {});

}  // namespace campuswalk::collision

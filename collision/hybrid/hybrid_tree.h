#pragma once

#include <cstdint>
#include <vector>

#include "collision/geometry/fitting.h"
#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::collision {

/// One node of the paper's hybrid bounding-volume tree: an outer sphere, tested first, around an inner
/// layer of an oriented box and a sphere about the box's centre. Frame: the mesh's.
struct HybridNode {
    BoundingSphere outer;
    OrientedBox inner;
    std::uint32_t first = 0;  ///< leaf: first entry of HybridTree::order; inner node: the left child
    std::uint32_t count =
        0;  ///< leaf: number of entries; 0 for an inner node, whose children are first, first + 1

    bool is_leaf() const { return count > 0; }
};

/// Plain data; `build_hybrid_tree` makes it, the queries in hybrid_tree_contacts.h read it. nodes[0] is the
/// root.
struct HybridTree {
    std::vector<HybridNode> nodes;
    std::vector<std::uint32_t> order;  ///< triangle indices, each leaf's side by side
};

struct HybridTreeSettings {
    /// Small leaves keep triangle tests few, large ones node tests: mesh against mesh (teapot, cylinder)
    /// leaves of one and leaves of four both take 1.2 times as long as leaves of two.
    std::uint32_t leaf_triangles = 2;
};

/// Top-down and static: each node is fitted to its triangles, which are then split in two (see
/// hybrid_tree_split.h).
HybridTree build_hybrid_tree(const TriangleMesh& mesh, const HybridTreeSettings& settings = {});

}  // namespace campuswalk::collision

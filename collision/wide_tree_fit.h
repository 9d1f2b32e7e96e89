#pragma once

#include <span>

#include "collision/triangle_mesh.h"
#include "collision/wide_tree.h"
#include "collision/wide_tree_split.h"

namespace campuswalk::collision {

/// Sets the frame of `node` and the boxes of its children, whose triangles lie side by side in memory. The
/// frame is that of the vertices' principal axes (paper III.A.2) or the mesh's own, whichever makes the
/// smaller boxes.
void fit_node(WideNode& node, const TriangleMesh& mesh, std::span<const std::span<const SplitItem>> children);

/// Whether triangles fit one leaf: they aren't too many and nor are their corners.
bool fits_leaf(const TriangleMesh& mesh, std::span<const SplitItem> items);

/// A leaf of triangles that fit one.
WideLeaf make_leaf(const TriangleMesh& mesh, std::span<const SplitItem> items);

}  // namespace campuswalk::collision

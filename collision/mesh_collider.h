#pragma once

#include <mutex>
#include <optional>

#include "collision/closed_parts.h"
#include "collision/hybrid_tree.h"
#include "collision/triangle_mesh.h"

namespace campuswalk::collision {

/// A mesh with its tree, built once and never changed.
class MeshCollider {
public:
    /// Throws std::invalid_argument for a mesh without triangles, an index out of range or a position that
    /// is not finite: callers check user input first.
    explicit MeshCollider(TriangleMesh mesh);

    const TriangleMesh& mesh() const { return mesh_; }
    const HybridTree& tree() const { return tree_; }
    /// Found when first asked for: few meshes ever are.
    const ClosedParts& closed_parts() const;

private:
    TriangleMesh mesh_;
    HybridTree tree_;
    mutable std::once_flag closed_once_;
    mutable std::optional<ClosedParts> closed_;
};

}  // namespace campuswalk::collision

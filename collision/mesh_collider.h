#pragma once

#include <mutex>
#include <optional>

#include "collision/closed_parts.h"
#include "collision/hybrid_tree.h"
#include "collision/triangle_mesh.h"
#include "collision/wide_tree.h"

namespace campuswalk::collision {

/// A mesh with its tree, built once and never changed.
class MeshCollider {
public:
    /// Throws std::invalid_argument for a mesh without triangles, an index out of range, or a position that
    /// is not finite or beyond kMaxCoordinate: callers check user input first.
    explicit MeshCollider(TriangleMesh mesh);

    const TriangleMesh& mesh() const { return mesh_; }
    const HybridTree& tree() const { return tree_; }
    /// For mesh against mesh. Built when first asked for: most meshes never meet another.
    const WideTree& wide_tree() const;
    /// Found when first asked for: few meshes ever are.
    const ClosedParts& closed_parts() const;

private:
    TriangleMesh mesh_;
    HybridTree tree_;
    mutable std::once_flag wide_once_;
    mutable std::optional<WideTree> wide_;
    mutable std::once_flag closed_once_;
    mutable std::optional<ClosedParts> closed_;
};

}  // namespace campuswalk::collision

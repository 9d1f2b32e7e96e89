#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "collision/bvh8/bvh8.h"
#include "collision/geometry/triangle_mesh.h"
#include "collision/hybrid/hybrid_tree.h"
#include "collision/mesh/closed_parts.h"

namespace campuswalk::collision {

/// Whether the closed parts of a mesh are determined (closed_parts.h), which only `is_inside` needs.
enum class Interior : std::uint8_t { found, unknown };

/// A mesh with its tree, built once and never changed.
class MeshCollider {
public:
    /// Throws std::invalid_argument for a mesh without triangles, an index out of range, or a position that
    /// is not finite or beyond kMaxCoordinate: callers check user input first.
    explicit MeshCollider(TriangleMesh mesh, TreeKind tree_kind = TreeKind::bvh8,
                          Interior interior = Interior::found);
    /// With the tree and the closed parts built earlier from this mesh, such as one read from a file. Throws
    /// std::invalid_argument for a mesh as above, and for an inconsistent tree (bvh8_check.h).
    MeshCollider(TriangleMesh mesh, Bvh8 tree, ClosedParts closed);

    const TriangleMesh& mesh() const { return mesh_; }
    TreeKind tree_kind() const { return tree_.index() == 0 ? TreeKind::bvh8 : TreeKind::hybrid; }
    const std::variant<Bvh8, HybridTree>& tree() const { return tree_; }
    /// Throw std::bad_variant_access for a collider with the other kind of tree.
    const Bvh8& bvh8() const { return std::get<Bvh8>(tree_); }
    const HybridTree& hybrid_tree() const { return std::get<HybridTree>(tree_); }
    /// Throws std::bad_optional_access for a collider of Interior::unknown.
    const ClosedParts& closed_parts() const { return closed_.value(); }

private:
    TriangleMesh mesh_;
    std::variant<Bvh8, HybridTree> tree_;
    std::optional<ClosedParts> closed_;
};

}  // namespace campuswalk::collision

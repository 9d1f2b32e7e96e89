#pragma once

#include <cstddef>
#include <memory>

#include "collision/mesh/mesh_collider.h"
#include "tools/campuswalk_bench/engine/engine.h"

namespace campuswalk::tools::bench {

/// Builds a MeshCollider: copies and checks the mesh and builds its tree. `mesh` must outlive it.
std::unique_ptr<TreeBuilder> make_our_builder(const collision::TriangleMesh& mesh,
                                              collision::TreeKind tree_kind);

// The size of the data in bytes, without unused capacity of arrays.

std::size_t bytes_of_mesh(const collision::TriangleMesh& mesh);
std::size_t bytes_of_tree(const collision::MeshCollider& collider);

}  // namespace campuswalk::tools::bench

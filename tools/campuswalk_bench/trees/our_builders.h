#pragma once

#include <cstddef>
#include <memory>

#include "collision/mesh/mesh_collider.h"
#include "tools/campuswalk_bench/engine/engine.h"

namespace campuswalk::tools::bench {

/// Makes a MeshCollider: the mesh is copied and checked, its tree built. `mesh` must outlive it.
std::unique_ptr<TreeBuilder> make_our_builder(const collision::TriangleMesh& mesh,
                                              collision::TreeKind tree_kind);

// What the data takes, bytes: the arrays as long as they are filled.

std::size_t bytes_of_mesh(const collision::TriangleMesh& mesh);
std::size_t bytes_of_tree(const collision::MeshCollider& collider);

}  // namespace campuswalk::tools::bench

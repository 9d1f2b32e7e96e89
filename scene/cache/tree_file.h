#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "collision/geometry/shapes.h"
#include "collision/mesh/mesh_collider.h"
#include "scene/base/binary_archive.h"

namespace campuswalk::scene {

/// A collision mesh with its tree, where it stands.
struct PlacedMesh {
    std::string object;  ///< the campus object whose mesh it is
    std::shared_ptr<const collision::MeshCollider> collider;
    collision::Vec3 p_world_origin = collision::Vec3::Zero();
    std::size_t zero_area = 0;  ///< triangles that were left out
};

/// Raise it with whatever changes below, in the trees' layout or in how meshes are baked.
inline constexpr FileKind kTreeFile = {{'c', 'w', ' ', 't', 'r', 'e', 'e', 's'}, 3};

/// Meshes with their trees and closed parts (found here if nobody has asked for them yet), as they lie in
/// memory. Only Layout::wide.
std::vector<std::byte> write_tree_file(std::span<const PlacedMesh> meshes);

/// The same, yet to be sealed: what is large in it is left where it is.
ArchiveWriter archive_trees(std::span<const PlacedMesh> meshes);

/// Reads bytes that may be anything. Throws DamagedFile; what it returns can be asked anything safely (see
/// bvh8_check.h). With an `owner` that keeps the bytes as they are, meshes and trees are used where they
/// lie in them; without, they are copied.
std::vector<PlacedMesh> read_tree_file(std::span<const std::byte> bytes,
                                       std::shared_ptr<const void> owner = nullptr);

}  // namespace campuswalk::scene

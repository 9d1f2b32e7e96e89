#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "collision/mesh_collider.h"
#include "collision/shapes.h"
#include "scene/sealed_bytes.h"

namespace campuswalk::scene {

/// A collision mesh with its tree, where it stands.
struct PlacedMesh {
    std::shared_ptr<const collision::MeshCollider> collider;
    collision::Vec3 p_world_origin = collision::Vec3::Zero();
    std::size_t zero_area = 0;  ///< triangles that were left out
};

/// Raise it with whatever changes below, in the trees' layout or in how meshes are baked.
inline constexpr FileKind kTreeFile = {{'c', 'w', ' ', 't', 'r', 'e', 'e', 's'}, 1};

/// Meshes with their trees, as they lie in memory: reading them is copying them. Only Layout::wide.
std::vector<std::byte> write_tree_file(std::span<const PlacedMesh> meshes);

/// Told of bytes that have been read and won't be again, so that a large file and what is made of it needn't
/// be in memory at once.
using ReadBytes = std::function<void(std::span<const std::byte>)>;

/// Reads bytes that may be anything. Throws DamagedFile; what it returns can be asked anything safely (see
/// wide_tree_check.h).
std::vector<PlacedMesh> read_tree_file(std::span<const std::byte> bytes, const ReadBytes& was_read = {});

}  // namespace campuswalk::scene

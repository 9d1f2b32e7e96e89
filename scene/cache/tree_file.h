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

/// A collision mesh with its tree and its position.
struct PlacedMesh {
    std::string object;  ///< the campus object whose mesh it is
    std::shared_ptr<const collision::MeshCollider> collider;
    collision::Vec3 p_world_origin = collision::Vec3::Zero();
    std::size_t zero_area = 0;  ///< ignored degenerate triangles
    std::size_t openings = 0;   ///< of a trigger's surface, that were closed
    std::size_t left_out = 0;   ///< faces of a trigger's surface that enclose nothing
};

/// Increment the version whenever the layout, the trees or the baking of meshes change.
inline constexpr FileKind kTreeFile = {{'c', 'w', ' ', 't', 'r', 'e', 'e', 's'}, 4};

/// Serializes meshes with their BVH8 and closed parts, which are computed if they weren't yet. Arrays are not
/// copied: `meshes` must outlive the writer.
ArchiveWriter archive_trees(std::span<const PlacedMesh> meshes);

/// The inverse. Accepts untrusted bytes: throws DamagedFile, or returns meshes that are safe to query (see
/// bvh8_check.h). With an `owner` (see ArchiveReader), meshes and trees refer to the bytes instead of
/// copying.
std::vector<PlacedMesh> read_tree_file(std::span<const std::byte> bytes,
                                       std::shared_ptr<const void> owner = nullptr);

}  // namespace campuswalk::scene

#pragma once

#include <optional>
#include <vector>

#include "scene/import/gltf/deformation.h"
#include "scene/import/gltf/document.h"
#include "scene/import/source/sanitize_mesh.h"

namespace campuswalk::scene::gltf {

/// The unique ids of a Draco mesh's attributes.
struct DracoAttributes {
    std::size_t position = 0;
    std::optional<std::size_t> normal;
    std::optional<std::size_t> uv;
    std::optional<std::size_t> color;
    std::vector<JointSource> joints;  ///< of the sets that are wanted
};

/// Decodes KHR_draco_mesh_compression into `out` and returns its joints. `compression` is the extension's
/// object. Throws GltfError if the bytes are damaged or are not a triangle mesh.
std::vector<JointSet> decode_draco(const JsonObject& compression, Bytes packed,
                                   const DracoAttributes& attributes, RawMesh& out);

}  // namespace campuswalk::scene::gltf

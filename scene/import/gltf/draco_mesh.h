#pragma once

#include <cstdint>
#include <optional>

#include "scene/import/gltf/document.h"
#include "scene/import/source/sanitize_mesh.h"

namespace campuswalk::scene::gltf {

/// Which of a Draco mesh's attributes is what, by its unique id.
struct DracoAttributes {
    std::size_t position = 0;
    std::optional<std::size_t> normal;
    std::optional<std::size_t> uv;
    std::optional<std::size_t> color;
};

/// Unpacks KHR_draco_mesh_compression into `out`, indices of any width. `compression` is the extension's
/// object. Throws Fault when the bytes are damaged or hold no triangles.
void unpack_draco(const Item& compression, Bytes packed, const DracoAttributes& attributes, RawMesh& out);

}  // namespace campuswalk::scene::gltf

#pragma once

#include <cstdint>
#include <vector>

#include "scene/import/gltf/document.h"

namespace campuswalk::scene::gltf {

/// Decodes a buffer view with EXT_meshopt_compression. `compression` is the extension's object. Throws
/// GltfError if it is invalid or the bytes are damaged.
std::vector<std::uint8_t> decode_meshopt(const JsonObject& compression, Bytes packed);

}  // namespace campuswalk::scene::gltf

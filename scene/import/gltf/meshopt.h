#pragma once

#include <cstdint>
#include <vector>

#include "scene/import/gltf/document.h"

namespace campuswalk::scene::gltf {

/// The bytes of a buffer view that EXT_meshopt_compression packed; `compression` is the extension's object.
/// Throws Fault when they are damaged or the object doesn't say what it must.
std::vector<std::uint8_t> unpack_meshopt(const Item& compression, Bytes packed);

}  // namespace campuswalk::scene::gltf

#pragma once

#include "scene/import/source/sanitize_mesh.h"

struct aiMesh;

namespace campuswalk::scene {

/// Copies an aiMesh whose polygons have been triangulated. `uv_channel` is the one that its material's
/// texture is laid out in.
RawMesh convert_mesh(const aiMesh& source, unsigned int uv_channel);

}  // namespace campuswalk::scene

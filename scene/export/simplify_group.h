#pragma once

#include "scene/export/mesh_groups.h"

namespace campuswalk::scene {

/// Removes vertices as long as the surface stays within `error` metres of the original, and the original of
/// it, at all vertices, centres and edges' middles. Its open edges stay where they are, so that no crack
/// opens between it and the groups beside it. Painted surfaces (colours of vertices) are left as they are.
void simplify(MeshGroup& group, double error);

}  // namespace campuswalk::scene

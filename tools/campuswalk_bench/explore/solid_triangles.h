#pragma once

#include "collision/geometry/triangle_mesh.h"
#include "collision/world/world.h"

namespace campuswalk::tools::bench {

/// All solids of a world as one mesh in world coordinates, for engines that know triangles only: what is
/// round has facets of 15 degrees, whose vertices are on the surface.
collision::TriangleMesh solid_triangles(const collision::World& world);

}  // namespace campuswalk::tools::bench

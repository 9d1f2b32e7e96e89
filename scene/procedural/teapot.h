#pragma once

#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::scene {

/// Newell's teapot, z up, centred on its bounding box, 8,680 triangles: 12 x 12 quads a patch, 11 x 13 on the
/// handle's patches and 9 x 10 on the spout's, two triangles a quad, less those that the patches' poles leave
/// without area. `fineness` multiplies the quads along each edge.
///
/// It isn't closed: lid and body don't meet, and handle and spout go through the body's wall.
collision::TriangleMesh teapot(int fineness = 1);

}  // namespace campuswalk::scene

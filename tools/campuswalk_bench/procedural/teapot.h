#pragma once

#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::tools::bench {

/// Newell's teapot, Z-up, centred, with 8,680 triangles: 12 x 12 quads per patch, 11 x 13 on the handle's
/// patches and 9 x 10 on the spout's, without degenerate triangles at the poles. `fineness` multiplies the
/// quads along each edge.
///
/// It isn't closed: there is a gap between lid and body, and handle and spout penetrate the body's wall.
collision::TriangleMesh teapot(int fineness = 1);

}  // namespace campuswalk::tools::bench

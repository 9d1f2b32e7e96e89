#pragma once

#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::support {

/// What a closed mesh that faces outward encloses, cubic metres: by the divergence theorem the sum of the
/// tetrahedra between its triangles and the origin. Negative for a mesh that is inside out.
double enclosed_volume(const collision::TriangleMesh& mesh);

}  // namespace campuswalk::support

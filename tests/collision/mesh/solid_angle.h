#pragma once

#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::collision {

/// How often a mesh winds around a point, by the solid angles of its triangles (van Oosterom and Strackee
/// 1983): 1 inside a closed part that faces outward, 0 outside. Casts no ray.
double winding_number(const TriangleMesh& mesh, const Eigen::Vector3d& point);

}  // namespace campuswalk::collision

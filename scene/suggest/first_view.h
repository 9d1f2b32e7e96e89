#pragma once

#include "collision/geometry/shapes.h"
#include "collision/mesh/mesh_collider.h"

namespace campuswalk::scene {

/// The initial yaw of a visitor at `foot`, radians, in steps of ten degrees: maximizes the free sight (up to
/// 15 m, the minimum of three adjacent directions) plus 10 m times the cosine of the angle to `target`.
double first_view(const collision::MeshCollider& mesh, const collision::Vec3& p_world_origin,
                  const collision::Vec3& foot, const collision::Vec3& target);

}  // namespace campuswalk::scene

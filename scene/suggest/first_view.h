#pragma once

#include "collision/geometry/shapes.h"
#include "collision/mesh/mesh_collider.h"

namespace campuswalk::scene {

/// The yaw, radians, in steps of ten degrees, under which somebody at `foot` sees farthest: 15 m free count
/// as much as free can be, ten degrees to the left and right as well, and what lies towards `target` is worth
/// ten metres more than what lies across.
double first_view(const collision::MeshCollider& mesh, const collision::Vec3& p_world_origin,
                  const collision::Vec3& foot, const collision::Vec3& target);

}  // namespace campuswalk::scene

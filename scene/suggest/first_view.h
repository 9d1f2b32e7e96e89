#pragma once

#include "collision/geometry/shapes.h"
#include "collision/world/world.h"

namespace campuswalk::scene {

/// The initial yaw of a visitor at `foot`, radians, in steps of ten degrees: maximizes the free sight (up to
/// 15 m, the minimum of three adjacent directions) plus 10 m times the cosine of the angle to `target`.
double first_view(const collision::World& world, const collision::Vec3& foot, const collision::Vec3& target);

}  // namespace campuswalk::scene

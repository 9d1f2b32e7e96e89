#pragma once

#include "collision/geometry/shapes.h"

namespace campuswalk::collision {

/// The axis-aligned bounds of a posed shape in the world, enlarged to cover rounding.
Aabb bounds_of(const Shape& shape, const Pose& X_world_shape);

}  // namespace campuswalk::collision

#pragma once

#include "collision/geometry/shapes.h"

namespace campuswalk::collision {

/// The world-space box of a posed shape, grown by rounding's worth.
Aabb bounds_of(const Shape& shape, const Pose& X_world_shape);

}  // namespace campuswalk::collision

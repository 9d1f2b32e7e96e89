#pragma once

#include "collision/geometry/shapes.h"
#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::collision {

/// Whether a triangle, in the box's frame, has a point in the filled box. Touching counts, up to the rounding
/// of double.
bool overlap(const Triangle& triangle, const Box& box);

}  // namespace campuswalk::collision

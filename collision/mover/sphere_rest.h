#pragma once

#include <optional>

#include "collision/geometry/shapes.h"
#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::collision {

/// A ball on top of something, world coordinates, metres.
struct SphereRest {
    double height = 0.0;     ///< y of the ball's centre
    Vec3 on = Vec3::Zero();  ///< where it touches
};

/// Where a ball of `radius` that comes straight down at (x, z) from far above stops on the triangle; none if
/// it passes beside it. `normal` is the face's, of either side, or zero. Edges that are upright but for a
/// hundred-thousandth count by their ends alone.
std::optional<SphereRest> sphere_rest(const Triangle& triangle, const Vec3& normal, double x, double z,
                                      double radius);

}  // namespace campuswalk::collision

#pragma once

#include <Eigen/Core>

#include "collision/geometry/shapes.h"

namespace campuswalk::collision {

// Exact signs for every finite input, whatever the coordinates' sizes: overflow, underflow and rounding never
// affect them. Needs the default rounding mode (to nearest).

/// The sign (-1, 0, 1) of det[a - d; b - d; c - d]: 0 if the points lie in a plane (no area, no volume), 1 if
/// a, b, c turn clockwise seen from d, that is, if d lies on the side that (b - a) x (c - a) points away
/// from. Swapping two points swaps the sign.
int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The sign of det[a - c; b - c]: 1 if a, b, c turn counter-clockwise, 0 if they lie on a line.
int orientation(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c);

}  // namespace campuswalk::collision

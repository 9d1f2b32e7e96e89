#pragma once

#include <optional>
#include <string>

#include "collision/geometry/shapes.h"

namespace campuswalk::tools::collide {

// Arguments of `campuswalk collide`. Lengths are in metres, angles in degrees. All of these functions throw
// scene::InputError with an example of what is expected.

/// A solid about the origin: `box:WIDTH,HEIGHT,DEPTH`, `sphere:RADIUS`, `capsule:RADIUS,HEIGHT` (upright,
/// caps included), `wheel:RADIUS,WIDTH` (its axle along X). Nullopt if the argument isn't meant as a shape
/// and names a file instead.
std::optional<collision::Shape> parse_shape(const std::string& argument);

/// `x,y,z[,yaw[,pitch[,roll]]]`: rolled about Z, then pitched about X, then yawed about Y, all through the
/// origin and right-handed, then translated.
collision::Pose parse_pose(const std::string& argument);

/// Twelve numbers: the rows of a rotation matrix, orthonormal to 1e-3, each followed by a component of the
/// translation. The matrix is used as given.
collision::Pose parse_pose_matrix(const std::string& argument);

}  // namespace campuswalk::tools::collide

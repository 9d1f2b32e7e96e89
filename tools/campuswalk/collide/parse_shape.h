#pragma once

#include <optional>
#include <string>

#include "collision/geometry/shapes.h"

namespace campuswalk::tools::collide {

/// What `campuswalk collide` takes in one word. Lengths in metres, angles in degrees. All of these throw
/// scene::InputError with an example of what is expected.

/// A solid about the origin: `box:WIDTH,HEIGHT,DEPTH`, `sphere:RADIUS`, `capsule:RADIUS,HEIGHT` (upright,
/// caps included), `wheel:RADIUS,WIDTH` (its axle along X). None if the word isn't meant as a shape: then it
/// is a file.
std::optional<collision::Shape> parse_shape(const std::string& word);

/// `x,y,z[,yaw[,pitch[,roll]]]`: rolled about Z, then pitched about X, then yawed about Y, all through the
/// origin and right-handed, then moved.
collision::Pose parse_pose(const std::string& word);

/// Twelve numbers, the rows of a matrix of a rotation (to 1e-3) and, as their fourth, the move. It is used
/// as it stands.
collision::Pose parse_pose_matrix(const std::string& word);

}  // namespace campuswalk::tools::collide

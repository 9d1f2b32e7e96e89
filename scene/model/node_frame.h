#pragma once

#include <Eigen/Core>

#include "collision/geometry/shapes.h"

namespace campuswalk::scene {

/// The frame that fitted shapes are measured in: the node's origin and its axes made orthonormal (scale,
/// shear and mirroring removed), renamed so that y is the axis nearest to up, pointing up. A bench turned on
/// the spot gives a turned box; an upright node has y up whether its file was written Z-up or Y-up.
collision::Pose upright_frame(const Eigen::Matrix4d& X_world_node);

/// Rotation about +Y by `yaw` radians, from + - * / alone: the same bits on every machine.
collision::Mat3 rotation_about_y(double yaw);

/// A rotation whose X axis is `axis` (any length but zero).
collision::Mat3 rotation_with_x_along(const collision::Vec3& axis);

}  // namespace campuswalk::scene

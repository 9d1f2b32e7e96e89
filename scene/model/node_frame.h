#pragma once

#include <Eigen/Core>

#include "collision/geometry/shapes.h"

namespace campuswalk::scene {

/// The frame in which shapes are fitted to a node: its origin and its orthonormalized axes (without scale,
/// shear and mirroring), permuted so that y is the axis nearest to the world's up. A bench with a yaw gives a
/// box with that yaw; a node that stands upright has y up, whether its file is Z-up or Y-up.
collision::Pose upright_frame(const Eigen::Matrix4d& X_world_node);

/// Rotation about +Y by `yaw` radians, the same bits on every machine.
collision::Mat3 rotation_about_y(double yaw);

/// Rotations about X, Y and Z by radians, as Rx * Ry * Rz: about Z first, or about the axes X, Y and Z that
/// turn along (the order XYZ of three.js). The same bits on every machine.
collision::Mat3 rotation_xyz(const collision::Vec3& angles);

/// A rotation that maps +X to the direction of `axis`, which is not zero.
collision::Mat3 rotation_with_x_along(const collision::Vec3& axis);

}  // namespace campuswalk::scene

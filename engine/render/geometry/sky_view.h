#pragma once

#include <Eigen/Core>

#include "engine/render/geometry/campus_geometry.h"

namespace campuswalk::engine::render {

/// Sky view factor at `eye` (campus frame), 0 to 1, occluded by opaque surfaces within 25 m: 1 in a field,
/// about 0.5 beside a tall wall, near 0 in a room. Computed on the CPU, so it doesn't depend on the driver.
double sky_view_factor(const CampusGeometry& geometry, const Eigen::Vector3d& eye);

}  // namespace campuswalk::engine::render

#pragma once

#include <Eigen/Core>

#include "engine/render/geometry/campus_geometry.h"

namespace campuswalk::engine::render {

/// The share of the sky's light that reaches `eye` (campus frame) past roofs and walls nearer than 25 m:
/// 1 in a field, about a half beside a tall wall, near 0 in a room. Glass and foliage don't count as cover.
/// Found on the processor, so that it is the same number whatever draws the image.
double open_sky(const CampusGeometry& geometry, const Eigen::Vector3d& eye);

}  // namespace campuswalk::engine::render

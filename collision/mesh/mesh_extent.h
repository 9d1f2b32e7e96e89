#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <Eigen/Core>

#include "collision/geometry/shapes.h"

namespace campuswalk::collision {

// The ranges of a mesh's indices and coordinates, checked before any is used. None of these loops exits
// early, so that compilers vectorize them.

/// 0 without triangles.
std::uint32_t highest_vertex(std::span<const std::array<std::uint32_t, 3>> triangles);

/// The greatest absolute coordinate; infinity if any is infinite or NaN.
float largest_coordinate(std::span<const Eigen::Vector3f> positions);

/// The bounds of positions that are finite.
Aabb box_of(std::span<const Eigen::Vector3f> positions);

}  // namespace campuswalk::collision

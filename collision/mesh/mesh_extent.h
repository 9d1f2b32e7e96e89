#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <Eigen/Core>

#include "collision/geometry/shapes.h"

namespace campuswalk::collision {

/// How far a mesh's numbers go: what must be known of millions of them before any is used. None of these has
/// a way out in the middle, so that compilers make lanes of them.

/// 0 without triangles.
std::uint32_t highest_vertex(std::span<const std::array<std::uint32_t, 3>> triangles);

/// The greatest coordinate without its sign; infinity if any is infinite or no number.
float largest_coordinate(std::span<const Eigen::Vector3f> positions);

/// Of positions that are finite.
Aabb box_of(std::span<const Eigen::Vector3f> positions);

}  // namespace campuswalk::collision

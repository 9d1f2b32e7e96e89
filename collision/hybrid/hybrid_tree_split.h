#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "collision/geometry/fitting.h"
#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::collision {

/// Each side of a split gets at least this part of the triangles, and at least one: the depth stays
/// logarithmic whatever the mesh.
inline constexpr std::size_t kLeastPart = 16;

/// Parts a node's triangles, two or more, between its two children: reorders them and returns how many go to
/// the left.
///
/// A child is met about as often as its surface is large, and costs as many tests as it has triangles. So the
/// cut is made across one of the box's axes where the sum over both sides of triangles times surface is the
/// least (Goldsmith, Salmon, "Automatic creation of object hierarchies for ray tracing", 1987), the surface
/// being that of the side's bounds along the box's axes. Where no cut gains anything, as among triangles on
/// one line, the triangles are halved by count.
std::size_t split(const TriangleMesh& mesh, std::span<std::uint32_t> triangles, const OrientedBox& box);

}  // namespace campuswalk::collision

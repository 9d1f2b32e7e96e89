#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "collision/geometry/fitting.h"
#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::collision {

/// Each side of a split gets at least one in so many of the triangles, and at least one triangle: the depth
/// stays logarithmic for every mesh.
inline constexpr std::size_t kMinSideDivisor = 16;

/// Divides a node's triangles, at least two, between its two children: reorders them and returns how many go
/// to the left one.
///
/// The surface-area heuristic (Goldsmith, Salmon, "Automatic creation of object hierarchies for ray tracing",
/// 1987): queries reach a child about in proportion to its surface area, and it costs as many tests as it has
/// triangles. So the cut is made across the box's axis, and at the place, where the sum of triangles times
/// surface area over both sides is least; the area is that of the side's bounds along the box's axes. If no
/// cut gains anything, as among triangles on one line, each side gets half of the triangles.
std::size_t split(const TriangleMesh& mesh, std::span<std::uint32_t> triangles, const OrientedBox& box);

}  // namespace campuswalk::collision

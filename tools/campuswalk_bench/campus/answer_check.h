#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "collision/geometry/ray.h"
#include "collision/geometry/shapes.h"
#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::tools::bench {

// Whether answers of engines that compute in float32, or with a tolerance, equal ours up to rounding. Where
// they don't, the answers are checked against all triangles one by one, without a tree.

/// Compares fractions of a ray, where none is a hit beyond its end. Hits less than 1 mm apart are the same.
bool same_hit(const collision::Ray& ray, std::optional<double> a, std::optional<double> b);

/// Whether `fraction` is the first hit of the ray or of one 0.1 mm beside it, within 1 mm plus the distance
/// along the ray that 0.1 mm sideways amount to at the surface's slant: float32 rounds by 0.03 mm at 250 m.
bool is_first_hit(const collision::TriangleMesh& mesh, const collision::Ray& ray,
                  std::optional<double> fraction);

/// Whether the triangles, ascending, are those at most `radius` from the segment. Triangles within 1 um of
/// that distance may be missing or not.
bool is_touching_set(const collision::TriangleMesh& mesh, const collision::Segment& segment, double radius,
                     const std::vector<std::uint32_t>& triangles);

}  // namespace campuswalk::tools::bench

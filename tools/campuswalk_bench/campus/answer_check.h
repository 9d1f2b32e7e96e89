#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "collision/geometry/ray.h"
#include "collision/geometry/shapes.h"
#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::tools::bench {

// Whether answers of engines that compute in float32, or with a tolerance, are those of ours but for
// rounding. Where they aren't, all triangles are asked one by one, without a tree.

/// Fractions of the same ray; none is a hit beyond its end. The same are hits less than 1 mm apart.
bool same_hit(const collision::Ray& ray, std::optional<double> a, std::optional<double> b);

/// Whether `fraction` is the first hit of the ray or of one 0.1 mm beside it, within 1 mm and what 0.1 mm
/// sideways make at the surface's slant: float32 rounds by 0.03 mm at 250 m.
bool is_first_hit(const collision::TriangleMesh& mesh, const collision::Ray& ray,
                  std::optional<double> fraction);

/// Whether the triangles, ascending, are those no farther than `radius` from the segment. One whose distance
/// is within 1 um of it may be there or not.
bool is_touching_set(const collision::TriangleMesh& mesh, const collision::Segment& segment, double radius,
                     const std::vector<std::uint32_t>& triangles);

}  // namespace campuswalk::tools::bench

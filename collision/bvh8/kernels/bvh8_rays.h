#pragma once

#include <cstdint>

#include "collision/base/function_ref.h"
#include "collision/base/query_statistics.h"
#include "collision/base/simd_target.h"
#include "collision/bvh8/bvh8.h"
#include "collision/geometry/ray.h"

namespace campuswalk::collision {

/// `visit(index, vertices, limit)` returns the fraction above which nothing interests the query any more.
using RayVisitor = FunctionRef<double(std::uint32_t, const Triangle&, double)>;

/// Whether the ray has a length and fits float32: neither a product of two of its coordinates overflows, nor
/// one with the inverse of a direction's component (at most 2^24).
bool fits_bvh8_rays(const Ray& ray);

/// Calls `visit` for all triangles that `hit` (ray.h) may find up to the limit, initially 1, and for few
/// others; near parts of the tree first. Which triangles, and their order, is the same for every
/// `simd_target`. Adds the boxes and triangles tested to `work`. The ray must fit.
void trace_bvh8_ray(const TriangleMesh& mesh, const Bvh8& tree, const Ray& ray, SimdTarget simd_target,
                    const RayVisitor& visit, QueryStatistics& work);

}  // namespace campuswalk::collision

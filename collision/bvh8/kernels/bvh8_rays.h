#pragma once

#include <cstdint>

#include "collision/base/query_statistics.h"
#include "collision/base/simd_target.h"
#include "collision/bvh8/bvh8.h"
#include "collision/geometry/ray.h"

namespace campuswalk::collision {

/// What a query does with a triangle: `meet(index, corners, limit)` answers the fraction above which nothing
/// interests it any more. Refers to the function it is made from.
class RayVisitor {
public:
    template <typename Meet>
    explicit RayVisitor(const Meet& meet)
        : meet_(&meet),
          call_([](const void* to, std::uint32_t index, const Triangle& triangle, double limit) {
              return (*static_cast<const Meet*>(to))(index, triangle, limit);
          }) {}

    double operator()(std::uint32_t index, const Triangle& triangle, double limit) const {
        return call_(meet_, index, triangle, limit);
    }

private:
    const void* meet_;
    double (*call_)(const void*, std::uint32_t, const Triangle&, double);
};

/// Whether float32 has room for the ray: it goes somewhere, and neither a product of two of its coordinates
/// nor one with the inverse of its steepness (2^24 at most) overflows.
bool fits_bvh8_rays(const Ray& ray);

/// Hands `meet` all triangles that `hit` (ray.h) may see up to the limit, 1 at first, and few others; near
/// parts of the tree first. Which ones, and their order, is the same with all instructions. Adds to
/// `work` the boxes and triangles that it tests. The ray fits.
void trace_bvh8_ray(const TriangleMesh& mesh, const Bvh8& tree, const Ray& ray, SimdTarget simd_target,
                    const RayVisitor& meet, QueryStatistics& work);

}  // namespace campuswalk::collision

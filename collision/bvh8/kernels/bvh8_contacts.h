#pragma once

#include <cstdint>
#include <vector>

#include "collision/base/query_statistics.h"
#include "collision/base/simd_target.h"
#include "collision/bvh8/bvh8.h"
#include "collision/geometry/triangle_mesh.h"
#include "collision/geometry/triangle_pair.h"

namespace campuswalk::collision {

/// Two meshes with BVH8s, and their relative pose. The pose is finite, and `tilt` is how far its matrix is
/// from a rotation: the greatest entry of |R R^T - 1|, far below 1.
struct Bvh8Pair {
    const TriangleMesh& mesh_a;
    const TriangleMesh& mesh_b;
    const Bvh8& a;
    const Bvh8& b;
    const Pose& X_a_b;
    double tilt = 0.0;
};

enum class SearchMode : std::uint8_t { all, first };

/// Adds the overlapping pairs to `out`: all, or those of the first two leaves with any. The outer spheres
/// must overlap, so that distances are no greater than the meshes. See mesh_contacts.h.
void find_bvh8_contacts(const Bvh8Pair& pair, SearchMode mode, SimdTarget simd_target,
                        std::vector<TrianglePair>& out, QueryStatistics& work);

}  // namespace campuswalk::collision

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "collision/counters.h"
#include "collision/mesh_collider.h"
#include "collision/ray.h"
#include "collision/shapes.h"

namespace campuswalk::collision {

/// Queries of one mesh, in the mesh's frame. A node is tested as in the paper: the outer spheres by eq. (1),
/// then the inner layers (each body's sphere against the other's box, three axes each way, then box against
/// box), then the triangles. Each node visited counts one in Nv, each triangle one in Np; a query body that
/// is moved into the mesh's frame counts one in Nu.

/// Replaces `out` by the triangles no farther than `radius` from the segment, ascending.
void triangles_near(const MeshCollider& mesh, const Segment& segment, double radius,
                    std::vector<std::uint32_t>& out, QueryCounters& counters);

struct MeshRayHit {
    double fraction = 0.0;
    std::uint32_t triangle = 0;
};

/// The first triangle on the ray; of several at one fraction, the lowest index.
std::optional<MeshRayHit> first_on_ray(const MeshCollider& mesh, const Ray& ray, QueryCounters& counters);

}  // namespace campuswalk::collision

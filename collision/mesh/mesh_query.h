#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "collision/base/query_counters.h"
#include "collision/base/simd_target.h"
#include "collision/geometry/ray.h"
#include "collision/geometry/shapes.h"
#include "collision/mesh/mesh_collider.h"

namespace campuswalk::collision {

/// Queries of one mesh, in the mesh's frame, metres. Triangles are surfaces, met from both sides. Answers are
/// those of a loop over all triangles with `closest` (closest.h) or `hit` (ray.h), whatever the tree's
/// layout; a warm query allocates nothing. Coordinates are finite.
///
/// Where rounding leaves open whether a ray passes a triangle, edge-on or of hardly any area, `hit` may see
/// it where it is not, and such a hit counts only if the tree's boxes are met as well.
///
/// SimdTarget matter to rays on the wide layout alone: to how fast they are, not to answers nor counters.
///
/// Counters. nv: bounding volumes tested, on the paper's layout a node each, on the wide layout the mesh's
/// sphere and each child's box of the nodes that were opened. np: triangles tested, on the wide layout those
/// that their own boxes left open, or for a ray their edges in float32. nu: 1, the query body that is moved
/// into the mesh's frame.

/// Replaces `out` by the triangles no farther than `radius` from the segment, ascending.
void triangles_near(const MeshCollider& mesh, const Segment& segment, double radius,
                    std::vector<std::uint32_t>& out, QueryCounters& counters);

/// `fraction` of the ray or of the move, 0 at its start.
struct MeshHit {
    double fraction = 0.0;
    std::uint32_t triangle = 0;

    friend bool operator==(const MeshHit&, const MeshHit&) = default;
};

/// The first triangle on the ray; of several at one fraction, the lowest index.
std::optional<MeshHit> first_on_ray(const MeshCollider& mesh, const Ray& ray, QueryCounters& counters,
                                    SimdTarget simd_target = default_simd_target());

/// Whether there is a triangle on the ray.
bool any_on_ray(const MeshCollider& mesh, const Ray& ray, QueryCounters& counters,
                SimdTarget simd_target = default_simd_target());

/// Replaces `out` by all triangles on the ray, ascending by fraction, then by index.
void all_on_ray(const MeshCollider& mesh, const Ray& ray, std::vector<MeshHit>& out, QueryCounters& counters,
                SimdTarget simd_target = default_simd_target());

/// Is the point inside a closed part of the mesh (closed_parts.h)? By the winding number along one fixed
/// direction.
bool is_inside(const MeshCollider& mesh, const Vec3& point, QueryCounters& counters,
               SimdTarget simd_target = default_simd_target());

/// Replaces `out` by the triangles that have a point in the filled box (see triangle_box_overlap.h),
/// ascending. X_mesh_box is a rotation and a shift.
void triangles_in_box(const MeshCollider& mesh, const Box& box, const Pose& X_mesh_box,
                      std::vector<std::uint32_t>& out, QueryCounters& counters);

struct MeshPoint {
    Vec3 point = Vec3::Zero();
    double distance = 0.0;
    std::uint32_t triangle = 0;
};

/// The mesh's closest point; of several triangles at one distance, on that of the lowest index.
MeshPoint closest_point(const MeshCollider& mesh, const Vec3& point, QueryCounters& counters);

/// The first triangle that a capsule of `radius` about `segment` touches on its way along `move`; of several
/// at one fraction, the lowest index. Like `first_touch` (sweep.h): triangles that the capsule only moves
/// away from don't count, and the fraction is never too large.
std::optional<MeshHit> sweep(const MeshCollider& mesh, const Segment& segment, double radius,
                             const Vec3& move, QueryCounters& counters);

}  // namespace campuswalk::collision

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "collision/base/function_ref.h"
#include "collision/base/query_statistics.h"
#include "collision/base/simd_target.h"
#include "collision/geometry/ray.h"
#include "collision/geometry/shapes.h"
#include "collision/mesh/mesh_collider.h"

namespace campuswalk::collision {

// Queries of one mesh with either kind of tree, in the mesh's frame, metres. Triangles are two-sided
// surfaces. Results are those of a loop over all triangles with `closest` (closest.h) or `hit` (ray.h), bit
// for bit; a warm query allocates nothing. Coordinates must be finite.
//
// Where rounding leaves open whether a ray hits a triangle, edge-on or of almost no area, `hit` may find a
// hit beside the triangle; such a hit counts only if the ray also hits the tree's boxes.
//
// `simd_target` affects only rays in the BVH8: their speed, not their results or statistics.
//
// Statistics. In the hybrid tree, a volume test is one node: its outer sphere, then its inner layer if the
// sphere leaves it open. In the BVH8, it is the mesh's sphere and each child's box of the nodes opened; a
// triangle in a leaf counts if its own box, or for a ray its edges in float32, leave it open. One transform
// is updated: that of the query into the mesh's frame.

/// Replaces `out` by the triangles no farther than `radius` from the segment, ascending.
void triangles_near(const MeshCollider& mesh, const Segment& segment, double radius,
                    std::vector<std::uint32_t>& out, QueryStatistics* statistics = nullptr);

struct MeshHit {
    double fraction = 0.0;  ///< of the ray or the move, 0 at its start
    std::uint32_t triangle = 0;

    friend bool operator==(const MeshHit&, const MeshHit&) = default;
};

/// The first triangle on the ray; of several at one fraction, that with the lowest index.
std::optional<MeshHit> first_on_ray(const MeshCollider& mesh, const Ray& ray,
                                    QueryStatistics* statistics = nullptr,
                                    SimdTarget simd_target = default_simd_target());

/// Whether there is a triangle on the ray.
bool any_on_ray(const MeshCollider& mesh, const Ray& ray, QueryStatistics* statistics = nullptr,
                SimdTarget simd_target = default_simd_target());

/// Replaces `out` by all triangles on the ray, ascending by fraction, then by index.
void all_on_ray(const MeshCollider& mesh, const Ray& ray, std::vector<MeshHit>& out,
                QueryStatistics* statistics = nullptr, SimdTarget simd_target = default_simd_target());

/// Whether the point is inside a closed part of the mesh (closed_parts.h), by the winding number along a
/// fixed direction.
bool is_inside(const MeshCollider& mesh, const Vec3& point, QueryStatistics* statistics = nullptr,
               SimdTarget simd_target = default_simd_target());

/// Replaces `out` by the triangles that have a point in the filled box (see triangle_box_overlap.h),
/// ascending. X_mesh_box is a rotation and a translation.
void triangles_in_box(const MeshCollider& mesh, const Box& box, const Pose& X_mesh_box,
                      std::vector<std::uint32_t>& out, QueryStatistics* statistics = nullptr);

/// Whether there is such a triangle.
bool any_in_box(const MeshCollider& mesh, const Box& box, const Pose& X_mesh_box,
                QueryStatistics* statistics = nullptr);

struct MeshPoint {
    Vec3 point = Vec3::Zero();
    double distance = 0.0;
    std::uint32_t triangle = 0;
};

/// The mesh's closest point; of several triangles at one distance, on that with the lowest index.
MeshPoint closest_point(const MeshCollider& mesh, const Vec3& point, QueryStatistics* statistics = nullptr);

/// The first triangle that a capsule of `radius` about `segment` touches during `move`; of several at one
/// fraction, that with the lowest index. Like `first_touch` (sweep.h): triangles that the capsule only moves
/// away from don't count, and the fraction is never too large.
std::optional<MeshHit> sweep(const MeshCollider& mesh, const Segment& segment, double radius,
                             const Vec3& move, QueryStatistics* statistics = nullptr);

/// `visit(index, vertices)`.
using TriangleVisitor = FunctionRef<void(std::uint32_t, const Triangle&)>;

/// Calls `visit` once for each triangle that reaches into `region` and out of `known`, in any order, and for
/// some others nearby. Both boxes are in world coordinates.
void visit_triangles_beyond(const MeshCollider& mesh, const Pose& X_world_mesh, const Aabb& known,
                            const Aabb& region, TriangleVisitor visit, QueryStatistics* statistics = nullptr);

}  // namespace campuswalk::collision

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "collision/base/query_statistics.h"
#include "collision/base/simd_target.h"
#include "collision/geometry/ray.h"
#include "collision/geometry/shapes.h"
#include "collision/mesh/mesh_collider.h"

namespace campuswalk::collision {

/// Queries of one mesh, in the mesh's frame, metres: the door to its tree, whichever it has. Triangles are
/// surfaces, met from both sides. Answers are those of a loop over all triangles with `closest` (closest.h)
/// or `hit` (ray.h), to the bit; a warm query allocates nothing. Coordinates are finite.
///
/// Where rounding leaves open whether a ray passes a triangle, edge-on or of hardly any area, `hit` may see
/// it where it is not, and such a hit counts only if the tree's boxes are met as well.
///
/// SimdTarget matter to rays in the BVH8 alone: to how fast they are, not to answers nor statistics.
///
/// Statistics. In the hybrid tree a volume test is one node: its outer sphere, then its inner layer if the
/// sphere leaves it open. In the BVH8 it is the mesh's sphere, and each child's box of the nodes that were
/// opened. A triangle in a leaf of the BVH8 counts where its own box left it open, or for a ray its edges in
/// float32. One transform is updated: that of what is asked for, into the mesh's frame.

/// Replaces `out` by the triangles no farther than `radius` from the segment, ascending.
void triangles_near(const MeshCollider& mesh, const Segment& segment, double radius,
                    std::vector<std::uint32_t>& out, QueryStatistics* statistics = nullptr);

/// `fraction` of the ray or of the move, 0 at its start.
struct MeshHit {
    double fraction = 0.0;
    std::uint32_t triangle = 0;

    friend bool operator==(const MeshHit&, const MeshHit&) = default;
};

/// The first triangle on the ray; of several at one fraction, the lowest index.
std::optional<MeshHit> first_on_ray(const MeshCollider& mesh, const Ray& ray,
                                    QueryStatistics* statistics = nullptr,
                                    SimdTarget simd_target = default_simd_target());

/// Whether there is a triangle on the ray.
bool any_on_ray(const MeshCollider& mesh, const Ray& ray, QueryStatistics* statistics = nullptr,
                SimdTarget simd_target = default_simd_target());

/// Replaces `out` by all triangles on the ray, ascending by fraction, then by index.
void all_on_ray(const MeshCollider& mesh, const Ray& ray, std::vector<MeshHit>& out,
                QueryStatistics* statistics = nullptr, SimdTarget simd_target = default_simd_target());

/// Is the point inside a closed part of the mesh (closed_parts.h)? By the winding number along one fixed
/// direction.
bool is_inside(const MeshCollider& mesh, const Vec3& point, QueryStatistics* statistics = nullptr,
               SimdTarget simd_target = default_simd_target());

/// Replaces `out` by the triangles that have a point in the filled box (see triangle_box_overlap.h),
/// ascending. X_mesh_box is a rotation and a shift.
void triangles_in_box(const MeshCollider& mesh, const Box& box, const Pose& X_mesh_box,
                      std::vector<std::uint32_t>& out, QueryStatistics* statistics = nullptr);

struct MeshPoint {
    Vec3 point = Vec3::Zero();
    double distance = 0.0;
    std::uint32_t triangle = 0;
};

/// The mesh's closest point; of several triangles at one distance, on that of the lowest index.
MeshPoint closest_point(const MeshCollider& mesh, const Vec3& point, QueryStatistics* statistics = nullptr);

/// The first triangle that a capsule of `radius` about `segment` touches on its way along `move`; of several
/// at one fraction, the lowest index. Like `first_touch` (sweep.h): triangles that the capsule only moves
/// away from don't count, and the fraction is never too large.
std::optional<MeshHit> sweep(const MeshCollider& mesh, const Segment& segment, double radius,
                             const Vec3& move, QueryStatistics* statistics = nullptr);

/// Refers to a function `visit(index, corners)` for as long as a call lasts.
class TriangleVisitor {
public:
    template <typename Visit>
    TriangleVisitor(const Visit& visit)
        : visit_(&visit), call_([](const void* to, std::uint32_t index, const Triangle& vertices) {
              (*static_cast<const Visit*>(to))(index, vertices);
          }) {}

    void operator()(std::uint32_t index, const Triangle& vertices) const { call_(visit_, index, vertices); }

private:
    const void* visit_;
    void (*call_)(const void*, std::uint32_t, const Triangle&);
};

/// Hands `visit` all triangles that reach into `region` and out of `known`, once each, in any order, and some
/// others near by. Both boxes are in the world, where the mesh is at X_world_mesh.
void visit_triangles_beyond(const MeshCollider& mesh, const Pose& X_world_mesh, const Aabb& known,
                            const Aabb& region, TriangleVisitor visit, QueryStatistics* statistics = nullptr);

}  // namespace campuswalk::collision

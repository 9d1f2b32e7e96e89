#include "collision/mesh/mesh_query.h"

#include <algorithm>
#include <limits>

#include "collision/bvh8/kernels/bvh8_rays.h"
#include "collision/geometry/closest.h"
#include "collision/geometry/sweep.h"
#include "collision/geometry/triangle_box_overlap.h"
#include "collision/mesh/query_volumes.h"
#include "collision/mesh/tree_traversal.h"

namespace campuswalk::collision {

namespace {

/// A limit below that of every volume: a query that has its answer looks no farther.
constexpr double kNoMore = -1.0;

Triangle in_frame(const Pose& X, const Triangle& t) {
    return {X.inverse_apply(t.a), X.inverse_apply(t.b), X.inverse_apply(t.c)};
}

bool before(const MeshHit& a, const MeshHit& b) {
    return a.fraction != b.fraction ? a.fraction < b.fraction : a.triangle < b.triangle;
}

/// Retains the earlier hit and returns how far the query still has to look.
double offer(std::optional<MeshHit>& best, const MeshHit& found) {
    if (!best || before(found, *best)) {
        best = found;
    }
    return best->fraction;
}

/// Calls `visit` for the triangles that may be on the ray up to the limit, near ones first.
template <typename Visit>
void follow(const MeshCollider& mesh, const Ray& ray, const Visit& visit, QueryStatistics* statistics,
            SimdTarget simd_target) {
    const PathVolume path(ray);
    if (mesh.tree_kind() == TreeKind::hybrid || !fits_bvh8_rays(ray)) {
        const auto visit_mesh_triangle = [&](std::uint32_t t, double limit) {
            return visit(t, vertices(mesh.mesh(), t), limit);
        };
        traverse(mesh, path, 1.0, visit_mesh_triangle, statistics);
        return;
    }
    QueryStatistics work{.transform_updates = 1, .sphere_tests = 1};
    if (path.bound(mesh.bvh8().outer) <= 1.0) {
        trace_bvh8_ray(mesh.mesh(), mesh.bvh8(), ray, simd_target, RayVisitor(visit), work);
    }
    work.volume_tests = work.sphere_tests + work.box_tests;
    add_to(statistics, work);
}

/// Visits every triangle of a traversal, with the vertices from a BVH8 leaf where there is one.
class VisitAll {
public:
    VisitAll(const TriangleMesh& mesh, TriangleVisitor visit) : mesh_(mesh), visit_(visit) {}

    double operator()(std::uint32_t triangle, double limit) const {
        visit_(triangle, vertices(mesh_, triangle));
        return limit;
    }
    double operator()(const Bvh8Leaf& leaf, std::size_t slot, double limit) const {
        visit_(leaf.triangle[slot], vertices(mesh_, leaf, slot));
        return limit;
    }

private:
    const TriangleMesh& mesh_;
    TriangleVisitor visit_;
};

}  // namespace

void triangles_near(const MeshCollider& mesh, const Segment& segment, double radius,
                    std::vector<std::uint32_t>& out, QueryStatistics* statistics) {
    out.clear();
    const auto visit = [&](std::uint32_t t, double limit) {
        if (closest(segment, vertices(mesh.mesh(), t)).distance <= radius) {
            out.push_back(t);
        }
        return limit;
    };
    traverse(mesh, ThickSegment(segment, radius), radius * radius, visit, statistics);
    std::sort(out.begin(), out.end());
}

void triangles_in_box(const MeshCollider& mesh, const Box& box, const Pose& X_mesh_box,
                      std::vector<std::uint32_t>& out, QueryStatistics* statistics) {
    out.clear();
    const auto visit = [&](std::uint32_t t, double limit) {
        if (overlap(in_frame(X_mesh_box, vertices(mesh.mesh(), t)), box)) {
            out.push_back(t);
        }
        return limit;
    };
    traverse(mesh, BoxVolume(box, X_mesh_box), 0.0, visit, statistics);
    std::sort(out.begin(), out.end());
}

bool any_in_box(const MeshCollider& mesh, const Box& box, const Pose& X_mesh_box,
                QueryStatistics* statistics) {
    bool found = false;
    const auto visit = [&](std::uint32_t t, double limit) {
        found = found || overlap(in_frame(X_mesh_box, vertices(mesh.mesh(), t)), box);
        return found ? kNoMore : limit;
    };
    traverse(mesh, BoxVolume(box, X_mesh_box), 0.0, visit, statistics);
    return found;
}

std::optional<MeshHit> first_on_ray(const MeshCollider& mesh, const Ray& ray, QueryStatistics* statistics,
                                    SimdTarget simd_target) {
    std::optional<MeshHit> best;
    const auto visit = [&](std::uint32_t t, const Triangle& triangle, double limit) {
        const auto f = hit(ray, triangle);
        return f ? offer(best, {*f, t}) : limit;
    };
    follow(mesh, ray, visit, statistics, simd_target);
    return best;
}

bool any_on_ray(const MeshCollider& mesh, const Ray& ray, QueryStatistics* statistics,
                SimdTarget simd_target) {
    bool found = false;
    const auto visit = [&](std::uint32_t, const Triangle& triangle, double limit) {
        found = found || hit(ray, triangle).has_value();
        return found ? kNoMore : limit;
    };
    follow(mesh, ray, visit, statistics, simd_target);
    return found;
}

void all_on_ray(const MeshCollider& mesh, const Ray& ray, std::vector<MeshHit>& out,
                QueryStatistics* statistics, SimdTarget simd_target) {
    out.clear();
    const auto visit = [&](std::uint32_t t, const Triangle& triangle, double limit) {
        if (const auto f = hit(ray, triangle)) {
            out.push_back({*f, t});
        }
        return limit;
    };
    follow(mesh, ray, visit, statistics, simd_target);
    std::sort(out.begin(), out.end(), before);
}

bool is_inside(const MeshCollider& mesh, const Vec3& point, QueryStatistics* statistics,
               SimdTarget simd_target) {
    // An arbitrary direction, so that edges and vertices of upright geometry are unlikely to lie on it.
    const Vec3 direction(0.5377, 0.7389, 0.4061);
    const ClosedParts& parts = mesh.closed_parts();
    const Aabb& box = parts.bounds();
    if (parts.empty() || !box.overlaps({point, point})) {
        return false;
    }
    const Ray ray{point, point + 2.0 * (box.max - box.min).norm() * direction};
    int winding = 0;
    const auto visit = [&](std::uint32_t t, const Triangle& triangle, double limit) {
        if (parts.has(t) && hit(ray, triangle)) {
            const Vec3 normal = (triangle.b - triangle.a).cross(triangle.c - triangle.a);
            winding += normal.dot(direction) > 0.0 ? 1 : -1;
        }
        return limit;
    };
    follow(mesh, ray, visit, statistics, simd_target);
    return winding > 0;
}

MeshPoint closest_point(const MeshCollider& mesh, const Vec3& point, QueryStatistics* statistics) {
    MeshPoint best;
    best.distance = std::numeric_limits<double>::infinity();
    const auto visit = [&](std::uint32_t t, double) {
        const Closest c = closest(Segment{point, point}, vertices(mesh.mesh(), t));
        if (c.distance < best.distance || (c.distance == best.distance && t < best.triangle)) {
            best = {c.on_shape, c.distance, t};
        }
        return best.distance * best.distance;
    };
    traverse(mesh, PointVolume(point), kApart<double>, visit, statistics);
    return best;
}

std::optional<MeshHit> sweep(const MeshCollider& mesh, const Segment& segment, double radius,
                             const Vec3& move, QueryStatistics* statistics) {
    std::optional<MeshHit> best;
    const auto visit = [&](std::uint32_t t, double limit) {
        const Triangle triangle = vertices(mesh.mesh(), t);
        const auto f = first_touch(segment, radius, move,
                                   [&](const Segment& moved) { return closest(moved, triangle); });
        return f ? offer(best, {*f, t}) : limit;
    };
    traverse(mesh, PathVolume(segment, radius + kTouching, move), 1.0, visit, statistics);
    return best;
}

void visit_triangles_beyond(const MeshCollider& mesh, const Pose& X_world_mesh, const Aabb& known,
                            const Aabb& region, TriangleVisitor visit, QueryStatistics* statistics) {
    traverse(mesh, BoxWithHole(known, region, X_world_mesh), 0.0, VisitAll(mesh.mesh(), visit), statistics);
}

}  // namespace campuswalk::collision

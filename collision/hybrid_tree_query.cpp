#include "collision/hybrid_tree_query.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "collision/closest.h"

namespace campuswalk::collision {

namespace {

/// Depth-first traversal with a fixed stack: the build keeps every child below 15/16 of its parent, so that
/// 2^32 triangles stay below this depth.
constexpr std::size_t kStack = 512;

/// Visits leaves whose chain of nodes passes `enter`, left child first.
template <typename Enter, typename VisitLeaf>
void traverse(const HybridTree& tree, QueryCounters& counters, const Enter& enter,
              const VisitLeaf& visit_leaf) {
    std::array<std::uint32_t, kStack> stack;
    std::size_t depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
        const HybridNode& node = tree.nodes[stack[--depth]];
        ++counters.nv;
        if (!enter(node)) {
            continue;
        }
        if (node.is_leaf()) {
            visit_leaf(node);
        } else {
            stack[depth++] = node.first + 1;
            stack[depth++] = node.first;
        }
    }
}

/// The query body's own two layers: a thick segment in a sphere and in a box.
struct QueryBody {
    BoundingSphere outer;
    OrientedBox inner;

    QueryBody(const Segment& s, double radius) {
        const Vec3 along = s.b - s.a;
        const double length = along.norm();
        outer = {0.5 * (s.a + s.b), 0.5 * length + radius};
        inner.center = outer.center;
        inner.radius = outer.radius;
        if (length > 0.0) {
            inner.axes.col(0) = along / length;
            inner.axes.col(1) = inner.axes.col(0).unitOrthogonal();
            inner.axes.col(2) = inner.axes.col(0).cross(inner.axes.col(1));
        }
        inner.half_extents = Vec3(outer.radius, radius, radius);
    }
};

/// Eq. (1): |c1 - c2| <= r1 + r2.
bool spheres_meet(const Vec3& c1, double r1, const Vec3& c2, double r2) {
    const double reach = r1 + r2;
    return (c1 - c2).squaredNorm() <= reach * reach;
}

/// Three axes: does the sphere reach into the slabs of the box?
bool sphere_meets_box(const Vec3& center, double radius, const OrientedBox& box) {
    const Vec3 local = box.axes.transpose() * (center - box.center);
    return (local.cwiseAbs().array() <= box.half_extents.array() + radius).all();
}

/// The six face axes of two boxes. The nine edge axes reject little more against a thin query body.
bool boxes_meet(const OrientedBox& a, const OrientedBox& b) {
    const Mat3 r = a.axes.transpose() * b.axes;
    const Vec3 t = a.axes.transpose() * (b.center - a.center);
    const Mat3 abs_r = r.cwiseAbs().array() + 1e-12;
    if ((t.cwiseAbs().array() > (a.half_extents + abs_r * b.half_extents).array()).any()) {
        return false;
    }
    const Vec3 t_b = r.transpose() * t;
    return (t_b.cwiseAbs().array() <= (b.half_extents + abs_r.transpose() * a.half_extents).array()).all();
}

bool meets(const HybridNode& node, const QueryBody& body) {
    return spheres_meet(node.outer.center, node.outer.radius, body.outer.center, body.outer.radius) &&
           sphere_meets_box(body.inner.center, body.inner.radius, node.inner) &&
           sphere_meets_box(node.inner.center, node.inner.radius, body.inner) &&
           boxes_meet(node.inner, body.inner);
}

bool ray_meets_sphere(const Ray& ray, const BoundingSphere& sphere, double limit) {
    const Vec3 near = closest_on_segment({ray.from, ray.at(limit)}, sphere.center);
    return (near - sphere.center).squaredNorm() <= sphere.radius * sphere.radius;
}

bool ray_meets_box(const Ray& ray, const OrientedBox& box, double limit) {
    const Ray local{box.axes.transpose() * (ray.from - box.center),
                    box.axes.transpose() * (ray.at(limit) - box.center)};
    return hit(local, Box{box.half_extents}).has_value();
}

}  // namespace

void triangles_near(const MeshCollider& mesh, const Segment& segment, double radius,
                    std::vector<std::uint32_t>& out, QueryCounters& counters) {
    out.clear();
    ++counters.nu;
    const QueryBody body(segment, radius);
    traverse(
        mesh.tree(), counters, [&](const HybridNode& node) { return meets(node, body); },
        [&](const HybridNode& leaf) {
            for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
                const std::uint32_t t = mesh.tree().order[i];
                ++counters.np;
                if (closest(segment, corners(mesh.mesh(), t)).distance <= radius) {
                    out.push_back(t);
                }
            }
        });
    std::sort(out.begin(), out.end());
}

std::optional<MeshRayHit> first_on_ray(const MeshCollider& mesh, const Ray& ray, QueryCounters& counters) {
    // A bound may be cut by rounding exactly where the best hit lies: look a hair past it.
    constexpr double kPast = 1e-9;
    ++counters.nu;
    std::optional<MeshRayHit> best;
    double limit = 1.0;
    traverse(
        mesh.tree(), counters,
        [&](const HybridNode& node) {
            return ray_meets_sphere(ray, node.outer, limit) && ray_meets_box(ray, node.inner, limit);
        },
        [&](const HybridNode& leaf) {
            for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
                const std::uint32_t t = mesh.tree().order[i];
                ++counters.np;
                const std::optional<double> f = hit(ray, corners(mesh.mesh(), t));
                if (f && (!best || *f < best->fraction || (*f == best->fraction && t < best->triangle))) {
                    best = MeshRayHit{*f, t};
                    limit = std::min(1.0, *f + kPast);
                }
            }
        });
    return best;
}

}  // namespace campuswalk::collision

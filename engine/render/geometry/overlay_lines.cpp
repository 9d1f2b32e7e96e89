#include "engine/render/geometry/overlay_lines.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <tuple>

#include <Eigen/Geometry>

#include "collision/mesh/mesh_collider.h"
#include "collision/mesh/tree_level.h"

namespace campuswalk::engine::render {
namespace {

using collision::Aabb;
using collision::Detection;
using collision::Pose;
using Eigen::Vector3d;
using LineColor = std::array<float, 3>;

constexpr LineColor kSolid = {0.02F, 0.55F, 0.95F};
constexpr LineColor kRayTarget = {0.75F, 0.10F, 0.85F};  // ray targets that are not solid
constexpr LineColor kTrigger = {1.0F, 0.45F, 0.02F};
constexpr LineColor kPath = {1.0F, 0.60F, 0.02F};
constexpr LineColor kContact = {1.0F, 0.02F, 0.02F};
constexpr LineColor kTree = {0.05F, 0.85F, 0.10F};

constexpr double kMaxFlatCosine = 0.93969262;  // cosine of 20 degrees
constexpr int kCircleParts = 24;
constexpr double kFullTurn = 2.0 * std::numbers::pi;
constexpr double kOverGround = 0.04;  // metres, to keep lines out of the ground
constexpr double kHatchApart = 0.08;  // metres, at least
constexpr double kMostHatchLines = 50.0;
constexpr double kContactRadius = 0.35;  // metres, slightly wider than a person

class Outliner {
public:
    Outliner(const Pose& pose, const LineColor& color, std::vector<OverlayLine>& lines,
             const std::optional<Aabb>& within = {})
        : pose_(pose), color_(color), lines_(lines), within_(within) {}

    void line(const Vector3d& a, const Vector3d& b) { lines_.push_back({pose_ * a, pose_ * b, color_}); }

    void box(const Vector3d& half) {
        for (int axis = 0; axis < 3; ++axis) {
            const int u = (axis + 1) % 3;
            const int v = (axis + 2) % 3;
            for (const auto& [su, sv] :
                 {std::pair(-1, -1), std::pair(-1, 1), std::pair(1, -1), std::pair(1, 1)}) {
                Vector3d a;
                a[axis] = -half[axis];
                a[u] = su * half[u];
                a[v] = sv * half[v];
                Vector3d b = a;
                b[axis] = half[axis];
                line(a, b);
            }
        }
    }

    /// Parallel lines on all faces of a box.
    void hatch(const Vector3d& half) {
        const double apart = std::max(kHatchApart, half.maxCoeff() / kMostHatchLines);
        for (int axis = 0; axis < 3; ++axis) {
            const int u = (axis + 1) % 3;
            const int v = (axis + 2) % 3;
            for (int i = 1; i * apart < 2.0 * half[v]; ++i) {
                const double at = -half[v] + i * apart;
                for (const int side : {-1, 1}) {
                    Vector3d a;
                    a[axis] = side * half[axis];
                    a[u] = -half[u];
                    a[v] = at;
                    Vector3d b = a;
                    b[u] = half[u];
                    line(a, b);
                }
            }
        }
    }

    /// Starts at angle `start` and spans `turn` radians, from axis `u` towards axis `v`.
    void arc(const Vector3d& centre, double radius, int u, int v, double start, double turn) {
        const int parts = std::max(2, static_cast<int>(std::lround(kCircleParts * turn / kFullTurn)));
        const auto at = [&](int i) {
            const double angle = start + turn * i / parts;
            Vector3d p = centre;
            p[u] += radius * std::cos(angle);
            p[v] += radius * std::sin(angle);
            return p;
        };
        for (int i = 0; i < parts; ++i) {
            line(at(i), at(i + 1));
        }
    }
    void circle(const Vector3d& centre, double radius, int u, int v) {
        arc(centre, radius, u, v, 0.0, kFullTurn);
    }

    void operator()(const collision::Box& shape) { box(shape.half_extents); }

    void operator()(const collision::Sphere& shape) {
        for (int axis = 0; axis < 3; ++axis) {
            circle(Vector3d::Zero(), shape.radius, (axis + 1) % 3, (axis + 2) % 3);
        }
    }

    void operator()(const collision::Capsule& shape) {
        const Vector3d up = shape.half_length * Vector3d::UnitY();
        for (const int sign : {-1, 1}) {
            circle(sign * up, shape.radius, 0, 2);
            for (const int side : {0, 2}) {
                arc(sign * up, shape.radius, side, 1, sign > 0 ? 0.0 : 0.5 * kFullTurn, 0.5 * kFullTurn);
                Vector3d aside = Vector3d::Zero();
                aside[side] = sign * shape.radius;
                line(aside - up, aside + up);
            }
        }
    }

    void operator()(const collision::Wheel& shape) {
        const Vector3d out = shape.half_width * Vector3d::UnitX();
        circle(out, shape.radius, 1, 2);
        circle(-out, shape.radius, 1, 2);
        for (int i = 0; i < 8; ++i) {
            const double angle = kFullTurn * i / 8;
            const Vector3d rim(0.0, shape.radius * std::cos(angle), shape.radius * std::sin(angle));
            line(rim - out, rim + out);
        }
    }

    void operator()(const std::shared_ptr<const collision::MeshCollider>& shape) { mesh(shape->mesh()); }

    void mesh(const collision::TriangleMesh& mesh);

private:
    bool is_within(const collision::Triangle& t) const {
        Aabb box;
        for (const Vector3d& vertex : {t.a, t.b, t.c}) {
            box.extend(pose_ * vertex);
        }
        return !within_ || within_->overlaps(box);
    }

    const Pose& pose_;
    LineColor color_;
    std::vector<OverlayLine>& lines_;
    std::optional<Aabb> within_;
};

// A triangle's edge with its ends in canonical order.
struct Edge {
    Vector3d a;
    Vector3d b;
    Vector3d normal;

    auto ends() const { return std::tuple(a.x(), a.y(), a.z(), b.x(), b.y(), b.z()); }
};

Edge edge_of(const Vector3d& a, const Vector3d& b, const Vector3d& normal) {
    const bool ordered = std::tuple(a.x(), a.y(), a.z()) < std::tuple(b.x(), b.y(), b.z());
    return ordered ? Edge{a, b, normal} : Edge{b, a, normal};
}

void Outliner::mesh(const collision::TriangleMesh& mesh) {
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const collision::Triangle t = collision::vertices(mesh, i);
        if (!is_within(t)) {
            continue;
        }
        const Vector3d normal = (t.b - t.a).cross(t.c - t.a).normalized();
        edges.push_back(edge_of(t.a, t.b, normal));
        edges.push_back(edge_of(t.b, t.c, normal));
        edges.push_back(edge_of(t.c, t.a, normal));
    }
    std::ranges::stable_sort(edges, {}, [](const Edge& edge) { return edge.ends(); });
    for (std::size_t first = 0; first < edges.size();) {
        std::size_t end = first + 1;
        bool bent = false;
        while (end < edges.size() && edges[end].ends() == edges[first].ends()) {
            bent = bent || std::abs(edges[end].normal.dot(edges[first].normal)) < kMaxFlatCosine;
            ++end;
        }
        if (bent || end == first + 1) {
            line(edges[first].a, edges[first].b);
        }
        first = end;
    }
}

void add_objects(const scene::Campus& campus, bool colliders, bool triggers,
                 const std::optional<Aabb>& within, std::vector<OverlayLine>& lines) {
    for (std::uint32_t i = 0; i < campus.world.size(); ++i) {
        if (within && !within->overlaps(campus.world.bounds(collision::ObjectId{i}))) {
            continue;
        }
        const collision::Object& object = campus.world.object(collision::ObjectId{i});
        const bool solid = any_of(object.detection, Detection::solid);
        if (colliders && (solid || any_of(object.detection, Detection::ray))) {
            add_outline(object.shape, object.X_world_shape, solid ? kSolid : kRayTarget, lines, within);
            // Nothing else shows it: its edges alone look like an open doorway.
            const auto* box = std::get_if<collision::Box>(&object.shape);
            if (within && solid && box != nullptr && campus.objects[i].nodes.roots.empty()) {
                Outliner(object.X_world_shape, kSolid, lines).hatch(box->half_extents);
            }
        }
        if (triggers && any_of(object.detection, Detection::trigger)) {
            add_outline(object.shape, object.X_world_shape, kTrigger, lines, within);
        }
    }
}

void add_contact(const Vector3d& foot, std::vector<OverlayLine>& lines) {
    Pose pose;
    pose.translation = foot + kOverGround * Vector3d::UnitY();
    Outliner outliner(pose, kContact, lines);
    outliner.circle(Vector3d::Zero(), kContactRadius, 0, 2);
    outliner.circle(Vector3d::Zero(), 0.6 * kContactRadius, 0, 2);
    outliner.line(Vector3d::Zero(), {0.0, 2.0, 0.0});
}

}  // namespace

void add_outline(const collision::Shape& shape, const Pose& X_world_shape, const LineColor& color,
                 std::vector<OverlayLine>& lines, const std::optional<Aabb>& within) {
    Outliner outliner(X_world_shape, color, lines, within);
    std::visit(outliner, shape);
}

void add_tree_boxes(const scene::Campus& campus, int level, std::vector<OverlayLine>& lines) {
    for (std::uint32_t i = 0; i < campus.world.size(); ++i) {
        const collision::Object& object = campus.world.object(collision::ObjectId{i});
        const auto* mesh = std::get_if<std::shared_ptr<const collision::MeshCollider>>(&object.shape);
        if (mesh == nullptr) {
            continue;
        }
        for (const collision::PosedBox& posed : collision::boxes_at_level(**mesh, level)) {
            Pose pose;
            pose.rotation = object.X_world_shape.rotation * posed.X_mesh_box.rotation;
            pose.translation = object.X_world_shape * posed.X_mesh_box.translation;
            Outliner(pose, kTree, lines).box(posed.box.half_extents);
        }
    }
}

std::vector<OverlayLine> overlay_lines(const scene::Campus& campus, const ImageOverlays& overlays,
                                       std::span<const Vector3d> path, std::span<const Vector3d> contacts,
                                       const std::optional<Aabb>& within) {
    std::vector<OverlayLine> lines;
    add_objects(campus, overlays.colliders, overlays.triggers, within, lines);
    if (overlays.tree_level) {
        add_tree_boxes(campus, *overlays.tree_level, lines);
    }
    const Vector3d up = kOverGround * Vector3d::UnitY();
    for (std::size_t i = 1; overlays.path && i < path.size(); ++i) {
        lines.push_back({path[i - 1] + up, path[i] + up, kPath});
    }
    if (overlays.contacts) {
        for (const Vector3d& foot : contacts) {
            add_contact(foot, lines);
        }
    }
    return lines;
}

}  // namespace campuswalk::engine::render

#include "collision/world/obstacle.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "collision/geometry/sweep.h"
#include "collision/mesh/mesh_query.h"

namespace campuswalk::collision {

namespace {

/// A point this close to a face counts as lying on it, metres.
constexpr double kOnFace = 1e-6;

void append_triangles(const World& world, ObjectId id, const MeshCollider& mesh, const Segment& segment,
                      double radius, std::vector<Obstacle>& out, QueryStatistics* statistics) {
    const Pose& X = world.object(id).X_world_shape;
    const Segment local{X.inverse_apply(segment.a), X.inverse_apply(segment.b)};
    thread_local std::vector<std::uint32_t> near;
    triangles_near(mesh, local, radius, near, statistics);
    for (const std::uint32_t t : near) {
        const Triangle c = vertices(mesh.mesh(), t);
        out.push_back(triangle_obstacle(id, t, {X * c.a, X * c.b, X * c.c}));
    }
}

void append_pieces(const World& world, ObjectId id, const Segment& segment, double radius,
                   std::vector<Obstacle>& out, QueryStatistics* statistics) {
    const Object& object = world.object(id);
    if (const auto* mesh = std::get_if<std::shared_ptr<const MeshCollider>>(&object.shape)) {
        append_triangles(world, id, **mesh, segment, radius, out, statistics);
        return;
    }
    const Obstacle o = solid_obstacle(world, id);
    add_to(statistics, {.primitive_tests = 1});
    if (closest(segment, o).distance <= radius) {
        out.push_back(o);
    }
}

bool up_at(const Box& box, const Pose& X, const Vec3& point, double min_up) {
    const Vec3 p = X.inverse_apply(point);
    for (int axis = 0; axis < 3; ++axis) {
        const double side = p[axis] < 0.0 ? -1.0 : 1.0;
        if (std::abs(p[axis]) >= box.half_extents[axis] - kOnFace && side * X.rotation(1, axis) >= min_up) {
            return true;
        }
    }
    return false;
}

bool up_at(const Sphere&, const Pose& X, const Vec3& point, double min_up) {
    const Vec3 outward = point - X.translation;
    return outward.y() >= min_up * outward.norm();
}

bool up_at(const Capsule& capsule, const Pose& X, const Vec3& point, double min_up) {
    const Vec3 half = X.rotate(Vec3(0.0, capsule.half_length, 0.0));
    const Vec3 outward = point - closest_on_segment({X.translation - half, X.translation + half}, point);
    return outward.y() >= min_up * outward.norm();
}

bool up_at(const Wheel& wheel, const Pose& X, const Vec3& point, double min_up) {
    const Vec3 p = X.inverse_apply(point);
    const double side = p.x() < 0.0 ? -1.0 : 1.0;
    if (std::abs(p.x()) >= wheel.half_width - kOnFace && side * X.rotation(1, 0) >= min_up) {
        return true;
    }
    const Vec3 outward = X.rotate(Vec3(0.0, p.y(), p.z()));
    const double rho = outward.norm();
    return rho >= wheel.radius - kOnFace && outward.y() >= min_up * rho;
}

bool up_at(const std::shared_ptr<const MeshCollider>&, const Pose&, const Vec3&, double) {
    return false;  // never called: a mesh's obstacles are its triangles
}

Closest closest(const Segment&, const std::shared_ptr<const MeshCollider>&, const Pose&) {
    return {};  // likewise
}

}  // namespace

Obstacle triangle_obstacle(ObjectId object, std::uint32_t triangle, const Triangle& vertices) {
    Obstacle obstacle;
    obstacle.object = object;
    obstacle.triangle = triangle;
    obstacle.vertices = vertices;
    const Vec3 n = (vertices.b - vertices.a).cross(vertices.c - vertices.a);
    const double length = n.norm();
    obstacle.normal = length > 0.0 ? Vec3(n / length) : Vec3::Zero();
    obstacle.top = std::max({vertices.a.y(), vertices.b.y(), vertices.c.y()});
    return obstacle;
}

Obstacle solid_obstacle(const World& world, ObjectId object) {
    Obstacle obstacle;
    obstacle.object = object;
    obstacle.solid = &world.object(object);
    obstacle.top = world.bounds(object).max.y();
    return obstacle;
}

void gather_obstacles(const World& world, const QueryFilter& filter, const Segment& segment, double radius,
                      std::vector<Obstacle>& out, QueryStatistics* statistics) {
    out.clear();
    Aabb box;
    box.extend(segment.a);
    box.extend(segment.b);
    thread_local std::vector<ObjectId> candidates;
    world.candidates(box.grown(radius), filter, candidates);
    for (const ObjectId id : candidates) {
        append_pieces(world, id, segment, radius, out, statistics);
    }
}

void gather_pieces(const World& world, ObjectId id, const Segment& segment, double radius,
                   std::vector<Obstacle>& out, QueryStatistics* statistics) {
    out.clear();
    append_pieces(world, id, segment, radius, out, statistics);
}

Closest closest(const Segment& segment, const Obstacle& obstacle) {
    if (obstacle.solid == nullptr) {
        return closest(segment, obstacle.vertices);
    }
    const Object& object = *obstacle.solid;
    return std::visit([&](const auto& shape) { return closest(segment, shape, object.X_world_shape); },
                      object.shape);
}

bool walkable_at(const Obstacle& obstacle, const Vec3& point, double min_up) {
    if (obstacle.solid == nullptr) {
        return std::abs(obstacle.normal.y()) >= min_up;
    }
    const Object& object = *obstacle.solid;
    return std::visit([&](const auto& shape) { return up_at(shape, object.X_world_shape, point, min_up); },
                      object.shape);
}

std::optional<double> sweep(const Segment& segment, double radius, const Vec3& move,
                            const Obstacle& obstacle) {
    return first_touch(segment, radius, move, [&](const Segment& moved) { return closest(moved, obstacle); });
}

}  // namespace campuswalk::collision

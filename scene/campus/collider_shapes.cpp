#include "scene/campus/collider_shapes.h"

#include <algorithm>
#include <cmath>

#include "collision/mesh/mesh_collider.h"
#include "scene/campus/bake_mesh.h"
#include "scene/model/node_frame.h"

namespace campuswalk::scene {
namespace {

using collision::Aabb;
using collision::Mat3;
using collision::Pose;
using collision::Vec3;

// A sign plate without thickness still makes a solid box.
constexpr double kMinHalfExtent = 0.0005;  // metres

/// Bounds of the geometry's triangles in the frame.
Aabb bounds_in(const Pose& frame, const WorldGeometry& geometry) {
    Aabb bounds;
    for (const auto& triangle : geometry.triangles) {
        for (const std::uint32_t vertex : triangle) {
            bounds.extend(frame.inverse_apply(geometry.positions[vertex]));
        }
    }
    return bounds;
}

Vec3 centre_of(const Aabb& bounds) {
    return bounds.center();
}

double farthest_from(const Vec3& p_world, const WorldGeometry& geometry) {
    double farthest = 0.0;
    for (const auto& triangle : geometry.triangles) {
        for (const std::uint32_t vertex : triangle) {
            farthest = std::max(farthest, (geometry.positions[vertex] - p_world).squaredNorm());
        }
    }
    return std::sqrt(farthest);
}

std::optional<PlacedShape> place(const MeshShape& /*shape*/, const ShapeSource& source) {
    BakedMesh baked = bake_mesh(source.geometry);
    if (baked.mesh.triangles.empty()) {
        return std::nullopt;
    }
    PlacedShape placed;
    placed.zero_area = baked.zero_area;
    placed.X_world_shape.translation = baked.p_world_origin;
    placed.shape = std::make_shared<const collision::MeshCollider>(std::move(baked.mesh), source.tree);
    return placed;
}

bool encloses_all(const collision::MeshCollider& mesh) {
    const collision::ClosedParts& closed = mesh.closed_parts();
    const std::size_t count = mesh.mesh().triangles.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (closed.empty() || !closed.has(i)) {
            return false;
        }
    }
    return true;
}

std::optional<PlacedShape> place(const BoxShape& box, const ShapeSource& source) {
    PlacedShape placed;
    placed.X_world_shape = source.frame;
    placed.X_world_shape.rotation = source.frame.rotation * rotation_about_y(box.yaw);
    const Aabb bounds = bounds_in(placed.X_world_shape, source.geometry);
    if (bounds.empty() && !(box.center && box.size)) {
        return std::nullopt;
    }
    const Vec3 half = box.size ? Vec3(*box.size * 0.5) : Vec3((bounds.max - bounds.min) * 0.5);
    placed.X_world_shape.translation =
        box.center ? source.frame * *box.center : placed.X_world_shape * centre_of(bounds);
    placed.shape = collision::Box{half.cwiseMax(kMinHalfExtent)};
    return placed;
}

std::optional<PlacedShape> place(const SphereShape& sphere, const ShapeSource& source) {
    const Aabb bounds = bounds_in(source.frame, source.geometry);
    if (bounds.empty() && !(sphere.center && sphere.radius)) {
        return std::nullopt;
    }
    PlacedShape placed;
    const Vec3& centre = placed.X_world_shape.translation =
        source.frame * (sphere.center ? *sphere.center : centre_of(bounds));
    placed.shape = collision::Sphere{sphere.radius ? *sphere.radius : farthest_from(centre, source.geometry)};
    return placed;
}

/// The base of a capsule that has none: the node's origin if that is within or near the bounds.
Vec3 fitted_base(const ShapeSource& source, const Aabb& bounds) {
    constexpr double kNear = 0.5;  // metres: a trunk's origin may lie a little below its lowest vertex
    const Vec3& origin = source.frame.translation;
    const Aabb near = bounds.grown(kNear);
    const bool origin_is_near = bounds.empty() || ((near.min.array() <= origin.array()).all() &&
                                                   (origin.array() <= near.max.array()).all());
    if (origin_is_near) {
        return origin;
    }
    const Vec3 centre = centre_of(bounds);
    return {centre.x(), bounds.min.y(), centre.z()};
}

std::optional<PlacedShape> place(const CapsuleShape& capsule, const ShapeSource& source) {
    const Aabb bounds = bounds_in(Pose{}, source.geometry);
    if (bounds.empty() && !(capsule.radius && capsule.height && (capsule.base || source.has_nodes))) {
        return std::nullopt;
    }
    const Vec3 base = capsule.base ? source.frame * *capsule.base : fitted_base(source, bounds);
    const double height = capsule.height ? *capsule.height : std::max(bounds.max.y() - base.y(), 0.0);
    const double half_width =
        0.5 * std::max(bounds.max.x() - bounds.min.x(), bounds.max.z() - bounds.min.z());
    // A fitted radius is limited by the height, never the other way round.
    const double radius = capsule.radius ? *capsule.radius : std::min(half_width, 0.5 * height);
    const double half_length = std::max(0.5 * height - radius, 0.0);
    PlacedShape placed;
    placed.X_world_shape.translation = base + Vec3(0.0, radius + half_length, 0.0);
    placed.shape = collision::Capsule{radius, half_length};
    return placed;
}

std::optional<PlacedShape> place(const WheelShape& wheel, const ShapeSource& source) {
    PlacedShape placed;
    placed.X_world_shape = source.frame;
    placed.X_world_shape.rotation = source.frame.rotation * rotation_with_x_along(wheel.axis);
    const Aabb bounds = bounds_in(placed.X_world_shape, source.geometry);
    if (bounds.empty() && !(wheel.center && wheel.radius && wheel.width)) {
        return std::nullopt;
    }
    placed.X_world_shape.translation =
        wheel.center ? source.frame * *wheel.center : placed.X_world_shape * centre_of(bounds);
    double radius = wheel.radius.value_or(0.0);
    for (std::size_t i = 0; i < source.geometry.triangles.size() && !wheel.radius; ++i) {
        for (const std::uint32_t vertex : source.geometry.triangles[i]) {
            const Vec3 p = placed.X_world_shape.inverse_apply(source.geometry.positions[vertex]);
            radius = std::max(radius, std::sqrt(p.y() * p.y() + p.z() * p.z()));
        }
    }
    const double width = wheel.width ? *wheel.width : bounds.max.x() - bounds.min.x();
    placed.shape = collision::Wheel{radius, std::max(0.5 * width, kMinHalfExtent)};
    return placed;
}

}  // namespace

bool is_placed_by_numbers(const ShapeDescription& shape) {
    struct Visitor {
        bool operator()(const MeshShape& /*mesh*/) const { return false; }
        bool operator()(const BoxShape& box) const { return box.center && box.size; }
        bool operator()(const SphereShape& sphere) const { return sphere.center && sphere.radius; }
        bool operator()(const CapsuleShape& capsule) const {
            return capsule.base && capsule.radius && capsule.height;
        }
        bool operator()(const WheelShape& wheel) const { return wheel.center && wheel.radius && wheel.width; }
    };
    return std::visit(Visitor{}, shape);
}

PlacedShape enclosed(PlacedShape placed, const ShapeSource& source) {
    if (encloses_all(*std::get<std::shared_ptr<const collision::MeshCollider>>(placed.shape))) {
        return placed;
    }
    EnclosingSurface surface = enclosing_surface(source.geometry);
    if (surface.no_inside) {
        placed.no_inside = surface.no_inside;
        return placed;
    }
    // A lid may have triangles without area, and would be open without them.
    BakedMesh baked = bake_every_triangle(surface.geometry);
    placed.openings = surface.openings;
    placed.left_out = surface.left_out;
    placed.X_world_shape.translation = baked.p_world_origin;
    placed.shape = std::make_shared<const collision::MeshCollider>(std::move(baked.mesh), source.tree);
    return placed;
}

std::optional<PlacedShape> place_shape(const ShapeDescription& shape, const ShapeSource& source) {
    return std::visit([&](const auto& description) { return place(description, source); }, shape);
}

}  // namespace campuswalk::scene

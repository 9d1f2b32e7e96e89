#include "tests/support/penetration_oracle.h"

#include <algorithm>
#include <cmath>

#include "collision/mesh/mesh_collider.h"
#include "tests/support/plain_solids.h"

namespace campuswalk::support {

namespace {

using MeshPtr = std::shared_ptr<const collision::MeshCollider>;

Line axis_of(const Point& foot, double radius, double height) {
    return {foot + Point(0, radius, 0), foot + Point(0, height - radius, 0)};
}

double reach_of(const collision::Shape& shape) {
    if (const auto* box = std::get_if<collision::Box>(&shape)) {
        return box->half_extents.norm();
    }
    if (const auto* sphere = std::get_if<collision::Sphere>(&shape)) {
        return sphere->radius;
    }
    if (const auto* capsule = std::get_if<collision::Capsule>(&shape)) {
        return capsule->half_length + capsule->radius;
    }
    const auto& wheel = std::get<collision::Wheel>(shape);
    return std::hypot(wheel.radius, wheel.half_width);
}

void deepen(Penetration& worst, std::size_t object, double depth) {
    if (depth > worst.depth) {
        worst = {depth, object};
    }
}

/// Whether the triangle and the parallelogram that the line sweeps over have a point in common.
bool sweeps_through(const Line& start, const Line& end, const Vertices& triangle) {
    const Line edges[] = {start, end, {start.from, end.from}, {start.to, end.to}};
    if (std::any_of(std::begin(edges), std::end(edges),
                    [&](const Line& edge) { return passes_through(edge, triangle); })) {
        return true;
    }
    const Vertices lower{start.from, start.to, end.from};
    const Vertices upper{end.from, start.to, end.to};
    for (std::size_t i = 0; i < 3; ++i) {
        const Line edge{triangle[i], triangle[(i + 1) % 3]};
        if (passes_through(edge, lower) || passes_through(edge, upper)) {
            return true;
        }
    }
    return false;
}

}  // namespace

PenetrationOracle::PenetrationOracle(const collision::World& world, const collision::QueryFilter& filter) {
    for (std::size_t i = 0; i < world.size(); ++i) {
        const collision::Object& object = world.object(static_cast<collision::ObjectId>(i));
        const auto wanted_bits = static_cast<unsigned>(filter.detection);
        const bool ignored = (filter.ignored_layers >> object.layer & 1U) != 0;
        if ((static_cast<unsigned>(object.detection) & wanted_bits) == 0 || ignored) {
            continue;
        }
        if (std::holds_alternative<MeshPtr>(object.shape)) {
            add_mesh(i, object);
        } else {
            solids_.push_back({i, &object, reach_of(object.shape)});
        }
    }
    grid_.sort_into_columns();
}

void PenetrationOracle::add_mesh(std::size_t object, const collision::Object& placed) {
    const collision::TriangleMesh& mesh = std::get<MeshPtr>(placed.shape)->mesh();
    const auto& X = placed.X_world_shape;
    const auto vertex = [&](std::uint32_t v) {
        return Point(X.rotation * mesh.positions[v].cast<double>() + X.translation);
    };
    for (const auto& t : mesh.triangles) {
        grid_.add(object, {vertex(t[0]), vertex(t[1]), vertex(t[2])});
    }
}

Penetration PenetrationOracle::worst_penetration(const Point& foot, double radius, double height) const {
    const Line axis = axis_of(foot, radius, height);
    const Point grown = Point::Constant(radius + kClear);
    Penetration worst{-kClear, std::nullopt};
    grid_.visit_near(axis.from - grown, axis.to + grown, [&](const TriangleGrid::Entry& e) {
        deepen(worst, e.object, radius - distance(axis, e.vertices));
    });
    for (const Solid& solid : solids_) {
        const double clear = solid.reach + radius + kClear;
        if (distance(solid.shape->X_world_shape.translation, axis) <= clear) {
            deepen(worst, solid.object, radius - signed_distance(*solid.shape, axis));
        }
    }
    return worst;
}

Penetration PenetrationOracle::worst_penetration_without_grid(const Point& foot, double radius,
                                                              double height) const {
    const Line axis = axis_of(foot, radius, height);
    Penetration worst{-kClear, std::nullopt};
    for (const TriangleGrid::Entry& e : grid_.entries()) {
        deepen(worst, e.object, radius - distance(axis, e.vertices));
    }
    for (const Solid& solid : solids_) {
        deepen(worst, solid.object, radius - signed_distance(*solid.shape, axis));
    }
    return worst;
}

std::optional<std::size_t> PenetrationOracle::crossed(const Point& from, const Point& to, double radius,
                                                      double height) const {
    const Line start = axis_of(from, radius, height);
    const Line end = axis_of(to, radius, height);
    std::optional<std::size_t> first;
    const auto report = [&](std::size_t object) { first = std::min(first.value_or(object), object); };

    grid_.visit_near(start.from.cwiseMin(end.from), start.to.cwiseMax(end.to),
                     [&](const TriangleGrid::Entry& e) {
                         if (sweeps_through(start, end, e.vertices)) {
                             report(e.object);
                         }
                     });
    for (const Solid& solid : solids_) {
        const Line path{0.5 * (start.from + start.to), 0.5 * (end.from + end.to)};
        const double far = solid.reach + 0.5 * height;
        if (distance(solid.shape->X_world_shape.translation, path) > far) {
            continue;
        }
        const double least = least_on_unit_interval([&](double t) {
            const Point moved = t * (to - from);
            return signed_distance(*solid.shape, {start.from + moved, start.to + moved});
        });
        if (least < 0.0) {
            report(solid.object);
        }
    }
    return first;
}

}  // namespace campuswalk::support

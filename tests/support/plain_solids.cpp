#include "tests/support/plain_solids.h"

#include <Eigen/Geometry>

namespace campuswalk::support {

double signed_distance(const collision::Shape& solid, const Point& point) {
    if (const auto* sphere = std::get_if<collision::Sphere>(&solid)) {
        return point.norm() - sphere->radius;
    }
    if (const auto* capsule = std::get_if<collision::Capsule>(&solid)) {
        const Point end(0, capsule->half_length, 0);
        return distance(point, Line{-end, end}) - capsule->radius;
    }
    if (const auto* box = std::get_if<collision::Box>(&solid)) {
        return signed_distance_to_box(point, box->half_extents);
    }
    const auto& wheel = std::get<collision::Wheel>(solid);
    return signed_distance_to_cylinder(point, wheel.radius, wheel.half_width);
}

double signed_distance(const collision::Object& solid, const Line& world_line) {
    const auto& X = solid.X_world_shape;
    const Line line{X.rotation.transpose() * (world_line.from - X.translation),
                    X.rotation.transpose() * (world_line.to - X.translation)};
    if (const auto* sphere = std::get_if<collision::Sphere>(&solid.shape)) {
        return distance(Point::Zero(), line) - sphere->radius;
    }
    if (const auto* capsule = std::get_if<collision::Capsule>(&solid.shape)) {
        const Point end(0, capsule->half_length, 0);
        return distance(line, Line{-end, end}) - capsule->radius;
    }
    return least_on_unit_interval([&](double t) { return signed_distance(solid.shape, line.at(t)); });
}

Vertices vertices_of(const collision::Triangle& triangle) {
    return {triangle.a, triangle.b, triangle.c};
}

std::optional<double> first_intersection(const Line& line, const Vertices& t) {
    if (!passes_through(line, t)) {
        return std::nullopt;
    }
    const Point normal = (t[1] - t[0]).cross(t[2] - t[0]);
    const double from = normal.dot(line.from - t[0]);
    const double to = normal.dot(line.to - t[0]);
    return from / (from - to);
}

std::optional<double> first_intersection(const Line& line, const collision::Shape& solid) {
    return first_not_above_zero([&](double t) { return signed_distance(solid, line.at(t)); });
}

}  // namespace campuswalk::support

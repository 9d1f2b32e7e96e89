#pragma once

#include <optional>

#include "collision/geometry/triangle_mesh.h"
#include "collision/world/world.h"
#include "tests/support/plain_geometry.h"

namespace campuswalk::support {

/// To the solid's surface, in the solid's own frame, negative inside. Not for meshes.
double signed_distance(const collision::Shape& solid, const Point& point);

/// The least signed distance between the points of a line in world coordinates and the placed solid.
double signed_distance(const collision::Object& solid, const Line& world_line);

/// The vertices of a mesh's triangle.
Vertices vertices_of(const collision::Triangle& triangle);

/// Where the line first intersects the triangle; none for a line in the triangle's own plane.
std::optional<double> first_intersection(const Line& line, const Vertices& triangle);

/// Where the line first intersects the filled solid, in the solid's own frame, to about 1e-12.
std::optional<double> first_intersection(const Line& line, const collision::Shape& solid);

/// The first argument in [0, 1] at which a convex function is at most 0; none if it is positive everywhere.
template <typename Convex>
std::optional<double> first_not_above_zero(const Convex& f) {
    if (f(0.0) <= 0.0) {
        return 0.0;
    }
    // Ternary search towards the least value, until the function isn't positive at some argument.
    std::optional<double> found;
    if (f(1.0) <= 0.0) {
        found = 1.0;
    }
    double low = 0.0;
    double high = 1.0;
    for (int i = 0; i < 90 && !found; ++i) {
        const double left = low + (high - low) / 3.0;
        const double right = high - (high - low) / 3.0;
        const double at_left = f(left);
        const double at_right = f(right);
        if (at_left <= 0.0 || at_right <= 0.0) {
            found = at_left <= 0.0 ? left : right;
        }
        (at_left < at_right ? high : low) = at_left < at_right ? right : left;
    }
    if (!found) {
        return std::nullopt;
    }
    low = 0.0;
    high = *found;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (f(middle) <= 0.0 ? high : low) = middle;
    }
    return high;
}

}  // namespace campuswalk::support

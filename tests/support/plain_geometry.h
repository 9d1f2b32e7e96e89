#pragma once

#include <array>

#include <Eigen/Core>

/// Distances by the plainest formulas, in double precision: the oracle's own, sharing nothing with
/// collision/, so that a mistake there can't hide here.
namespace campuswalk::support {

using Point = Eigen::Vector3d;
using Vertices = std::array<Point, 3>;

/// A line segment.
struct Line {
    Point from = Point::Zero();
    Point to = Point::Zero();

    Point at(double t) const { return from + t * (to - from); }
};

double distance(const Point& point, const Line& line);
double distance(const Line& a, const Line& b);
/// 0 where they intersect. Triangles without area are their edges.
double distance(const Line& line, const Vertices& triangle);

/// Whether the line passes through the triangle or ends on it; false for a line in the triangle's plane.
bool passes_through(const Line& line, const Vertices& triangle);

// Signed distances from the surface, negative inside, in the solid's own frame.

double signed_distance_to_box(const Point& point, const Point& half_extents);
/// About the X axis.
double signed_distance_to_cylinder(const Point& point, double radius, double half_width);

/// The least value of a convex function on [0, 1], by ternary search.
template <typename Convex>
double least_on_unit_interval(const Convex& f) {
    double low = 0.0;
    double high = 1.0;
    for (int i = 0; i < 90; ++i) {
        const double third = (high - low) / 3.0;
        if (f(low + third) < f(high - third)) {
            high -= third;
        } else {
            low += third;
        }
    }
    const double inner = f(0.5 * (low + high));
    const double ends = f(0.0) < f(1.0) ? f(0.0) : f(1.0);
    return inner < ends ? inner : ends;
}

}  // namespace campuswalk::support

#include "tests/support/plain_geometry.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace campuswalk::support {

namespace {

/// Six times the volume of the tetrahedron p q r s, signed.
double volume(const Point& p, const Point& q, const Point& r, const Point& s) {
    return (q - p).dot((r - p).cross(s - p));
}

/// Whether the projection of `point` onto the triangle's plane is inside the triangle.
bool projects_inside(const Point& point, const Vertices& t, const Point& normal) {
    for (std::size_t i = 0; i < 3; ++i) {
        const Point& vertex = t[i];
        const Point edge = t[(i + 1) % 3] - vertex;
        if (normal.dot(edge.cross(point - vertex)) < 0.0) {
            return false;
        }
    }
    return true;
}

}  // namespace

double distance(const Point& point, const Line& line) {
    const Point d = line.to - line.from;
    const double length2 = d.squaredNorm();
    const double t = length2 > 0.0 ? std::clamp(d.dot(point - line.from) / length2, 0.0, 1.0) : 0.0;
    return (line.at(t) - point).norm();
}

double distance(const Line& a, const Line& b) {
    // The least distance is at an end of one line, or inside both at the feet of the common perpendicular.
    double least = std::min({distance(a.from, b), distance(a.to, b), distance(b.from, a), distance(b.to, a)});
    const Point u = a.to - a.from;
    const Point v = b.to - b.from;
    const Point n = u.cross(v);
    const double n2 = n.squaredNorm();
    if (n2 > 0.0) {
        const Point r = b.from - a.from;
        const double s = r.cross(v).dot(n) / n2;
        const double t = r.cross(u).dot(n) / n2;
        if (s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0) {
            least = std::min(least, (a.at(s) - b.at(t)).norm());
        }
    }
    return least;
}

bool passes_through(const Line& line, const Vertices& t) {
    const double from = volume(t[0], t[1], t[2], line.from);
    const double to = volume(t[0], t[1], t[2], line.to);
    if (from == to || (from > 0.0 && to > 0.0) || (from < 0.0 && to < 0.0)) {
        return false;
    }
    const double u = volume(line.from, line.to, t[0], t[1]);
    const double v = volume(line.from, line.to, t[1], t[2]);
    const double w = volume(line.from, line.to, t[2], t[0]);
    return (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
}

double distance(const Line& line, const Vertices& t) {
    if (passes_through(line, t)) {
        return 0.0;
    }
    double least = std::min({distance(line, Line{t[0], t[1]}), distance(line, Line{t[1], t[2]}),
                             distance(line, Line{t[2], t[0]})});
    const Point normal = (t[1] - t[0]).cross(t[2] - t[0]);
    const double length = normal.norm();
    if (length > 0.0) {
        for (const Point& end : {line.from, line.to}) {
            if (projects_inside(end, t, normal)) {
                least = std::min(least, std::abs(normal.dot(end - t[0])) / length);
            }
        }
    }
    return least;
}

double signed_distance_to_box(const Point& point, const Point& half_extents) {
    const Point beyond = point.cwiseAbs() - half_extents;
    return beyond.cwiseMax(0.0).norm() + std::min(beyond.maxCoeff(), 0.0);
}

double signed_distance_to_cylinder(const Point& point, double radius, double half_width) {
    const double along = std::abs(point.x()) - half_width;
    const double across = std::hypot(point.y(), point.z()) - radius;
    return std::hypot(std::max(along, 0.0), std::max(across, 0.0)) + std::min(std::max(along, across), 0.0);
}

}  // namespace campuswalk::support

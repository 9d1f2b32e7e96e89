#include "engine/script/smooth_curve.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace campuswalk::engine {

using Eigen::Vector3d;

namespace {

constexpr double kSegment = 0.1;         // metres
constexpr double kMaxSegments = 1000.0;  // between two points

/// The spline's parameter grows by the square root of the distance: that is what makes it centripetal.
double knot_distance(const Vector3d& from, const Vector3d& to) {
    return std::sqrt((to - from).norm());
}

/// Four points with their knots; the curve is evaluated between the second and the third.
struct Span {
    std::array<Vector3d, 4> points;
    std::array<double, 4> knots{};

    Vector3d interpolated(const Vector3d& a, const Vector3d& b, std::size_t from, std::size_t to,
                          double t) const {
        const double share = (t - knots[from]) / (knots[to] - knots[from]);
        return a + share * (b - a);
    }

    /// Barry and Goldman's pyramid of linear interpolations.
    Vector3d at(double t) const {
        const Vector3d a = interpolated(points[0], points[1], 0, 1, t);
        const Vector3d b = interpolated(points[1], points[2], 1, 2, t);
        const Vector3d c = interpolated(points[2], points[3], 2, 3, t);
        return interpolated(interpolated(a, b, 0, 2, t), interpolated(b, c, 1, 3, t), 1, 2, t);
    }
};

Span span_of(const Vector3d& before, const Vector3d& from, const Vector3d& to, const Vector3d& after) {
    Span span{{before, from, to, after}, {}};
    for (std::size_t i = 1; i < 4; ++i) {
        span.knots[i] = span.knots[i - 1] + knot_distance(span.points[i - 1], span.points[i]);
    }
    return span;
}

std::vector<Vector3d> level_and_distinct(const std::vector<Vector3d>& points) {
    std::vector<Vector3d> distinct;
    for (const Vector3d& point : points) {
        const Vector3d level(point.x(), 0.0, point.z());
        if (distinct.empty() || (level - distinct.back()).norm() > 1e-9) {
            distinct.push_back(level);
        }
    }
    return distinct;
}

}  // namespace

void smooth_curve(const std::vector<Vector3d>& points, std::vector<Vector3d>& out) {
    out.clear();
    const std::vector<Vector3d> through = level_and_distinct(points);
    if (through.empty()) {
        return;
    }
    out.push_back(through.front());
    const std::size_t last = through.size() - 1;
    for (std::size_t i = 0; i < last; ++i) {
        const Vector3d& from = through[i];
        const Vector3d& to = through[i + 1];
        // Beyond its ends the curve is continued straight.
        const Span span = span_of(i > 0 ? through[i - 1] : Vector3d(2.0 * from - to), from, to,
                                  i + 1 < last ? through[i + 2] : Vector3d(2.0 * to - from));
        const auto segments =
            static_cast<int>(std::min(kMaxSegments, std::ceil((to - from).norm() / kSegment)));
        for (int segment = 1; segment < segments; ++segment) {
            const double share = static_cast<double>(segment) / segments;
            out.push_back(span.at(span.knots[1] + share * (span.knots[2] - span.knots[1])));
        }
        out.push_back(to);
    }
}

}  // namespace campuswalk::engine

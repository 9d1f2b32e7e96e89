#include "collision/mover/upright_distance.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "collision/geometry/sweep.h"

namespace campuswalk::collision {

namespace {

/// Distances that differ by less count as equal, metres: otherwise rounding would decide.
constexpr double kTie = 1e-10;

bool above_inside(const Triangle& t, const Vec3& normal, const Vec3& point) {
    const auto left_of = [&](const Vec3& from, const Vec3& to) {
        return normal.dot((to - from).cross(point - from)) >= 0.0;
    };
    return left_of(t.a, t.b) && left_of(t.b, t.c) && left_of(t.c, t.a);
}

/// The closest points of an upright segment and an edge.
struct EdgePoints {
    Vec3 on_segment;
    Vec3 on_edge;
    double distance2;  ///< squared

    /// As their distances compare. Two different squares may have the same root.
    bool is_nearer_than(const EdgePoints& other) const {
        constexpr double kSurely = 1.0 - 1e-14;
        return distance2 < kSurely * other.distance2 ||
               (distance2 < other.distance2 && std::sqrt(distance2) < std::sqrt(other.distance2));
    }
};

EdgePoints to_edge(const Segment& s, const Vec3& from, const Vec3& to) {
    const Vec3 e = to - from;
    const double flat2 = e.x() * e.x() + e.z() * e.z();
    const double length2 = flat2 + e.y() * e.y();
    const auto along = [&](const Vec3& p) {
        return length2 > 0.0 ? std::clamp(e.dot(p - from) / length2, 0.0, 1.0) : 0.0;
    };
    // The point nearest as seen from above; the segment's end decides if that is above or below the segment.
    const double seen = e.x() * (s.a.x() - from.x()) + e.z() * (s.a.z() - from.z());
    double t = flat2 > 0.0 ? std::clamp(seen / flat2, 0.0, 1.0) : along(s.a);
    const double y = from.y() + t * e.y();
    if (y < s.a.y()) {
        t = along(s.a);
    } else if (y > s.b.y()) {
        t = along(s.b);
    }
    const Vec3 q = from + t * e;
    const Vec3 p(s.a.x(), std::clamp(q.y(), s.a.y(), s.b.y()), s.a.z());
    return {p, q, (p - q).squaredNorm()};
}

Closest to_edges(const Segment& upright, const Triangle& t) {
    EdgePoints best = to_edge(upright, t.a, t.b);
    for (const EdgePoints& other : {to_edge(upright, t.b, t.c), to_edge(upright, t.c, t.a)}) {
        if (other.is_nearer_than(best)) {
            best = other;
        }
    }
    return {best.on_segment, best.on_edge, std::sqrt(best.distance2), Feature::edge};
}

}  // namespace

Closest closest_upright(const Segment& upright, const Obstacle& obstacle) {
    const Triangle& t = obstacle.vertices;
    const Vec3& n = obstacle.normal;
    if (obstacle.solid != nullptr || n == Vec3::Zero()) {
        return closest(upright, obstacle);
    }
    const double at_a = n.dot(upright.a - t.a);
    const double at_b = n.dot(upright.b - t.a);
    if (at_a * at_b <= 0.0) {  // the face's plane passes through the segment
        const Vec3 at =
            at_a == at_b ? upright.a : Vec3(upright.a + at_a / (at_a - at_b) * (upright.b - upright.a));
        return at_a != at_b && above_inside(t, n, at) ? Closest{at, at, 0.0, Feature::face}
                                                      : to_edges(upright, t);
    }
    const double ahead = std::abs(at_b) - std::abs(at_a);
    const auto over = [&](const Vec3& end, double height) -> Closest {
        return {end, end - height * n, std::abs(height), Feature::face};
    };
    if (ahead <= kTie && above_inside(t, n, upright.b)) {
        return over(upright.b, at_b);
    }
    if (ahead >= -kTie && above_inside(t, n, upright.a)) {
        return over(upright.a, at_a);
    }
    return to_edges(upright, t);
}

std::optional<double> sweep_upright(const Segment& upright, double radius, const Vec3& move,
                                    const Obstacle& obstacle) {
    return first_touch(upright, radius, move,
                       [&](const Segment& moved) { return closest_upright(moved, obstacle); });
}

}  // namespace campuswalk::collision

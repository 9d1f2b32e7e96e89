#include "collision/geometry/closest.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace campuswalk::collision {

namespace {

/// A point of a solid in its own frame, with the part of the surface it lies on.
struct SolidPoint {
    Vec3 point = Vec3::Zero();
    Feature feature = Feature::face;
};

SolidPoint nearest_in(const Box& box, const Vec3& p) {
    const Vec3 q = p.cwiseMax(-box.half_extents).cwiseMin(box.half_extents);
    const int clamped = static_cast<int>((q.array() != p.array()).count());
    return {q, clamped <= 1 ? Feature::face : Feature::edge};
}

SolidPoint nearest_in(const Wheel& wheel, const Vec3& p) {
    const double x = std::clamp(p.x(), -wheel.half_width, wheel.half_width);
    const double rho = std::sqrt(p.y() * p.y() + p.z() * p.z());
    const bool outside = rho > wheel.radius;
    const double scale = outside ? wheel.radius / rho : 1.0;
    const bool on_rim = outside && x != p.x();
    return {Vec3(x, p.y() * scale, p.z() * scale), on_rim ? Feature::edge : Feature::face};
}

/// The distance to a convex solid is a convex function along the segment.
template <typename Solid>
Closest closest_to_solid(const Segment& segment, const Solid& solid, const Pose& X_world_shape) {
    const Vec3 a = X_world_shape.inverse_apply(segment.a);
    const Vec3 b = X_world_shape.inverse_apply(segment.b);
    const auto point_at = [&](double s) { return Vec3(a + s * (b - a)); };
    const double s = minimise_convex([&](double t) {
        const Vec3 p = point_at(t);
        return (p - nearest_in(solid, p).point).squaredNorm();
    });
    const Vec3 p = point_at(s);
    const SolidPoint nearest = nearest_in(solid, p);
    return {X_world_shape * p, X_world_shape * nearest.point, (p - nearest.point).norm(), nearest.feature};
}

/// Whether the segment passes through the triangle, and where.
bool pierces(const Segment& segment, const Triangle& t, Vec3& at) {
    const Vec3 n = (t.b - t.a).cross(t.c - t.a);
    const double da = n.dot(segment.a - t.a);
    const double db = n.dot(segment.b - t.a);
    if (da * db > 0.0 || da == db) {
        return false;
    }
    at = segment.a + (da / (da - db)) * (segment.b - segment.a);
    return n.dot((t.b - t.a).cross(at - t.a)) >= 0.0 && n.dot((t.c - t.b).cross(at - t.b)) >= 0.0 &&
           n.dot((t.a - t.c).cross(at - t.c)) >= 0.0;
}

}  // namespace

Vec3 closest_on_segment(const Segment& segment, const Vec3& point) {
    const Vec3 d = segment.b - segment.a;
    const double length2 = d.squaredNorm();
    if (length2 <= 0.0) {
        return segment.a;
    }
    return segment.a + std::clamp(d.dot(point - segment.a) / length2, 0.0, 1.0) * d;
}

Vec3 closest_on_triangle(const Triangle& t, const Vec3& p, Feature& feature) {
    feature = Feature::edge;
    const Vec3 ab = t.b - t.a;
    const Vec3 ac = t.c - t.a;
    const double d1 = ab.dot(p - t.a);
    const double d2 = ac.dot(p - t.a);
    if (d1 <= 0.0 && d2 <= 0.0) {
        return t.a;
    }
    const double d3 = ab.dot(p - t.b);
    const double d4 = ac.dot(p - t.b);
    if (d3 >= 0.0 && d4 <= d3) {
        return t.b;
    }
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
        return t.a + (d1 / (d1 - d3)) * ab;
    }
    const double d5 = ab.dot(p - t.c);
    const double d6 = ac.dot(p - t.c);
    if (d6 >= 0.0 && d5 <= d6) {
        return t.c;
    }
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
        return t.a + (d2 / (d2 - d6)) * ac;
    }
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
        return t.b + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (t.c - t.b);
    }
    feature = Feature::face;
    const double total = va + vb + vc;
    return t.a + (vb / total) * ab + (vc / total) * ac;
}

Closest closest(const Segment& s, const Segment& t) {
    const Vec3 d1 = s.b - s.a;
    const Vec3 d2 = t.b - t.a;
    const Vec3 r = s.a - t.a;
    const double a = d1.squaredNorm();
    const double e = d2.squaredNorm();
    const double f = d2.dot(r);
    double u = 0.0;
    double v = 0.0;
    if (a <= 0.0) {
        v = e <= 0.0 ? 0.0 : std::clamp(f / e, 0.0, 1.0);
    } else {
        const double c = d1.dot(r);
        if (e <= 0.0) {
            u = std::clamp(-c / a, 0.0, 1.0);
        } else {
            const double b = d1.dot(d2);
            const double denominator = a * e - b * b;
            u = denominator > 0.0 ? std::clamp((b * f - c * e) / denominator, 0.0, 1.0) : 0.0;
            v = (b * u + f) / e;
            if (v < 0.0) {
                v = 0.0;
                u = std::clamp(-c / a, 0.0, 1.0);
            } else if (v > 1.0) {
                v = 1.0;
                u = std::clamp((b - c) / a, 0.0, 1.0);
            }
        }
    }
    const Vec3 p = s.a + u * d1;
    const Vec3 q = t.a + v * d2;
    return {p, q, (p - q).norm(), Feature::edge};
}

Closest closest(const Segment& segment, const Triangle& t) {
    const bool is_point = segment.a == segment.b;  // pierces nothing, and both ends are the same
    Vec3 crossing;
    if (!is_point && pierces(segment, t, crossing)) {
        return {crossing, crossing, 0.0, Feature::face};
    }
    // Beside a wall parallel to the segment all distances are equal and rounding would decide: the face wins
    // there, because its normal can be trusted.
    constexpr double kTie = 1e-10;  // metres
    Closest best;
    best.distance = 1e300;
    const auto offer = [&](const Closest& c) {
        const double ahead = best.feature == c.feature ? 0.0 : (c.feature == Feature::face ? kTie : -kTie);
        if (c.distance < best.distance + ahead) {
            best = c;
        }
    };
    const auto offer_end = [&](const Vec3& end) {
        Feature feature = Feature::face;
        const Vec3 q = closest_on_triangle(t, end, feature);
        offer({end, q, (end - q).norm(), feature});
    };
    offer_end(segment.a);
    if (!is_point) {
        offer_end(segment.b);
    }
    offer(closest(segment, Segment{t.a, t.b}));
    offer(closest(segment, Segment{t.b, t.c}));
    offer(closest(segment, Segment{t.c, t.a}));
    return best;
}

Closest closest(const Segment& segment, const Sphere& sphere, const Pose& X_world_shape) {
    const Vec3& center = X_world_shape.translation;
    const Vec3 p = closest_on_segment(segment, center);
    const double to_center = (p - center).norm();
    if (to_center <= sphere.radius) {
        return {p, p, 0.0, Feature::face};
    }
    const Vec3 q = center + (sphere.radius / to_center) * (p - center);
    return {p, q, to_center - sphere.radius, Feature::face};
}

Closest closest(const Segment& segment, const Capsule& capsule, const Pose& X_world_shape) {
    const Vec3 half = X_world_shape.rotate(Vec3(0.0, capsule.half_length, 0.0));
    const Segment axis{X_world_shape.translation - half, X_world_shape.translation + half};
    const Closest to_axis = closest(segment, axis);
    if (to_axis.distance <= capsule.radius) {
        return {to_axis.on_segment, to_axis.on_segment, 0.0, Feature::face};
    }
    const Vec3 outward = (to_axis.on_segment - to_axis.on_shape) / to_axis.distance;
    return {to_axis.on_segment, to_axis.on_shape + capsule.radius * outward,
            to_axis.distance - capsule.radius, Feature::face};
}

Closest closest(const Segment& segment, const Box& box, const Pose& X_world_shape) {
    return closest_to_solid(segment, box, X_world_shape);
}

Closest closest(const Segment& segment, const Wheel& wheel, const Pose& X_world_shape) {
    return closest_to_solid(segment, wheel, X_world_shape);
}

}  // namespace campuswalk::collision

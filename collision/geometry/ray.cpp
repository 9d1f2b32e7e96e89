#include "collision/geometry/ray.h"

#include <algorithm>
#include <cmath>

namespace campuswalk::collision {

namespace {

/// The part [enter, leave] of a ray inside something, empty when enter > leave.
struct Span {
    double enter = 0.0;
    double leave = 1.0;

    void clip(const Span& o) {
        enter = std::max(enter, o.enter);
        leave = std::min(leave, o.leave);
    }
    bool empty() const { return enter > leave; }
};

constexpr Span kNothing{1.0, 0.0};

/// Where |from + f * step| <= half.
Span between(double from, double step, double half) {
    if (step == 0.0) {
        return std::abs(from) <= half ? Span{} : kNothing;
    }
    const double s = (-half - from) / step;
    const double t = (half - from) / step;
    return {std::min(s, t), std::max(s, t)};
}

/// Where a f^2 + 2 b f + c <= 0.
Span below_zero(double a, double b, double c) {
    if (a <= 0.0) {
        return c <= 0.0 ? Span{} : kNothing;
    }
    const double discriminant = b * b - a * c;
    if (discriminant < 0.0) {
        return kNothing;
    }
    const double root = std::sqrt(discriminant);
    return {(-b - root) / a, (-b + root) / a};
}

Span in_ball(const Ray& ray, const Vec3& center, double radius) {
    const Vec3 d = ray.to - ray.from;
    const Vec3 o = ray.from - center;
    return below_zero(d.squaredNorm(), d.dot(o), o.squaredNorm() - radius * radius);
}

std::optional<double> entry(Span span) {
    span.clip(Span{});
    return span.empty() ? std::nullopt : std::optional(span.enter);
}

}  // namespace

std::optional<double> hit(const Ray& ray, const Triangle& t) {
    const Vec3 d = ray.to - ray.from;
    int kz = 0;
    if (d.cwiseAbs().maxCoeff(&kz) <= 0.0) {
        return std::nullopt;
    }
    int kx = (kz + 1) % 3;
    int ky = (kx + 1) % 3;
    if (d[kz] < 0.0) {
        std::swap(kx, ky);
    }
    // Shear the ray onto the z axis; the sign of each edge then comes from one expression in its two ends, so
    // that neighbouring triangles agree.
    const double sx = d[kx] / d[kz];
    const double sy = d[ky] / d[kz];
    const auto shear_x = [&](const Vec3& p) { return (p[kx] - ray.from[kx]) - sx * (p[kz] - ray.from[kz]); };
    const auto shear_y = [&](const Vec3& p) { return (p[ky] - ray.from[ky]) - sy * (p[kz] - ray.from[kz]); };
    const double ax = shear_x(t.a), ay = shear_y(t.a);
    const double bx = shear_x(t.b), by = shear_y(t.b);
    const double cx = shear_x(t.c), cy = shear_y(t.c);
    const double u = cx * by - cy * bx;
    const double v = ax * cy - ay * cx;
    const double w = bx * ay - by * ax;
    if ((u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0)) {
        return std::nullopt;
    }
    const double determinant = u + v + w;
    if (determinant == 0.0) {
        return std::nullopt;
    }
    const double depth =
        (u * (t.a[kz] - ray.from[kz]) + v * (t.b[kz] - ray.from[kz]) + w * (t.c[kz] - ray.from[kz]));
    const double fraction = depth / (determinant * d[kz]);
    if (!(fraction >= 0.0 && fraction <= 1.0)) {
        return std::nullopt;
    }
    return fraction;
}

std::optional<double> hit(const Ray& ray, const Box& box) {
    const Vec3 d = ray.to - ray.from;
    Span span;
    for (int axis = 0; axis < 3; ++axis) {
        span.clip(between(ray.from[axis], d[axis], box.half_extents[axis]));
    }
    return entry(span);
}

std::optional<double> hit(const Ray& ray, const Sphere& sphere) {
    return entry(in_ball(ray, Vec3::Zero(), sphere.radius));
}

std::optional<double> hit(const Ray& ray, const Wheel& wheel) {
    const Vec3 d = ray.to - ray.from;
    const Vec3& o = ray.from;
    Span span = below_zero(d.y() * d.y() + d.z() * d.z(), d.y() * o.y() + d.z() * o.z(),
                           o.y() * o.y() + o.z() * o.z() - wheel.radius * wheel.radius);
    span.clip(between(o.x(), d.x(), wheel.half_width));
    return entry(span);
}

std::optional<double> hit(const Ray& ray, const Capsule& capsule) {
    // The union of a cylinder and two spheres is convex, so the first entry of any part is the entry.
    const Vec3 d = ray.to - ray.from;
    const Vec3& o = ray.from;
    Span barrel = below_zero(d.x() * d.x() + d.z() * d.z(), d.x() * o.x() + d.z() * o.z(),
                             o.x() * o.x() + o.z() * o.z() - capsule.radius * capsule.radius);
    barrel.clip(between(o.y(), d.y(), capsule.half_length));
    std::optional<double> first = entry(barrel);
    for (const double end : {-capsule.half_length, capsule.half_length}) {
        const std::optional<double> f = entry(in_ball(ray, Vec3(0.0, end, 0.0), capsule.radius));
        if (f && (!first || *f < *first)) {
            first = f;
        }
    }
    return first;
}

}  // namespace campuswalk::collision

#include "collision/geometry/convex_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <Eigen/Geometry>

namespace campuswalk::collision {

namespace {

/// The sum of some dozens of roundings, relative to the sizes of the numbers rounded.
constexpr double kRounding = 8e-15;

/// Up to four points of a convex body, and the part of their hull that is nearest to the origin.
class Simplex {
public:
    void add(const Vec3& vertex) { vertex_[count_++] = vertex; }

    /// The point of the hull that is nearest to the origin. Only the vertices that span it remain, so that
    /// there is room for another, unless it is the origin itself.
    Vec3 reduce() {
        Vec3 nearest = vertex_[0];
        unsigned spanning = 1;
        for (unsigned chosen = 2; chosen < 1U << count_; ++chosen) {
            const std::optional<Vec3> point = nearest_inside(chosen);
            if (point && point->squaredNorm() < nearest.squaredNorm()) {
                nearest = *point;
                spanning = chosen;
            }
        }
        retain(spanning);
        return nearest;
    }

private:
    void retain(unsigned chosen) {
        std::size_t count = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            if ((chosen >> i & 1U) != 0) {
                vertex_[count++] = vertex_[i];
            }
        }
        count_ = count;
    }

    /// The nearest point of the chosen vertices' plane (or line, or space) if it lies inside their hull. As a
    /// weighted mean of the vertices it isn't too near, however the weights are rounded.
    std::optional<Vec3> nearest_inside(unsigned chosen) const {
        std::array<Vec3, 4> p;
        std::size_t count = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            if ((chosen >> i & 1U) != 0) {
                p[count++] = vertex_[i];
            }
        }
        switch (count) {
            case 1:
                return p[0];
            case 2:
                return inside(p[0], p[1]);
            case 3:
                return inside(p[0], p[1], p[2]);
            default:
                return inside(p[0], p[1], p[2], p[3]);
        }
    }

    static std::optional<Vec3> inside(const Vec3& a, const Vec3& b) {
        const Vec3 along = b - a;
        const double part = -a.dot(along) / along.squaredNorm();
        return part > 0.0 && part < 1.0 ? std::optional<Vec3>(a + part * along) : std::nullopt;
    }

    static std::optional<Vec3> inside(const Vec3& a, const Vec3& b, const Vec3& c) {
        const Vec3 normal = (b - a).cross(c - a);
        const Vec3 foot = (a.dot(normal) / normal.squaredNorm()) * normal;
        // Relative to the foot: the vertices may be far closer to each other than to the origin.
        const Vec3 p = a - foot;
        const Vec3 q = b - foot;
        const Vec3 r = c - foot;
        const Vec3 weights(normal.dot(q.cross(r)), normal.dot(r.cross(p)), normal.dot(p.cross(q)));
        if (!(weights.minCoeff() > 0.0)) {
            return std::nullopt;
        }
        return (weights.x() * a + weights.y() * b + weights.z() * c) / weights.sum();
    }

    /// The origin, if it is certainly inside.
    static std::optional<Vec3> inside(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
        const double size = a.norm() * b.norm() * c.norm() * d.norm();
        const std::array<double, 4> volumes = {b.dot(c.cross(d)) * a.norm(), -a.dot(c.cross(d)) * b.norm(),
                                               a.dot(b.cross(d)) * c.norm(), -a.dot(b.cross(c)) * d.norm()};
        const auto [least, most] = std::minmax_element(volumes.begin(), volumes.end());
        const bool all_on_one_side = *least > kRounding * size || *most < -kRounding * size;
        return all_on_one_side ? std::optional<Vec3>(Vec3::Zero()) : std::nullopt;
    }

    std::array<Vec3, 4> vertex_;
    std::size_t count_ = 0;
};

/// A distance, and the size of the numbers that it was computed from.
struct Gap {
    double distance = 0.0;
    double size = 0.0;

    /// The distance less both bodies' radii; 0 if rounding can't distinguish it from contact.
    double minus(double radii) const {
        const double left = distance - radii;
        return left > kRounding * (size + radii) ? left : 0.0;
    }
};

/// The distance of the origin from a convex body (Gilbert, Johnson, Keerthi 1988): repeatedly adds the body's
/// farthest point in the direction from the nearest point so far towards the origin. `farthest` returns the
/// body's farthest point along a direction.
template <typename Farthest>
Gap gap_to_origin(const Farthest& farthest) {
    constexpr int kMaxSteps = 256;  // round bodies that barely touch converge slowly
    Simplex simplex;
    simplex.add(farthest(Vec3::UnitX()));
    Vec3 nearest = simplex.reduce();
    double size = nearest.norm();
    double at_least = 0.0;
    for (int i = 0; i < kMaxSteps; ++i) {
        const double distance = nearest.norm();
        if (distance <= kRounding * size) {
            return {0.0, size};
        }
        const Vec3 next = farthest(-nearest / distance);
        size = std::max(size, next.norm());
        // No point of the body is nearer than this plane.
        at_least = std::max(at_least, nearest.dot(next) / distance);
        if (distance - at_least <= 0.5 * kRounding * size) {
            break;
        }
        simplex.add(next);
        const Vec3 nearer = simplex.reduce();
        if (!(nearer.squaredNorm() < nearest.squaredNorm())) {
            break;
        }
        nearest = nearer;
    }
    // Where round edges touch, the search may end slightly beside the contact; but no plane separates them.
    return {at_least > kRounding * size ? nearest.norm() : 0.0, size};
}

/// The core's farthest point along `direction`, relative to its centre.
Vec3 farthest_of(const ConvexSolid& solid, const Vec3& direction) {
    const Vec3 d = solid.X_world_solid.inverse_rotate(direction);
    Vec3 p = (d.array() < 0.0).select(-solid.half_extents, solid.half_extents);
    const double across = std::sqrt(d.y() * d.y() + d.z() * d.z());
    if (across > 0.0) {
        p.y() += solid.disc * (d.y() / across);
        p.z() += solid.disc * (d.z() / across);
    }
    return solid.X_world_solid.rotate(p);
}

}  // namespace

ConvexSolid convex_solid(const Box& box, const Pose& X_world_shape) {
    return {X_world_shape, box.half_extents, 0.0, 0.0};
}

ConvexSolid convex_solid(const Sphere& sphere, const Pose& X_world_shape) {
    return {X_world_shape, Vec3::Zero(), 0.0, sphere.radius};
}

ConvexSolid convex_solid(const Capsule& capsule, const Pose& X_world_shape) {
    return {X_world_shape, Vec3(0.0, capsule.half_length, 0.0), 0.0, capsule.radius};
}

ConvexSolid convex_solid(const Wheel& wheel, const Pose& X_world_shape) {
    return {X_world_shape, Vec3(wheel.half_width, 0.0, 0.0), wheel.radius, 0.0};
}

// The distance of two bodies is that of the origin from their Minkowski difference.

double distance_between(const ConvexSolid& a, const ConvexSolid& b) {
    const Vec3 between = a.X_world_solid.translation - b.X_world_solid.translation;
    const auto farthest = [&](const Vec3& direction) {
        return Vec3(between + farthest_of(a, direction) - farthest_of(b, -direction));
    };
    return gap_to_origin(farthest).minus(a.radius + b.radius);
}

double distance_between(const ConvexSolid& solid, const Triangle& triangle) {
    const Vec3& center = solid.X_world_solid.translation;
    const std::array<Vec3, 3> vertices = {triangle.a - center, triangle.b - center, triangle.c - center};
    const auto farthest = [&](const Vec3& direction) {
        const auto is_nearer = [&](const Vec3& p, const Vec3& q) {
            return p.dot(direction) < q.dot(direction);
        };
        const Vec3& vertex = *std::max_element(vertices.begin(), vertices.end(), is_nearer);
        return Vec3(vertex - farthest_of(solid, -direction));
    };
    return gap_to_origin(farthest).minus(solid.radius);
}

}  // namespace campuswalk::collision

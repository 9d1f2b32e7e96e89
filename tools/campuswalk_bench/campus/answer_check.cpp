#include "tools/campuswalk_bench/campus/answer_check.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "collision/geometry/closest.h"

namespace campuswalk::tools::bench {

using collision::Ray;
using collision::Triangle;
using collision::TriangleMesh;
using collision::Vec3;

namespace {

constexpr double kSameHit = 1e-3;      ///< metres along the ray
constexpr double kSideways = 1e-4;     ///< metres
constexpr double kSameSurface = 1e-6;  ///< metres: FCL's own tolerance

struct Hit {
    double fraction = 1.0;  ///< of the ray; 1 if there is no hit
    double slant = 0.0;     ///< metres along the ray per metre sideways, at most
};

double slant_of(const Triangle& t, const Vec3& direction) {
    const Vec3 normal = (t.b - t.a).cross(t.c - t.a);
    return normal.norm() / std::max(std::abs(normal.dot(direction)), 1e-30);
}

Hit first_hit(const TriangleMesh& mesh, const Ray& ray) {
    const Vec3 direction = (ray.to - ray.from).normalized();
    Hit first;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle t = vertices(mesh, i);
        if (const auto fraction = hit(ray, t); fraction && *fraction < first.fraction) {
            first = {*fraction, slant_of(t, direction)};
        }
    }
    return first;
}

}  // namespace

bool same_hit(const Ray& ray, std::optional<double> a, std::optional<double> b) {
    return std::abs(a.value_or(1.0) - b.value_or(1.0)) * (ray.to - ray.from).norm() <= kSameHit;
}

bool is_first_hit(const TriangleMesh& mesh, const Ray& ray, std::optional<double> fraction) {
    const Vec3 along = ray.to - ray.from;
    const Vec3 side = kSideways * along.unitOrthogonal();
    const Vec3 up = kSideways * along.cross(side).normalized();
    for (const Vec3& shift : {Vec3(0, 0, 0), side, Vec3(-side), up, Vec3(-up)}) {
        const Hit first = first_hit(mesh, {ray.from + shift, ray.to + shift});
        const double apart = std::abs(first.fraction - fraction.value_or(1.0)) * along.norm();
        if (apart <= kSameHit + kSideways * first.slant) {
            return true;
        }
    }
    return false;
}

bool is_touching_set(const TriangleMesh& mesh, const collision::Segment& segment, double radius,
                     const std::vector<std::uint32_t>& triangles) {
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const double gap = closest(segment, vertices(mesh, i)).distance - radius;
        const bool is_listed = std::binary_search(triangles.begin(), triangles.end(), i);
        if (std::abs(gap) > kSameSurface && is_listed != (gap < 0.0)) {
            return false;
        }
    }
    return true;
}

}  // namespace campuswalk::tools::bench

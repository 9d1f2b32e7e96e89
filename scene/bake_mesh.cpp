#include "scene/bake_mesh.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "scene/weld.h"

namespace campuswalk::scene {
namespace {

using collision::Vec3;

// Well below what float32 resolves a metre from the origin: such a triangle can't be stood on or bumped into.
constexpr double kThinnest = 1e-7;

Vec3 whole_millimetres(const Vec3& point) {
    return (point * 1000.0).array().round() / 1000.0;
}

/// Height over the longest edge.
double thickness(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const double longest = std::sqrt(std::max({ab.squaredNorm(), ac.squaredNorm(), (c - b).squaredNorm()}));
    return longest > 0.0 ? ab.cross(ac).norm() / longest : 0.0;
}

}  // namespace

BakedMesh bake_mesh(const WorldGeometry& geometry) {
    BakedMesh baked;
    collision::Aabb bounds;
    for (const auto& triangle : geometry.triangles) {
        for (const std::uint32_t vertex : triangle) {
            bounds.extend(geometry.positions[vertex]);
        }
    }
    if (bounds.empty()) {
        return baked;
    }
    baked.p_world_origin = whole_millimetres(0.5 * (bounds.min + bounds.max));

    WeldTable<3> welded(geometry.positions.size());
    auto& positions = baked.mesh.positions;
    for (const auto& triangle : geometry.triangles) {
        std::array<Eigen::Vector3f, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            corners[k] = (geometry.positions[triangle[k]] - baked.p_world_origin).cast<float>();
        }
        if (thickness(corners[0].cast<double>(), corners[1].cast<double>(), corners[2].cast<double>()) <
            kThinnest) {
            ++baked.zero_area;
            continue;
        }
        std::array<std::uint32_t, 3> numbers{};
        for (std::size_t k = 0; k < 3; ++k) {
            numbers[k] = welded.number_of(bits_of(corners[k]));
            if (numbers[k] == positions.size()) {
                positions.push_back(corners[k]);
            }
        }
        baked.mesh.triangles.push_back(numbers);
    }
    return baked;
}

}  // namespace campuswalk::scene

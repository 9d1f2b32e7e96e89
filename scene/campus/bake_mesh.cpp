#include "scene/campus/bake_mesh.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "scene/model/weld.h"

namespace campuswalk::scene {
namespace {

using collision::Vec3;

// Well below what float32 resolves a metre from the origin: such a triangle can't be stood on or bumped into.
constexpr double kMinThickness = 1e-7;  // metres

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

/// The bounds of all triangles' vertices.
collision::Aabb bounds_of(const WorldGeometry& geometry) {
    collision::Aabb bounds;
    for (const auto& triangle : geometry.triangles) {
        for (const std::uint32_t vertex : triangle) {
            bounds.extend(geometry.positions[vertex]);
        }
    }
    return bounds;
}

bool float_holds(const WorldGeometry& geometry) {
    return std::ranges::all_of(geometry.positions, [](const Vec3& position) {
        return position.cast<float>().cast<double>() == position;
    });
}

using TriangleInFloats = std::array<Eigen::Vector3f, 3>;

TriangleInFloats about(const Vec3& origin, const Vec3& a, const Vec3& b, const Vec3& c) {
    return {(a - origin).cast<float>(), (b - origin).cast<float>(), (c - origin).cast<float>()};
}

bool is_thick(const TriangleInFloats& vertices) {
    return thickness(vertices[0].cast<double>(), vertices[1].cast<double>(), vertices[2].cast<double>()) >=
           kMinThickness;
}

/// Adds the triangles for which `is_included(vertices)`, relative to the mesh's origin.
template <typename IsIncluded>
void add_triangles(const WorldGeometry& geometry, BakedMesh& baked, const IsIncluded& is_included) {
    WeldTable<3> welded(geometry.positions.size());
    auto& positions = baked.mesh.positions;
    for (const auto& triangle : geometry.triangles) {
        const TriangleInFloats vertices =
            about(baked.p_world_origin, geometry.positions[triangle[0]], geometry.positions[triangle[1]],
                  geometry.positions[triangle[2]]);
        if (!is_included(vertices)) {
            continue;
        }
        std::array<std::uint32_t, 3> numbers{};
        for (std::size_t k = 0; k < 3; ++k) {
            numbers[k] = welded.number_of(bits_of(vertices[k]));
            if (numbers[k] == positions.size()) {
                positions.push_back(vertices[k]);
            }
        }
        baked.mesh.triangles.push_back(numbers);
    }
}

}  // namespace

BakedMesh bake_mesh(const WorldGeometry& geometry) {
    BakedMesh baked;
    const collision::Aabb bounds = bounds_of(geometry);
    if (bounds.empty()) {
        return baked;
    }
    baked.p_world_origin = whole_millimetres(bounds.center());
    add_triangles(geometry, baked, [&](const TriangleInFloats& vertices) {
        const bool thick = is_thick(vertices);
        baked.zero_area += thick ? 0U : 1U;
        return thick;
    });
    return baked;
}

bool is_baked(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p_world_origin) {
    return is_thick(about(p_world_origin, a, b, c));
}

BakedMesh bake_every_triangle(const WorldGeometry& geometry) {
    BakedMesh baked;
    const collision::Aabb bounds = bounds_of(geometry);
    if (!bounds.empty() && !float_holds(geometry)) {
        baked.p_world_origin = whole_millimetres(bounds.center());
    }
    add_triangles(geometry, baked, [](const TriangleInFloats&) { return true; });
    return baked;
}

}  // namespace campuswalk::scene

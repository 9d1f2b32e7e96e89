#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace campuswalk::scene {

/// The t at which the line `origin` + t * `direction` intersects the triangle, edges included, from either
/// side; nullopt if it misses or is parallel. Möller and Trumbore, "Fast, Minimum Storage Ray/Triangle
/// Intersection", 1997.
inline std::optional<double> line_through_triangle(const std::array<Eigen::Vector3d, 3>& vertices,
                                                   const Eigen::Vector3d& origin,
                                                   const Eigen::Vector3d& direction) {
    const Eigen::Vector3d e1 = vertices[1] - vertices[0];
    const Eigen::Vector3d e2 = vertices[2] - vertices[0];
    const Eigen::Vector3d p = direction.cross(e2);
    const double determinant = e1.dot(p);
    if (determinant == 0.0) {
        return std::nullopt;
    }
    const Eigen::Vector3d offset = origin - vertices[0];
    const double u = offset.dot(p) / determinant;
    const Eigen::Vector3d q = offset.cross(e1);
    const double v = direction.dot(q) / determinant;
    if (!(u >= 0.0 && v >= 0.0 && u + v <= 1.0)) {
        return std::nullopt;
    }
    return e2.dot(q) / determinant;
}

}  // namespace campuswalk::scene

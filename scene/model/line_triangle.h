#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace campuswalk::scene {

/// The t at which the line `from` + t * `way` goes through the triangle, edges included, from either side;
/// nullopt where it passes it by or lies in its plane. Möller and Trumbore, "Fast, Minimum Storage
/// Ray/Triangle Intersection", 1997.
inline std::optional<double> line_through_triangle(const std::array<Eigen::Vector3d, 3>& corners,
                                                   const Eigen::Vector3d& from, const Eigen::Vector3d& way) {
    const Eigen::Vector3d e1 = corners[1] - corners[0];
    const Eigen::Vector3d e2 = corners[2] - corners[0];
    const Eigen::Vector3d p = way.cross(e2);
    const double determinant = e1.dot(p);
    if (determinant == 0.0) {
        return std::nullopt;
    }
    const Eigen::Vector3d offset = from - corners[0];
    const double u = offset.dot(p) / determinant;
    const Eigen::Vector3d q = offset.cross(e1);
    const double v = way.dot(q) / determinant;
    if (!(u >= 0.0 && v >= 0.0 && u + v <= 1.0)) {
        return std::nullopt;
    }
    return e2.dot(q) / determinant;
}

}  // namespace campuswalk::scene

#pragma once

#include <cstdint>
#include <span>

#include "collision/geometry/shapes.h"
#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::collision {

/// Every bounding volume is enlarged by this fraction of the coordinates' size, 9,000 units in the last
/// place: far more than the rounding of the sums that produce it and of the tests that use it, far less than
/// anything visible. A volume may be too large, never too small.
inline constexpr double kOutward = 1e-12;

/// A node's outer layer.
struct BoundingSphere {
    Vec3 center = Vec3::Zero();
    double radius = 0.0;
};

/// A node's inner layer: the box, and the sphere about the box's centre.
struct OrientedBox {
    Vec3 center = Vec3::Zero();
    Mat3 axes = Mat3::Identity();  ///< columns, orthonormal
    Vec3 half_extents = Vec3::Zero();
    double radius = 0.0;  ///< of the inner sphere: from `center` to the farthest vertex
};

/// Centre of the inscribed circle: the vertices weighted by the lengths of the opposite edges. For a triangle
/// without extent, its vertex.
inline Vec3 incentre(const Triangle& t) {
    // Four at a time, because square roots are slow.
    const Eigen::Array4d length =
        Eigen::Array4d((t.b - t.c).squaredNorm(), (t.c - t.a).squaredNorm(), (t.a - t.b).squaredNorm(), 0.0)
            .sqrt();
    const double perimeter = length[0] + length[1] + length[2];
    if (perimeter <= 0.0) {
        return t.a;
    }
    return (length[0] * t.a + length[1] * t.b + length[2] * t.c) / perimeter;
}

/// A sphere that contains all points within sqrt(`squared`) of its centre.
BoundingSphere sphere_about(const Vec3& center, double squared);

/// Outer sphere (paper III.A.1): centre = mean of the triangles' incentres, radius to the farthest vertex.
BoundingSphere fit_outer_sphere(const TriangleMesh& mesh, std::span<const std::uint32_t> triangles);

/// Inner layer (paper III.A.2): axes = eigenvectors of the vertices' covariance, extents by projection.
///
/// The paper's eq. (3) sums products of the coordinates themselves; a covariance is relative to the mean of
/// eq. (2), as here (and as in Gottschalk, Lin, Manocha 1996): otherwise the first axis of a mesh far from
/// its origin would point at the origin instead of along the mesh.
OrientedBox fit_inner_box(const TriangleMesh& mesh, std::span<const std::uint32_t> triangles);

}  // namespace campuswalk::collision

#pragma once

#include <span>

#include "collision/bvh8/bvh8.h"
#include "collision/bvh8/lane_bounds.h"
#include "collision/geometry/shapes.h"

namespace campuswalk::collision {

/// Sums over points about an origin, of which the sum for many parts is the sum of theirs.
struct PointMoments {
    double count = 0.0;
    Eigen::Array3d sum = Eigen::Array3d::Zero();
    Eigen::Array3d squares = Eigen::Array3d::Zero();
    Eigen::Array3d mixed = Eigen::Array3d::Zero();  ///< xy, yz, zx

    void add(const Vec3& point);
    void add(const PointMoments& o);
    Mat3 covariance() const;
};

/// What is below a child. Vertices are those of its leaves; what leaves share counts for each of them.
struct Held {
    std::span<const Lanes> vertices;
    LaneBounds bounds;
    PointMoments moments;
};

/// What a leaf holds, moments about `origin`.
Held hold(std::span<const Lanes> vertices, const Vec3& origin);

/// What children hold together, whose corners lie side by side in memory, in any order.
Held hold(std::span<const Held> children);

/// The outer sphere of a mesh that has these corners.
BoundingSphere sphere_about(const Vec3& center, std::span<const Lanes> vertices);

/// Sets the frame of a `node` that knows its children, and the boxes of its children, which hold `all`
/// together. The frame is that of the corners' principal axes (paper III.A.2) or the mesh's own, whichever
/// makes the smaller boxes.
void fit_node(Bvh8Node& node, std::span<const Held> children, const Held& all);

}  // namespace campuswalk::collision

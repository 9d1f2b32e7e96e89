#pragma once

#include <span>

#include "collision/bvh8/bvh8.h"
#include "collision/bvh8/lane_bounds.h"
#include "collision/geometry/shapes.h"

namespace campuswalk::collision {

/// Sums over points relative to an origin; those of several parts add up.
struct PointMoments {
    double count = 0.0;
    Eigen::Array3d sum = Eigen::Array3d::Zero();
    Eigen::Array3d squares = Eigen::Array3d::Zero();
    Eigen::Array3d mixed = Eigen::Array3d::Zero();  ///< xy, yz, zx

    void add(const Vec3& point);
    void add(const PointMoments& o);
    Mat3 covariance() const;
};

/// What is below a child. The vertices are those of its leaves; shared ones count for each leaf.
struct Contents {
    std::span<const Lanes> vertices;
    LaneBounds bounds;
    PointMoments moments;
};

/// The contents of a leaf, with moments about `origin`.
Contents contents_of(std::span<const Lanes> vertices, const Vec3& origin);

/// The contents of several children, whose vertices are contiguous in memory, in any order.
Contents contents_of(std::span<const Contents> children);

/// The outer sphere of a mesh with these vertices.
BoundingSphere sphere_about(const Vec3& center, std::span<const Lanes> vertices);

/// Sets the frame of a `node` and the boxes of its children, whose contents together are `all`. The frame is
/// that of the vertices' principal axes (paper III.A.2) or the mesh's own, whichever makes the boxes smaller.
void fit_node(Bvh8Node& node, std::span<const Contents> children, const Contents& all);

}  // namespace campuswalk::collision

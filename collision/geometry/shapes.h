#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <variant>

#include <Eigen/Core>

namespace campuswalk::collision {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

class MeshCollider;

inline double horizontal_norm(const Vec3& v) {
    return std::sqrt(v.x() * v.x() + v.z() * v.z());
}

/// A rigid transform that maps shape coordinates to the frame it is named for (X_world_shape).
/// Not Eigen::Isometry3d, whose alignment depends on compiler flags.
struct Pose {
    Mat3 rotation = Mat3::Identity();
    Vec3 translation = Vec3::Zero();

    Vec3 operator*(const Vec3& p) const { return rotation * p + translation; }
    Vec3 rotate(const Vec3& v) const { return rotation * v; }
    Vec3 inverse_rotate(const Vec3& v) const { return rotation.transpose() * v; }
    Vec3 inverse_apply(const Vec3& p) const { return rotation.transpose() * (p - translation); }
};

/// Axis-aligned box, world coordinates, metres.
struct Aabb {
    Vec3 min = Vec3::Constant(1e300);
    Vec3 max = Vec3::Constant(-1e300);

    bool empty() const { return min.x() > max.x(); }
    Vec3 center() const { return 0.5 * (min + max); }
    void extend(const Vec3& p) {
        min = min.cwiseMin(p);
        max = max.cwiseMax(p);
    }
    void extend(const Aabb& o) {
        min = min.cwiseMin(o.min);
        max = max.cwiseMax(o.max);
    }
    Aabb grown(double margin) const { return {min.array() - margin, max.array() + margin}; }
    bool overlaps(const Aabb& o) const {
        return (min.array() <= o.max.array()).all() && (o.min.array() <= max.array()).all();
    }
};

/// With a radius: the avatar, and every capsule collider once posed.
struct Segment {
    Vec3 a = Vec3::Zero();
    Vec3 b = Vec3::Zero();
};

/// The axis of an upright capsule that stands at `foot`, between the centres of its caps.
inline Segment upright_axis(const Vec3& foot, double radius, double height) {
    return {foot + Vec3(0, radius, 0), foot + Vec3(0, height - radius, 0)};
}

// Convex solids about their pose's origin, metres.

struct Box {
    Vec3 half_extents = Vec3::Constant(0.5);
};

struct Sphere {
    double radius = 0.5;
};

/// Along the pose's Y axis; `half_length` is half the segment between the cap centres.
struct Capsule {
    double radius = 0.5;
    double half_length = 0.5;
};

/// A solid cylinder along the pose's X axis, as a wheel rolls.
struct Wheel {
    double radius = 0.5;
    double half_width = 0.1;
};

/// The kind of tree that a mesh gets. Queries return the same results with both.
enum class TreeKind : std::uint8_t {
    bvh8,    ///< eight children per node, sixteen triangles per leaf (bvh8.h): the fast one
    hybrid,  ///< the paper's binary tree of spheres and oriented boxes (hybrid_tree.h): the readable one
};

/// The collider shapes. A mesh is shared because several objects may place the same one.
using Shape = std::variant<std::shared_ptr<const MeshCollider>, Box, Sphere, Capsule, Wheel>;

}  // namespace campuswalk::collision

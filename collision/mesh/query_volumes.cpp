#include "collision/mesh/query_volumes.h"

#include <algorithm>

#include <Eigen/Geometry>

#include "collision/hybrid/volume_overlap.h"

namespace campuswalk::collision {

namespace {

/// The bound for the single box of a node, with the same rounding as for boxes side by side.
template <typename Volume>
double box_bound(const Volume& volume, const OrientedBox& box) {
    constexpr Rows<double, 1> kCenter{};
    const Vec3& h = box.half_extents;
    const Rows<double, 1> half{{{h.x()}, {h.y()}, {h.z()}}};
    std::array<double, 1> bound{};
    volume.bounds(BoxFrame(box), kCenter, half, bound);
    return bound[0];
}

}  // namespace

LayeredBody::LayeredBody(const Segment& segment, double radius) {
    const Vec3 along = segment.b - segment.a;
    const double length = along.norm();
    const double thick = radius + kOutward * (segment.a.norm() + segment.b.norm() + radius);
    outer_ = {0.5 * (segment.a + segment.b), 0.5 * length + thick};
    inner_.center = outer_.center;
    inner_.radius = outer_.radius;
    if (length > 0.0) {
        inner_.axes.col(0) = along / length;
        inner_.axes.col(1) = inner_.axes.col(0).unitOrthogonal();
        inner_.axes.col(2) = inner_.axes.col(0).cross(inner_.axes.col(1));
    }
    inner_.half_extents = Vec3(outer_.radius, thick, thick);
}

LayeredBody::LayeredBody(const Box& box, const Pose& X_mesh_box) {
    inner_.center = X_mesh_box.translation;
    inner_.axes = X_mesh_box.rotation;
    const double half_diagonal = box.half_extents.norm();
    const double outward = kOutward * (inner_.center.norm() + half_diagonal);
    inner_.half_extents = box.half_extents.array() + outward;
    inner_.radius = half_diagonal + 2.0 * outward;
    outer_ = {inner_.center, inner_.radius};
}

double LayeredBody::bound(const BoundingSphere& outer) const {
    return apart(outer, outer_) ? kApart<double> : 0.0;
}

double LayeredBody::bound(const OrientedBox& inner) const {
    const BoxOffset offset = offset_between(inner, inner_);
    const bool separated = apart(inner, offset.in_a, inner_.radius) ||
                           apart(inner_, offset.in_b, inner.radius) || apart(inner, inner_, offset);
    return separated ? kApart<double> : 0.0;
}

double PointVolume::bound(const BoundingSphere& outer) const {
    const double to_center = (point_ - outer.center).norm();
    const double gap = to_center - outer.radius - kOutward * (to_center + outer.radius);
    return gap > 0.0 ? gap * gap : 0.0;
}

double PointVolume::bound(const OrientedBox& inner) const {
    return box_bound(*this, inner);
}

PathVolume::PathVolume(const Ray& ray) : path_(ray), along_(ray.to - ray.from) {
    const double length2 = along_.squaredNorm();
    inverse_length2_ = length2 > 0.0 ? 1.0 / length2 : 0.0;
}

PathVolume::PathVolume(const Segment& segment, double radius, const Vec3& move)
    : PathVolume(Ray{0.5 * (segment.a + segment.b), 0.5 * (segment.a + segment.b) + move}) {
    half_ = 0.5 * (segment.b - segment.a);
    radius_ = radius;
    reach_ = half_.norm() + radius;
    thick_ = true;
}

// closest_on_segment() with what is the same for all nodes computed once.
double PathVolume::bound(const BoundingSphere& outer) const {
    const Vec3 from = path_.from - outer.center;
    const Vec3 nearest = from + std::clamp(-from.dot(along_) * inverse_length2_, 0.0, 1.0) * along_;
    const double size = 2.0 * from.cwiseAbs().sum() + along_.cwiseAbs().sum();
    const double reach = outer.radius + reach_ + kOutward * (size + reach_);
    return nearest.squaredNorm() > reach * reach ? kApart<double> : 0.0;
}

double PathVolume::bound(const OrientedBox& inner) const {
    return box_bound(*this, inner);
}

}  // namespace campuswalk::collision

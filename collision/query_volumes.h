#pragma once

#include <limits>

#include "collision/box_lanes.h"
#include "collision/hybrid_tree.h"
#include "collision/ray.h"
#include "collision/shapes.h"

namespace campuswalk::collision {

// What queries of one mesh are to its tree (see tree_descent.h), in the mesh's frame.

/// A body with the paper's two layers: its bounds say whether it is met, 0, or kApart.
class LayeredBody {
public:
    LayeredBody(const Segment& segment, double radius);
    LayeredBody(const Box& box, const Pose& X_mesh_box);

    double bound(const BoundingSphere& mesh) const;
    /// As in the paper: outer spheres by eq. (1), each inner sphere against the other's box, box against box.
    double bound(const HybridNode& node) const;

private:
    BoundingSphere outer_;
    OrientedBox inner_;
};

/// All within a distance of a segment. Boxes side by side bound squared distances from the segment.
class ThickSegment : public LayeredBody {
public:
    ThickSegment(const Segment& segment, double radius) : LayeredBody(segment, radius), segment_(segment) {}

    template <std::size_t N>
    void bounds(const BoxFrame& frame, const Rows<float, N>& center, const Rows<float, N>& half,
                std::array<float, N>& out) const {
        const PaddedLine line{frame * segment_.a, frame * segment_.b, Vec3::Zero()};
        distance_bounds(line, line.size(frame), center, half, out);
    }

private:
    Segment segment_;
};

/// An oriented box. Boxes side by side bound squared distances from it.
class BoxVolume : public LayeredBody {
public:
    BoxVolume(const Box& box, const Pose& X_mesh_box)
        : LayeredBody(box, X_mesh_box), half_extents_(box.half_extents), X_mesh_box_(X_mesh_box) {}

    template <std::size_t N>
    void bounds(const BoxFrame& frame, const Rows<float, N>& center, const Rows<float, N>& half,
                std::array<float, N>& out) const {
        const Vec3 middle = frame * X_mesh_box_.translation;
        Vec3 reach = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
            reach += frame.rotate(half_extents_[k] * X_mesh_box_.rotation.col(k)).cwiseAbs();
        }
        const PaddedLine line{middle, middle, reach};
        distance_bounds(line, line.size(frame), center, half, out);
    }

private:
    Vec3 half_extents_;
    Pose X_mesh_box_;
};

/// What of a box lies outside another one, in the frame of a mesh. Where the mesh or a node is turned, the
/// other one doesn't matter: more is met than must be.
class Beyond : public BoxVolume {
public:
    Beyond(const Aabb& hole, const Aabb& whole, const Pose& X_world_mesh)
        : BoxVolume(Box{0.5 * (whole.max - whole.min)},
                    {X_world_mesh.rotation.transpose(), X_world_mesh.inverse_apply(middle(whole))}),
          holed_(whole.overlaps(hole) && X_world_mesh.rotation == Mat3::Identity()),
          whole_{whole.min - X_world_mesh.translation, whole.max - X_world_mesh.translation},
          hole_{hole.min - X_world_mesh.translation, hole.max - X_world_mesh.translation} {}

    template <std::size_t N>
    void bounds(const BoxFrame& frame, const Rows<float, N>& center, const Rows<float, N>& half,
                std::array<float, N>& out) const {
        if (!holed_ || frame.turned) {
            BoxVolume::bounds(frame, center, half, out);
            return;
        }
        // Roundings, of all that is measured: of the corners 3 with LeafBoxes, of a side 1.
        const PaddedLine whole{whole_.min - frame.origin, whole_.max - frame.origin, Vec3::Zero()};
        const PaddedLine hole{hole_.min - frame.origin, hole_.max - frame.origin, Vec3::Zero()};
        const float slack = kGenerous<float> * static_cast<float>(whole.size(frame) + hole.size(frame));
        std::array<float, N> inside;    // how far each box reaches in, along the axis where it is least
        std::array<float, N> beyond{};  // how far what is inside reaches out of the hole
        inside.fill(kFar);
        for (int k = 0; k < 3; ++k) {
            const auto axis = static_cast<std::size_t>(k);
            const float low = static_cast<float>(whole.from[k]) - slack;
            const float high = static_cast<float>(whole.to[k]) + slack;
            // Where the hole goes on beyond the whole, nothing can be on its other side.
            const float hole_low =
                whole_.min[k] < hole_.min[k] ? static_cast<float>(hole.from[k]) + slack : -kFar;
            const float hole_high =
                whole_.max[k] > hole_.max[k] ? static_cast<float>(hole.to[k]) - slack : kFar;
            for (std::size_t i = 0; i < N; ++i) {
                const float from = std::max(low, center[axis][i] - half[axis][i]);
                const float to = std::min(high, center[axis][i] + half[axis][i]);
                inside[i] = std::min(inside[i], to - from);
                beyond[i] = std::max(beyond[i], std::max(hole_low - from, to - hole_high));
            }
        }
        for (std::size_t i = 0; i < N; ++i) {
            out[i] = inside[i] >= 0.0F && beyond[i] > 0.0F ? 0.0F : kApart<float>;
        }
    }

private:
    static constexpr float kFar = std::numeric_limits<float>::max();
    static Vec3 middle(const Aabb& box) { return 0.5 * (box.min + box.max); }

    bool holed_;
    Aabb whole_;
    Aabb hole_;
};

/// The surroundings of a point. Bounds squared distances.
class PointVolume {
public:
    explicit PointVolume(const Vec3& point) : point_(point) {}

    double bound(const BoundingSphere& mesh) const;
    double bound(const HybridNode& node) const;

    template <typename Real, std::size_t N>
    void bounds(const BoxFrame& frame, const Rows<Real, N>& center, const Rows<Real, N>& half,
                std::array<Real, N>& out) const {
        const Vec3 local = frame * point_;
        const PaddedLine line{local, local, Vec3::Zero()};
        distance_bounds(line, line.size(frame), center, half, out);
    }

private:
    Vec3 point_;
};

/// What a ray or a moving capsule passes. Bounds fractions of the way.
class PathVolume {
public:
    explicit PathVolume(const Ray& ray) : path_(ray) {}
    PathVolume(const Segment& segment, double radius, const Vec3& move);

    double bound(const BoundingSphere& mesh) const;
    double bound(const HybridNode& node) const;

    template <typename Real, std::size_t N>
    void bounds(const BoxFrame& frame, const Rows<Real, N>& center, const Rows<Real, N>& half,
                std::array<Real, N>& out) const {
        PaddedLine line{frame * path_.from, frame * path_.to, Vec3::Zero()};
        if (thick_) {
            line.pad = frame.rotate(half_).cwiseAbs().array() + radius_;
        }
        entry_bounds(line, line.size(frame), center, half, out);
    }

private:
    Ray path_;                  ///< of the body's middle
    Vec3 half_ = Vec3::Zero();  ///< from the middle to the segment's end
    double radius_ = 0.0;
    bool thick_ = false;
};

}  // namespace campuswalk::collision

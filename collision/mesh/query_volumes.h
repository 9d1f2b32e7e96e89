#pragma once

#include <limits>

#include "collision/bvh8/box_lanes.h"
#include "collision/geometry/fitting.h"
#include "collision/geometry/ray.h"
#include "collision/geometry/shapes.h"

namespace campuswalk::collision {

// The volumes of queries of one mesh (see tree_traversal.h), in the mesh's frame.

/// A body with the paper's two layers. Its bounds are 0 if it may overlap a volume, else kApart.
class LayeredBody {
public:
    LayeredBody(const Segment& segment, double radius);
    LayeredBody(const Box& box, const Pose& X_mesh_box);

    /// Eq. (1).
    double bound(const BoundingSphere& outer) const;
    /// As in the paper: each inner sphere against the other's box, then box against box.
    double bound(const OrientedBox& inner) const;

private:
    BoundingSphere outer_;
    OrientedBox inner_;
};

/// All points within a distance of a segment. Bounds for boxes side by side are squared distances from it.
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

/// An oriented box. Bounds for boxes side by side are squared distances from it.
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

/// The part of a box that lies outside another one, the hole, in a mesh's frame. The hole is ignored in the
/// hybrid tree and where the mesh or a node is rotated: the query then visits more than it must.
class BoxWithHole : public BoxVolume {
public:
    BoxWithHole(const Aabb& hole, const Aabb& whole, const Pose& X_world_mesh)
        : BoxVolume(Box{0.5 * (whole.max - whole.min)},
                    {X_world_mesh.rotation.transpose(), X_world_mesh.inverse_apply(whole.center())}),
          holed_(whole.overlaps(hole) && X_world_mesh.rotation == Mat3::Identity()) {
        for (int k = 0; k < 3; ++k) {
            const double origin = X_world_mesh.translation[k];
            sides_[static_cast<std::size_t>(k)] = {whole.min[k] - origin, whole.max[k] - origin,
                                                   hole.min[k] - origin, hole.max[k] - origin};
        }
    }

    template <std::size_t N>
    void bounds(const BoxFrame& frame, const Rows<float, N>& center, const Rows<float, N>& half,
                std::array<float, N>& out) const {
        if (!holed_ || frame.rotated) {
            BoxVolume::bounds(frame, center, half, out);
            return;
        }
        std::array<std::array<float, 4>, 3> sides{};  // by axis: low and high of the whole, then of the hole
        float size = static_cast<float>(frame.radius);
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t side = 0; side < 4; ++side) {
                sides[k][side] = static_cast<float>(sides_[k][side] - frame.origin[static_cast<int>(k)]);
                size += std::abs(sides[k][side]);
            }
        }
        // Roundings, relative to `size`: 3 of the vertices with LeafBoxes, 1 of a side.
        const float slack = kSlackShare<float> * size;
        std::array<float, N>
            inside;  // how far each box reaches into the whole, along the axis where that is least
        std::array<float, N> beyond{};  // how far that part reaches out of the hole
        inside.fill(kFar);
        for (std::size_t k = 0; k < 3; ++k) {
            const float low = sides[k][0] - slack;
            const float high = sides[k][1] + slack;
            // Where the hole extends beyond the whole, nothing can lie on its other side.
            const float hole_low = sides[k][0] < sides[k][2] ? sides[k][2] + slack : -kFar;
            const float hole_high = sides[k][1] > sides[k][3] ? sides[k][3] - slack : kFar;
            for (std::size_t i = 0; i < N; ++i) {
                const float from = std::max(low, center[k][i] - half[k][i]);
                const float to = std::min(high, center[k][i] + half[k][i]);
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

    bool holed_;
    std::array<std::array<double, 4>, 3> sides_{};
};

/// A point. Bounds are squared distances from it.
class PointVolume {
public:
    explicit PointVolume(const Vec3& point) : point_(point) {}

    double bound(const BoundingSphere& outer) const;
    double bound(const OrientedBox& inner) const;

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

/// The volume that a ray or a moving capsule sweeps. Bounds are fractions of the motion.
class PathVolume {
public:
    explicit PathVolume(const Ray& ray);
    PathVolume(const Segment& segment, double radius, const Vec3& move);

    double bound(const BoundingSphere& outer) const;
    double bound(const OrientedBox& inner) const;

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
    Ray path_;  ///< of the body's centre
    Vec3 along_ = Vec3::Zero();
    double inverse_length2_ = 0.0;  ///< of the path; 0 if it has no length
    Vec3 half_ = Vec3::Zero();      ///< from the centre to the segment's end
    double radius_ = 0.0;
    double reach_ = 0.0;  ///< from the centre to the farthest point
    bool thick_ = false;
};

}  // namespace campuswalk::collision

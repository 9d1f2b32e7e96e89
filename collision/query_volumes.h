#pragma once

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

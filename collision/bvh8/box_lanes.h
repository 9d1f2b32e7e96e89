#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "collision/bvh8/bvh8.h"
#include "collision/geometry/fitting.h"

namespace campuswalk::collision {

// Bounds for boxes stored side by side in one frame: the eight children of a BVH8 node, the sixteen triangles
// of a BVH8 leaf, or the single box of a node of the paper's tree. Plain loops over the lanes, which
// compilers vectorize. The results are lower bounds: too low costs time, too high would lose triangles.

/// One row per axis, for N boxes.
template <typename Real, std::size_t N>
using Rows = std::array<std::array<Real, N>, 3>;

/// The slack of bounds, relative to the size of the numbers involved. float32: 16 roundings, counted below.
/// double: that of the boxes themselves (see kOutward).
template <typename Real>
inline constexpr Real kSlackShare = static_cast<Real>(kOutward);
template <>
inline constexpr float kSlackShare<float> = 16.0F * kFloatUnit;

/// The bound of a box that the query doesn't touch.
template <typename Real>
inline constexpr Real kApart = std::numeric_limits<Real>::infinity();

/// The frame of boxes: y = axes (x - origin), with x in the mesh's frame.
///
/// `axes` is the same matrix that the boxes were fitted with, so that its deviation from a rotation moves a
/// query and a box alike; it lengthens vectors by less than 2 roundings.
struct BoxFrame {
    Mat3 axes = Mat3::Identity();
    Vec3 origin = Vec3::Zero();
    double radius = 0.0;  ///< all boxes are within this distance of the origin
    bool rotated = true;  ///< false: `axes` is the identity

    explicit BoxFrame(const Bvh8Node& node)
        : origin(node.origin[0], node.origin[1], node.origin[2]), radius(node.radius), rotated(node.rotated) {
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t j = 0; j < 3; ++j) {
                axes(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(k)) = node.axes[k][j];
            }
        }
    }
    explicit BoxFrame(const Bvh8Leaf& leaf)
        : origin(leaf.origin[0], leaf.origin[1], leaf.origin[2]), radius(leaf.radius), rotated(false) {}
    explicit BoxFrame(const OrientedBox& box)
        : axes(box.axes.transpose()), origin(box.center), radius(box.radius) {}

    Vec3 rotate(const Vec3& v) const { return rotated ? Vec3(axes * v) : v; }
    Vec3 operator*(const Vec3& p) const { return rotate(p - origin); }
};

/// The boxes of a leaf's triangles, in the leaf's frame. Vertices, ends and halves are rounded once each:
/// 3 roundings of the leaf's radius. Fills every lane; those without a triangle have arbitrary boxes.
struct LeafBoxes {
    alignas(32) Rows<float, kLeafTriangles> center;
    alignas(32) Rows<float, kLeafTriangles> half;

    explicit LeafBoxes(const Bvh8Leaf& leaf) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& at = leaf.vertex[k];
            for (std::size_t i = 0; i < kLeafTriangles; ++i) {
                const float a = at[leaf.vertex_of[0][i]];
                const float b = at[leaf.vertex_of[1][i]];
                const float c = at[leaf.vertex_of[2][i]];
                const float low = 0.5F * std::min(a, std::min(b, c));
                const float high = 0.5F * std::max(a, std::max(b, c));
                center[k][i] = high + low;
                half[k][i] = high - low;
            }
        }
    }
};

/// A segment in the boxes' frame, thickened by `pad` along each axis.
struct PaddedLine {
    Vec3 from = Vec3::Zero();
    Vec3 to = Vec3::Zero();
    Vec3 pad = Vec3::Zero();

    /// An upper bound of all lengths that are compared with boxes. The last term is for the tests of
    /// triangles, which round in double at any coordinates: kSlackShare times it is 2^-40 of them.
    double size(const BoxFrame& frame) const {
        return frame.radius + from.cwiseAbs().sum() + to.cwiseAbs().sum() + pad.sum() +
               0x1p-20 * frame.origin.cwiseAbs().sum();
    }
};

/// The fraction of the line at which it enters each box, kApart where it misses it.
///
/// Roundings, of `size` each: of the start 1, the difference of positions 1, the step 1, its replacement 1,
/// its inverse 1, both products 2, the half's sum 2, the last sum 2, which is 11; 14 with LeafBoxes.
template <typename Real, std::size_t N>
void entry_bounds(const PaddedLine& line, double size, const Rows<Real, N>& center, const Rows<Real, N>& half,
                  std::array<Real, N>& bounds) {
    constexpr Real kTiny = std::numeric_limits<Real>::min();
    // A step that rounding can't distinguish from 0 is replaced by one to divide by.
    const double least = 0.5 * std::numeric_limits<Real>::epsilon() * size + static_cast<double>(kTiny);
    const Real slack = kSlackShare<Real> * static_cast<Real>(size) + kTiny;
    std::array<Real, N> leave;
    leave.fill(1);
    bounds.fill(0);
    for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        const double step = line.to[axis] - line.from[axis];
        const auto inverse =
            static_cast<Real>(1.0 / (std::abs(step) < least ? std::copysign(least, step) : step));
        const Real steepness = std::abs(inverse);
        const auto from = static_cast<Real>(line.from[axis]);
        const Real thick = static_cast<Real>(line.pad[axis]) + slack;
        for (std::size_t i = 0; i < N; ++i) {
            const Real middle = (center[k][i] - from) * inverse;
            const Real reach = (half[k][i] + thick) * steepness;
            bounds[i] = std::max(bounds[i], middle - reach);
            leave[i] = std::min(leave[i], middle + reach);
        }
    }
    for (std::size_t i = 0; i < N; ++i) {
        bounds[i] = bounds[i] > leave[i] ? kApart<Real> : bounds[i];
    }
}

/// The squared distance of each box from the line's bounds in this frame.
///
/// Roundings, of `size` each: of the middle 1, its reach 1, the differences and sums 3, which is 5; 8 with
/// LeafBoxes. Squares and their sum add 4 and the frame's matrix 4, of the result.
template <typename Real, std::size_t N>
void distance_bounds(const PaddedLine& line, double size, const Rows<Real, N>& center,
                     const Rows<Real, N>& half, std::array<Real, N>& bounds) {
    const Real slack = kSlackShare<Real> * static_cast<Real>(size) + std::numeric_limits<Real>::min();
    bounds.fill(0);
    for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        const auto middle = static_cast<Real>(0.5 * (line.from[axis] + line.to[axis]));
        const auto length = 0.5 * std::abs(line.to[axis] - line.from[axis]) + line.pad[axis];
        const Real reach = static_cast<Real>(length) + slack;
        for (std::size_t i = 0; i < N; ++i) {
            const Real gap = std::abs(center[k][i] - middle) - (half[k][i] + reach);
            const Real apart = std::max(gap, Real(0));
            bounds[i] += apart * apart;
        }
    }
    for (std::size_t i = 0; i < N; ++i) {
        bounds[i] *= 1 - kSlackShare<Real>;
    }
}

}  // namespace campuswalk::collision

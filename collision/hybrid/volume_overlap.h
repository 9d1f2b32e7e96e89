#pragma once

#include <cmath>

#include "collision/geometry/fitting.h"

namespace campuswalk::collision {

// The tests of two nodes' volumes (paper III.B), in one frame. Each returns whether they are certainly apart:
// false where they overlap or touch, where rounding leaves it open, and for NaN.
//
// Why rounding can't separate what touches: with u = 2^-53, every distance and every extent below is a sum of
// at most a dozen products, with an error of some tens of u times the size of the volumes and their
// coordinates. The volumes are larger than their contents by kOutward, 9,000 u, times the same size, along
// every axis of length 1. Only edge axes may be shorter: they have a separate slack.

/// Eq. (1).
inline bool apart(const BoundingSphere& a, const BoundingSphere& b) {
    const double reach = a.radius + b.radius;
    return (b.center - a.center).squaredNorm() > reach * reach;
}

/// From a's centre to b's, along a's axes and along b's.
struct BoxOffset {
    Vec3 in_a = Vec3::Zero();
    Vec3 in_b = Vec3::Zero();
};

inline BoxOffset offset_between(const OrientedBox& a, const OrientedBox& b) {
    const Vec3 offset = b.center - a.center;
    return {a.axes.transpose() * offset, b.axes.transpose() * offset};
}

/// A box, and a sphere whose centre lies at `offset` along the box's axes: three axes.
inline bool apart(const OrientedBox& box, const Vec3& offset, double radius) {
    return (offset.cwiseAbs().array() > box.half_extents.array() + radius).any();
}

/// Two boxes: three axes each, and the nine that are at right angles to an edge of both (Gottschalk, Lin,
/// Manocha, "OBBTree", 1996).
///
/// An edge axis is the cross product of two unit vectors and shrinks to nothing where they are nearly
/// parallel, and with it kOutward's share in the extents along it. What doesn't shrink is the rounding of its
/// coordinates, tens of u, times distances and extents, which are no longer than both radii together where
/// the boxes overlap: hence the slack.
inline bool apart(const OrientedBox& a, const OrientedBox& b, const BoxOffset& offset) {
    const Vec3& t = offset.in_a;
    const Vec3& h = a.half_extents;
    const Vec3& g = b.half_extents;
    Mat3 r;  // column j: b's axis j along a's axes
    Mat3 size;
    for (int j = 0; j < 3; ++j) {
        r.col(j) = a.axes.transpose() * b.axes.col(j);
        size.col(j) = r.col(j).cwiseAbs();
        if (std::abs(offset.in_b[j]) > g[j] + size.col(j).dot(h)) {
            return true;
        }
    }
    for (int i = 0; i < 3; ++i) {
        if (std::abs(t[i]) > h[i] + size.row(i).dot(g)) {
            return true;
        }
    }
    const double slack = kOutward * (a.radius + b.radius);
    for (int j = 0; j < 3; ++j) {
        const int j1 = (j + 1) % 3;
        const int j2 = (j + 2) % 3;
        for (int i = 0; i < 3; ++i) {
            const int i1 = (i + 1) % 3;
            const int i2 = (i + 2) % 3;
            const double reach =
                h[i1] * size(i2, j) + h[i2] * size(i1, j) + g[j1] * size(i, j2) + g[j2] * size(i, j1);
            if (std::abs(t[i2] * r(i1, j) - t[i1] * r(i2, j)) > reach + slack) {
                return true;
            }
        }
    }
    return false;
}

}  // namespace campuswalk::collision

#pragma once

#include <optional>

#include "collision/geometry/closest.h"

namespace campuswalk::collision {

/// A gap that counts as contact, metres.
inline constexpr double kTouching = 1e-10;

/// The first fraction of `move` at which a capsule of `radius` about `segment` touches a convex piece; none
/// if it never does or if it only moves away. Conservative: the fraction is never too large.
/// `closest_to(segment)` returns the closest points of a segment and the piece.
template <typename ClosestTo>
std::optional<double> first_touch(const Segment& segment, double radius, const Vec3& move,
                                  const ClosestTo& closest_to) {
    // The distance between convex bodies is a convex function of the fraction of a straight move, so Newton's
    // method from the left approaches the first contact and never passes it; once the distance stops falling,
    // there is none.
    constexpr int kMaxSteps = 64;  // grazing contacts converge slowly; stopping early is safe
    double fraction = 0.0;
    for (int i = 0; i < kMaxSteps; ++i) {
        const Segment moved{segment.a + fraction * move, segment.b + fraction * move};
        const Closest c = closest_to(moved);
        const double gap = c.distance - radius;
        if (c.distance <= 0.0) {
            return fraction;
        }
        const double approach = -(c.on_segment - c.on_shape).dot(move) / c.distance;
        if (approach <= 0.0) {
            return std::nullopt;
        }
        if (gap <= kTouching) {
            return fraction;
        }
        fraction += gap / approach;
        if (fraction >= 1.0) {
            return std::nullopt;
        }
    }
    return fraction;
}

}  // namespace campuswalk::collision

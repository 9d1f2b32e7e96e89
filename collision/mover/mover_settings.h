#pragma once

#include <cmath>

#include "collision/geometry/shapes.h"

namespace campuswalk::collision {

/// The body that is moved: an upright capsule, metres.
struct MoverSettings {
    double height = 1.8;  ///< total
    double radius = 0.3;
    double step_height = 0.3;            ///< the highest riser that it steps up
    double min_up = 0.6427876096865393;  ///< cosine of the steepest slope it walks on (50°)
    double skin = 0.02;                  ///< gap to flat walls
    double gravity = 9.81;               ///< metres per second squared

    friend bool operator==(const MoverSettings&, const MoverSettings&) = default;

    /// Metres up per metre ahead, on the steepest slope.
    double steepest_rise() const { return std::sqrt(1.0 - min_up * min_up) / min_up; }
    /// The capsule is all points within `radius` of this segment.
    Segment core(const Vec3& foot) const { return upright_axis(foot, radius, height); }
};

/// The gap at which the body rests above the ground and beside edges: large compared with rounding, too small
/// to see.
inline constexpr double kRestGap = 1e-4;
/// The gap that every swept motion leaves: half of kRestGap, so that the ground it rests on is never in the
/// way.
inline constexpr double kSweepGap = 0.5 * kRestGap;
/// How far beyond the skin touching objects are still listed, for the hysteresis of events, metres.
inline constexpr double kListed = 0.01;
/// Tolerance for heights that are compared with the step height, for risers of exactly that height.
inline constexpr double kHeightSlack = 1e-3;

}  // namespace campuswalk::collision

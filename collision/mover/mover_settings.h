#pragma once

#include "collision/geometry/shapes.h"

namespace campuswalk::collision {

/// The body that is moved: an upright capsule, metres.
struct MoverSettings {
    double height = 1.8;  ///< total
    double radius = 0.3;
    double step_height = 0.3;            ///< the highest edge it rolls over
    double min_up = 0.6427876096865393;  ///< cosine of the steepest slope it walks on (50°)
    double skin = 0.02;                  ///< gap kept to flat walls
    double gravity = 9.81;               ///< metres a second squared

    friend bool operator==(const MoverSettings&, const MoverSettings&) = default;

    /// The segment that the capsule is thick about.
    Segment core(const Vec3& foot) const { return upright_axis(foot, radius, height); }
};

/// The gap the body rests at above the ground and beside edges: large against rounding, too small to see.
inline constexpr double kRest = 1e-4;
/// What every swept motion keeps; half of kRest, so that ground it rests on never counts as in the way.
inline constexpr double kHard = 0.5 * kRest;
/// Slack on heights compared with the step height, for risers of exactly that height.
inline constexpr double kHeightSlack = 1e-3;

}  // namespace campuswalk::collision

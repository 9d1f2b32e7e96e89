#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "engine/events/event.h"
#include "engine/script/mentions.h"

// How a step goes straight to a point and when it is there or gives up: the one law of walk_to, of follow's
// end, and of the trial walks that routes are made of.

namespace campuswalk::engine {

/// Being this far above or below a target that has a height still counts as being there, metres.
inline constexpr double kTargetLevel = 0.5;
/// A step that travels gives up after this many seconds in which its target came no nearer by kProgress, or
/// by half of what a slower avatar would walk in that time.
inline constexpr double kPatience = 1.5;
inline constexpr double kProgress = 0.05;  // metres

inline Eigen::Vector3d flat(Eigen::Vector3d v) {
    v.y() = 0.0;
    return v;
}

/// What the avatar would move by in one tick of which it can go `most` metres.
inline Eigen::Vector3d displacement_towards(const Eigen::Vector3d& point, const Eigen::Vector3d& position,
                                            double most) {
    const Eigen::Vector3d direction = flat(point - position);
    const double distance = direction.norm();
    return distance > 0.0 ? Eigen::Vector3d(direction * (std::min(distance, most) / distance))
                          : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

/// Who falls past a place hasn't arrived there.
inline bool has_arrived(const Target& target, double within, const Eigen::Vector3d& position, bool grounded) {
    const Eigen::Vector3d to_target = target.point - position;
    return grounded && flat(to_target).norm() <= within &&
           (!target.has_height || std::abs(to_target.y()) <= kTargetLevel);
}

/// What is remembered from tick to tick on the way to a target.
struct TravelProgress {
    Tick ticks = 0;          ///< so far
    Tick since_closer = 0;   ///< when the target last came nearer
    double nearest = 1e300;  ///< least distance to the target so far, metres
    double allowed = 0.0;    ///< seconds before it gives up

    bool is_late(double dt) const { return static_cast<double>(ticks) * dt >= allowed; }
    /// After a tick of `dt` seconds: whether an avatar that has `remaining` metres to go is late or comes no
    /// nearer. One in the air has to land first.
    bool gives_up(double remaining, bool grounded, double speed, double dt) {
        if (remaining < nearest - std::min(kProgress, 0.5 * speed * kPatience)) {
            nearest = remaining;
            since_closer = ticks;
        } else if (!grounded) {
            since_closer = ticks;
        }
        return is_late(dt) || static_cast<double>(ticks - since_closer) * dt >= kPatience;
    }
};

/// Seconds that a way may take unless a step says otherwise.
inline double default_timeout(double length, double speed) {
    return 2.0 * length / speed + 5.0;
}

}  // namespace campuswalk::engine

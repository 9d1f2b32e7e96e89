#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace campuswalk::engine {

/// The visitor's body and abilities (`NAME.avatar.yaml`); a walk may override any field.
/// The defaults are those of game engines, such as Jolt's 50° slope, but for the step: 0.4 m is much for a
/// person.
struct AvatarProfile {
    double height = 1.8;                     ///< metres, total
    double radius = 0.3;                     ///< metres
    double eye_height = 1.65;                ///< metres above the foot point
    double speed = 1.4;                      ///< metres per second, a person's usual pace
    std::optional<double> run_speed;         ///< metres per second, for `run`; twice the speed if not given
    double step_height = 0.3;                ///< metres, the highest riser that the avatar climbs
    double max_slope = 0.8726646259971648;   ///< radians (50°), the steepest ground that the avatar walks on
    double skin_width = 0.02;                ///< metres, the gap kept to walls
    double turn_speed = 3.141592653589793;   ///< radians per second, for `turn` and `look_at`
    double look_distance = 10.0;             ///< metres, the reach of detection mode ray
    std::vector<std::string> ignore_layers;  ///< layers that the avatar neither touches nor sees
};

inline double running_speed(const AvatarProfile& avatar) {
    return avatar.run_speed.value_or(2.0 * avatar.speed);
}

/// While it crouches, metres; no less than it is wide.
inline double crouched_height(const AvatarProfile& avatar) {
    constexpr double kCrouchedShare = 0.6;
    return std::max(2.0 * avatar.radius, kCrouchedShare * avatar.height);
}

/// Where the avatar is at the end of a tick.
struct AvatarState {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< foot point, metres
    double yaw = 0.0;                                    ///< radians about +Y, 0 looks along -Z
    double pitch = 0.0;                                  ///< radians, up positive
    double vertical_speed = 0.0;                         ///< metres per second, while falling
    bool grounded = false;
    double stature = 1.0;  ///< height divided by the profile's: less than 1 while crouching
};

}  // namespace campuswalk::engine

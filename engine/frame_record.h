#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "engine/events/event.h"
#include "engine/script/walk.h"

namespace campuswalk::engine {

/// Where the avatar is at the end of a tick.
struct AvatarState {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< foot point, metres
    double yaw = 0.0;                                    ///< radians about +Y, 0 looks along -Z
    double pitch = 0.0;                                  ///< radians, up positive
    double vertical_speed = 0.0;                         ///< metres a second, while falling
    bool grounded = false;
    double stature = 1.0;  ///< height over the profile's: less than 1 while it crouches
};

/// What one tick did, as plain data that observers read after it. Spans stay valid until the next tick.
struct FrameRecord {
    Tick tick = 0;
    double time = 0.0;  ///< seconds: tick / ticks_per_second, never a running sum
    AvatarState avatar;
    std::span<const Event> events;                   ///< in log order
    std::span<const SnapshotStep* const> snapshots;  ///< pictures the script asks for at this moment
    std::span<const std::size_t> open_popups;        ///< indices into the campus' buildings, oldest first
};

}  // namespace campuswalk::engine

#pragma once

#include <optional>

#include "engine/walkspace/space/walk_space.h"

namespace campuswalk::engine {

/// How near one gets to a point by walking.
struct PointReach {
    std::optional<WalkNodeId> node;                  ///< from which it is reached; none: it isn't
    collision::Vec3 foot = collision::Vec3::Zero();  ///< where one then stands
    double nearest = 1e300;                          ///< metres, if it isn't reached
};

/// Tries from the nodes about the point, the nearest first, as the step walk_to does: it is reached within
/// 5 cm, seen from above, and 0.5 m of its height; without `has_height` on whichever storey.
PointReach reach_point(const WalkSpace& reached, Strider& strider, const collision::Vec3& at,
                       bool has_height);

}  // namespace campuswalk::engine

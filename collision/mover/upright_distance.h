#pragma once

#include <optional>

#include "collision/world/obstacle.h"

namespace campuswalk::collision {

/// Like `closest` (obstacle.h) for a segment whose `b` is straight above its `a`: the same distance, faster
/// where a face is nearest. Where points at several heights are equally near, returns the upper one.
Closest closest_upright(const Segment& upright, const Obstacle& obstacle);

/// Like `sweep` (obstacle.h), likewise.
std::optional<double> sweep_upright(const Segment& upright, double radius, const Vec3& move,
                                    const Obstacle& obstacle);

}  // namespace campuswalk::collision

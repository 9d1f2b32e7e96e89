#pragma once

#include <string>

#include "collision/geometry/shapes.h"
#include "engine/walkspace/barrier/why_not.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// What explore says of an island at `place`, of a visitor who starts at 0, 0, 5 and wants to get there.
Barrier explored_barrier(scene::Campus& campus, const collision::Vec3& place);

/// Likewise of ground that nobody asked for.
Barrier barrier_of_ground(const scene::Campus& campus, const collision::Vec3& place, std::size_t workers = 1);

/// What go_to says of it.
std::string reason_to_go(const scene::Campus& campus, const collision::Vec3& place);

}  // namespace campuswalk::engine

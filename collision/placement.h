#pragma once

#include <optional>

#include "collision/counters.h"
#include "collision/world.h"

namespace campuswalk::collision {

/// Is `point` (world coordinates) inside the object: a convex solid, or a closed part of a mesh?
bool contains(const Object& object, const Vec3& point);

/// The object that a capsule standing at `foot` would overlap or be inside of; none when the place is free.
/// Of several, the one that is met deepest, then the lowest id.
std::optional<ObjectId> obstruction(const World& world, const QueryFilter& filter, const Vec3& foot,
                                    double radius, double height, QueryCounters& counters);

/// The lowest free place from `foot` up to `search` metres above it: where a person asked to stand at `foot`
/// stands, if the ground is a little higher than the number that was written down.
std::optional<Vec3> free_place(const World& world, const QueryFilter& filter, const Vec3& foot, double radius,
                               double height, double search, QueryCounters& counters);

}  // namespace campuswalk::collision

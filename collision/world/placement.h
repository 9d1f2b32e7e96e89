#pragma once

#include <optional>

#include "collision/base/query_statistics.h"
#include "collision/world/world.h"

namespace campuswalk::collision {

/// Is `point` (world coordinates) inside the object: a convex solid, or a closed part of a mesh?
bool contains(const Object& object, const Vec3& point, QueryStatistics* statistics = nullptr);

/// The object that a capsule standing at `foot` would overlap or be inside of; none when the place is free.
/// Of several, the one that is met deepest, then the lowest id.
std::optional<ObjectId> obstruction(const World& world, const QueryFilter& filter, const Vec3& foot,
                                    double radius, double height, QueryStatistics* statistics = nullptr);

/// The lowest free place from `foot` up to `search` metres above it: where a person asked to stand at `foot`
/// stands, if the ground is a little higher than the number that was written down.
std::optional<Vec3> free_place(const World& world, const QueryFilter& filter, const Vec3& foot, double radius,
                               double height, double search, QueryStatistics* statistics = nullptr);

/// Where a body stands that was to be put down at a place.
struct FreePlacement {
    Vec3 foot = Vec3::Zero();
    std::optional<ObjectId> pushed_out_of;  ///< none when the place was free, but for the rounding of numbers
};

/// The place itself, or up to 5 cm above it, where that is free. If the body overlaps things there by less
/// than its radius, the nearest free place within twice the radius, on this side of what is near: nearest of
/// the offsets on rings 2 cm and heights 5 cm apart in 64 directions, drawn in to 1 mm from what was
/// overlapped. If it overlaps by more, the lowest free place up to `search` above, as of someone put into a
/// table who then stands on it. Otherwise none.
std::optional<FreePlacement> nearest_free_placement(const World& world, const QueryFilter& filter,
                                                    const Vec3& foot, double radius, double height,
                                                    double search, QueryStatistics* statistics = nullptr);

}  // namespace campuswalk::collision

#pragma once

#include <optional>

#include "collision/base/query_statistics.h"
#include "collision/world/world.h"

namespace campuswalk::collision {

/// Whether `point` (world coordinates) is inside the object: a convex solid, or a closed part of a mesh.
bool contains(const Object& object, const Vec3& point, QueryStatistics* statistics = nullptr);

/// The object that a capsule standing at `foot` would overlap or be inside of; none when the place is free.
/// Of several, the one with the deepest overlap, then that with the lowest id.
std::optional<ObjectId> obstruction(const World& world, const QueryFilter& filter, const Vec3& foot,
                                    double radius, double height, QueryStatistics* statistics = nullptr);

/// The lowest free place from `foot` up to `search` metres above it: for a body placed at `foot` where the
/// ground is a little higher than the written coordinate.
std::optional<Vec3> free_place(const World& world, const QueryFilter& filter, const Vec3& foot, double radius,
                               double height, double search, QueryStatistics* statistics = nullptr);

/// Whether a capsule that stands at `foot` can be moved straight by `move` and touches nothing on its way.
/// What it touches at the start and moves away from doesn't count.
bool is_path_free(const World& world, const QueryFilter& filter, const Vec3& foot, double radius,
                  double height, const Vec3& move, QueryStatistics* statistics = nullptr);

/// Where a body ends up that was to be placed at a position.
struct FreePlacement {
    Vec3 foot = Vec3::Zero();
    std::optional<ObjectId>
        pushed_out_of;  ///< none when the place was free, except for the rounding of numbers
};

/// The place itself, or up to 5 cm above it, if that is free. If the body overlaps things there by less than
/// its radius: the nearest free place within twice the radius, on the same side of what is near. That is the
/// nearest of the offsets on rings 2 cm and heights 5 cm apart in 64 directions, moved back to 1 mm from what
/// was overlapped. If it overlaps by more: the lowest free place up to `search` above, so that a body placed
/// in a table stands on it. Otherwise none.
std::optional<FreePlacement> nearest_free_placement(const World& world, const QueryFilter& filter,
                                                    const Vec3& foot, double radius, double height,
                                                    double search, QueryStatistics* statistics = nullptr);

}  // namespace campuswalk::collision

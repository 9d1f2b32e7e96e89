#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "collision/base/query_statistics.h"
#include "collision/geometry/closest.h"
#include "collision/world/world.h"

namespace campuswalk::collision {

/// One convex piece of the solid world near the avatar, world coordinates: a triangle of a mesh, or a whole
/// convex solid.
struct Obstacle {
    ObjectId object{};
    std::uint32_t triangle = 0;     ///< index in the object's mesh; 0 for a solid
    const Object* solid = nullptr;  ///< set for a convex solid, else null
    Triangle vertices;              ///< for a triangle
    Vec3 normal = Vec3::Zero();     ///< for a triangle: unit face normal, zero if it has no area
    double top = 0.0;               ///< greatest y
};

Obstacle triangle_obstacle(ObjectId object, std::uint32_t triangle, const Triangle& vertices);
Obstacle solid_obstacle(const World& world, ObjectId object);

/// Replaces `out` by all obstacles within `radius` of the segment that pass the filter, ordered by object and
/// triangle. They point into `world`.
void gather_obstacles(const World& world, const QueryFilter& filter, const Segment& segment, double radius,
                      std::vector<Obstacle>& out, QueryStatistics* statistics = nullptr);

/// Likewise for one object.
void gather_pieces(const World& world, ObjectId id, const Segment& segment, double radius,
                   std::vector<Obstacle>& out, QueryStatistics* statistics = nullptr);

Closest closest(const Segment& segment, const Obstacle& obstacle);

/// Whether the obstacle's surface at `point` (a point of it) faces up by at least `min_up` (the cosine of the
/// slope limit). Triangles are two-sided: flipped floors are common in real models.
bool walkable_at(const Obstacle& obstacle, const Vec3& point, double min_up);

/// The first fraction of `move` at which a capsule of `radius` about `segment` touches the obstacle; none if
/// it never does or if it only moves away. Conservative: the fraction is never too large.
std::optional<double> sweep(const Segment& segment, double radius, const Vec3& move,
                            const Obstacle& obstacle);

}  // namespace campuswalk::collision

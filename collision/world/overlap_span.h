#pragma once

#include <optional>

#include "collision/base/query_statistics.h"
#include "collision/geometry/shapes.h"
#include "collision/world/world.h"

namespace campuswalk::collision {

/// The part of a straight move during which a capsule overlaps an object, as fractions of the move.
struct OverlapSpan {
    double enter = 0.0;  ///< 0 when they overlap at the start
    double leave = 1.0;  ///< 1 when they overlap at the end
    bool at_start = false;
    bool at_end = false;
};

/// When a capsule of `radius` about `segment` that moves by `move` overlaps the object (distance <= 0).
/// Convex solids are filled; a mesh is its surface, and also its inside where it is closed and faces outward.
/// The span reaches from the first to the last contact, whatever gaps there are in between.
std::optional<OverlapSpan> overlap_span(const World& world, ObjectId id, const Segment& segment,
                                        double radius, const Vec3& move,
                                        QueryStatistics* statistics = nullptr);

}  // namespace campuswalk::collision

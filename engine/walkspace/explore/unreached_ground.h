#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "collision/geometry/disjoint_sets.h"
#include "collision/geometry/shapes.h"
#include "collision/world/broad_phase.h"
#include "engine/walkspace/explore/explore.h"
#include "engine/walkspace/explore/unreached_surfaces.h"
#include "engine/walkspace/space/walk_space.h"
#include "engine/walkspace/stride/worker_worlds.h"

namespace campuswalk::engine {

/// A place where the body could stand, but doesn't get to.
struct UnreachedSpot {
    GroundState at;
    collision::ObjectId object{};  ///< that would carry it
    std::uint32_t triangle = 0;    ///< of the object's mesh; 0 for a box
};

/// Unreached spots side by side: ground that one could walk about on.
struct Island {
    std::vector<UnreachedSpot> spots;  ///< at most one for each cell and level
    collision::Aabb bounds;            ///< of the feet

    double area(const WalkGrid& grid) const {
        return static_cast<double>(spots.size()) * grid.cell * grid.cell;
    }
    /// The foot nearest to a point; heights count half.
    collision::Vec3 nearest_to(const collision::Vec3& point) const;
};

/// Islands that are worth a line: of more than 1 m².
inline constexpr double kNotableIsland = 1.0;

/// Walkable ground that the exploration didn't get to: the middle of each cell on a triangle that isn't too
/// steep, with room for the body above. Spots in neighbouring cells belong together if their heights differ
/// by no more than a step, or than the steepest walkable slope. The largest island first; those below
/// `least_area` (m²) are left out. Only within `settings.within` and where `settings.keep_out` is false; tops
/// of round solids don't count. None if there are more than `most` cells of such ground, with room for the
/// body or not.
std::optional<std::vector<Island>> find_unreached_ground(const WorkerWorlds& worlds,
                                                         const ExploreSettings& settings,
                                                         const WalkSpace& reached, double least_area,
                                                         std::size_t most = kMostUnreached);

/// The spots of each set of their numbers as an island, likewise.
std::vector<Island> islands_of(const std::vector<UnreachedSpot>& spots, collision::DisjointSets& sets,
                               const WalkGrid& grid, double least_area);

}  // namespace campuswalk::engine

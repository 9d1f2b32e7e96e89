#pragma once

#include <cstdint>
#include <vector>

#include "engine/walkspace/explore.h"
#include "engine/walkspace/walk_space.h"

namespace campuswalk::engine {

/// Ground at the middle of a cell.
struct Surface {
    GridCell cell;
    double y = 0.0;
    collision::ObjectId object{};
    std::uint32_t triangle = 0;  ///< of the object's mesh; 0 for a box
};

/// All surfaces in the region that aren't too steep, by cell from low to high, without those on one another.
/// Those of round solids aren't found.
std::vector<Surface> walkable_surfaces(const collision::World& world, const ExploreSettings& settings,
                                       const WalkGrid& grid, const collision::Aabb& region);

/// Likewise, those that have no reached node, without those so close below others that no body touches them.
/// What sticks out less than a third of a cell from under another counts as below it.
std::vector<Surface> unreached_surfaces(const WorkerWorlds& worlds, const ExploreSettings& settings,
                                        const WalkSpace& reached, const collision::Aabb& region);

}  // namespace campuswalk::engine

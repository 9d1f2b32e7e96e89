#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "engine/walkspace/explore/explore.h"
#include "engine/walkspace/space/walk_space.h"

namespace campuswalk::engine {

/// Ground at the middle of a cell.
struct Surface {
    GridCell cell;
    double y = 0.0;
    collision::ObjectId object{};
    std::uint32_t triangle = 0;  ///< of the object's mesh; 0 for a box
};

/// All surfaces in the region that aren't too steep, by cell from low to high, without those on one another.
/// Those of round solids aren't found. Where there are more than `most`, only some, but more than that.
std::vector<Surface> walkable_surfaces(const collision::World& world, const ExploreSettings& settings,
                                       const WalkGrid& grid, const collision::Aabb& region,
                                       std::size_t most = std::numeric_limits<std::size_t>::max());

/// More than these aren't looked for: they would take some gigabytes.
inline constexpr std::size_t kMostUnreached = 30'000'000;

/// Likewise, those that have no reached node, without those so close below others that no body touches them.
/// What sticks out less than a third of a cell from under another counts as below it. None, for any number of
/// workers, if there are more than `most`, or so many surfaces of all kinds in a small part of the region.
std::optional<std::vector<Surface>> unreached_surfaces(const WorkerWorlds& worlds,
                                                       const ExploreSettings& settings,
                                                       const WalkSpace& reached,
                                                       const collision::Aabb& region,
                                                       std::size_t most = kMostUnreached);

}  // namespace campuswalk::engine

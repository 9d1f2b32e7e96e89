#pragma once

#include <optional>
#include <vector>

#include "engine/walkspace/barrier/why_not.h"
#include "engine/walkspace/explore/unreached_ground.h"

namespace campuswalk::engine {

/// Whether an island lies apart from the ground that is reached with nothing between, as one piece of a
/// terrain beside another: from the nearest of these states that is at about its height to its nearest spot,
/// over which one sees from there, and without ground below all that line. None if something stands between,
/// or if there is ground.
std::optional<Barrier> find_gap(const collision::World& world, const ExploreSettings& settings,
                                const Island& island, const std::vector<GroundState>& reached);

}  // namespace campuswalk::engine

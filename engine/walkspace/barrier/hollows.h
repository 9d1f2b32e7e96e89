#pragma once

#include "collision/world/world.h"
#include "engine/walkspace/explore/explore.h"
#include "engine/walkspace/explore/unreached_ground.h"
#include "engine/walkspace/space/walk_space.h"

namespace campuswalk::engine {

/// Whether solids enclose the island: its air leads neither to the sky, nor out of the world, nor to a
/// visitor who stands where one gets to. Openings narrower than a quarter of a metre may be overlooked; in
/// halls of over 900 m³ narrower than half a metre, of over 7,500 m³ than a metre. False beyond 60,000 m³.
bool is_enclosed(const collision::World& world, const ExploreSettings& settings, const WalkSpace& reached,
                 const Island& island);

}  // namespace campuswalk::engine

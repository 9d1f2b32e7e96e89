#pragma once

#include <cstdint>
#include <vector>

#include "scene/suggest/suggested_buildings.h"
#include "scene/suggest/walkable_ground.h"
#include "tools/campuswalk/suggest/campus_text.h"

namespace campuswalk::tools {

/// Plans visits from the spawn to the nearest building and from each to the next, three at most; if there is
/// none to reach, a walk of a few metres.
std::vector<SuggestedVisit> plan_visits(std::uint32_t spawn, const scene::WalkableGround& ground,
                                        std::vector<scene::SuggestedBuilding> buildings);

}  // namespace campuswalk::tools

#pragma once

#include <vector>

#include "engine/walkspace/walk_space.h"
#include "scene/suggest/suggested_buildings.h"
#include "tools/campuswalk/suggest/campus_text.h"

namespace campuswalk::tools {

/// Plans visits from the spawn to the nearest building that is reached and from each to the next, three at
/// most; if there is none, a walk of a few metres.
std::vector<SuggestedVisit> plan_visits(const engine::WalkSpace& reached, engine::Strider& strider,
                                        const Eigen::Vector3d& spawn,
                                        std::vector<scene::SuggestedBuilding> buildings);

}  // namespace campuswalk::tools

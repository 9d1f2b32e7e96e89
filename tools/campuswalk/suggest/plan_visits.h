#pragma once

#include <vector>

#include "engine/walkspace/space/walk_space.h"
#include "scene/suggest/suggested_buildings.h"
#include "tools/campuswalk/suggest/campus_text.h"
#include "tools/campuswalk/suggest/interiors.h"

namespace campuswalk::tools {

/// Plans visits from the spawn to the nearest building that is reached and from each to the next, three at
/// most, first of those that are entered, with two of their rooms each; before, two rooms of the building
/// that the spawn is in. If there is nothing to visit, far corners of what is reached, two at most.
/// `interiors` are find_interiors of the buildings.
std::vector<SuggestedVisit> plan_visits(const engine::WalkSpace& reached, engine::Strider& strider,
                                        const Eigen::Vector3d& spawn,
                                        const std::vector<scene::SuggestedBuilding>& buildings,
                                        const std::vector<Interior>& interiors);

/// Adds visits, from where those so far end, to the nearest place that is reached and from each to the next,
/// five at most. They replace a walk that leads nowhere.
void add_place_visits(const engine::WalkSpace& reached, engine::Strider& strider,
                      const Eigen::Vector3d& spawn, const std::vector<scene::Place>& places,
                      std::vector<SuggestedVisit>& visits);

}  // namespace campuswalk::tools

#pragma once

#include <vector>

#include "scene/lint/model_report.h"
#include "scene/suggest/suggested_buildings.h"

namespace campuswalk::tools {

/// A box below the whole model and its surroundings. Its top is at the median of the buildings' thresholds,
/// as the missing ground may be a slope.
scene::Bounds substitute_ground(const scene::ModelReport& report,
                                const std::vector<scene::SuggestedBuilding>& buildings);

}  // namespace campuswalk::tools

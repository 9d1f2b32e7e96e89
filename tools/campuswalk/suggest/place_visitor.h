#pragma once

#include <optional>

#include "engine/walkspace/explore/explore.h"
#include "scene/campus/campus.h"
#include "scene/lint/model_report.h"
#include "tools/campuswalk/suggest/campus_text.h"

namespace campuswalk::tools {

/// Chooses the spawn of `campus`, where to look from it, where to go and what can be entered. `solid` is what
/// it describes without them. Returns how what is reached from the spawn was explored, with the grid; none if
/// there is hardly any ground.
std::optional<engine::ExploreSettings> place_visitor(const scene::ModelReport& report,
                                                     const scene::Campus& solid, SuggestedCampus& campus);

}  // namespace campuswalk::tools

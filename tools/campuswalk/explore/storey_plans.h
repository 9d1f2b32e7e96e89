#pragma once

#include <vector>

#include "engine/render/plan/storey_plan.h"
#include "engine/walkspace/walk_report.h"
#include "scene/campus/campus.h"
#include "tools/campuswalk/explore/findings.h"

namespace campuswalk::tools::explore {

/// A plan for each storey, with the findings at its height under their numbers in the report.
std::vector<engine::render::StoreyPlan> storey_plans(const scene::Campus& campus,
                                                     const engine::WalkReport& report,
                                                     const std::vector<Finding>& findings);

}  // namespace campuswalk::tools::explore

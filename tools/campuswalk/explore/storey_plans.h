#pragma once

#include <vector>

#include "engine/render/plan/storey_plan.h"
#include "engine/walkspace/report/walk_report.h"
#include "scene/campus/campus.h"
#include "tools/campuswalk/explore/findings.h"

namespace campuswalk::tools::explore {

/// How wide passages are, which then colours what is reached.
struct GroundWidths {
    std::vector<float> of_nodes = {};  ///< as engine::passage_widths returns them; empty: plain colours
    double narrowest = 0.0;            ///< of the body itself, metres
    double widest = 3.0;               ///< metres: what is wider is plain
};

/// A plan for each storey, with the findings on its ground under their numbers in the report, and what isn't
/// reached if a finding is about it. Throws scene::InputError of the option --map if what is reached on a
/// storey lies too far apart for one plan.
std::vector<engine::render::StoreyPlan> storey_plans(const scene::Campus& campus,
                                                     const engine::WalkReport& report,
                                                     const std::vector<Finding>& findings,
                                                     const GroundWidths& widths = {});

}  // namespace campuswalk::tools::explore

#pragma once

#include <string>
#include <vector>

#include "engine/walkspace/report/walk_report.h"
#include "scene/campus/campus.h"
#include "tools/campuswalk/explore/coverage.h"
#include "tools/campuswalk/explore/findings.h"

namespace campuswalk::tools::explore {

/// The report for programs, as config/schema/explore.schema.json says. `coverage` may be null.
std::string report_json(const scene::Campus& campus, const engine::WalkReport& report,
                        const std::vector<Finding>& findings, const Coverage* coverage);

}  // namespace campuswalk::tools::explore

#pragma once

#include <cstddef>
#include <vector>

#include "engine/script/walk.h"
#include "engine/walkspace/report/walk_report.h"
#include "scene/campus/campus.h"

namespace campuswalk::tools::explore {

/// How much of what can be reached given walks visit.
struct Coverage {
    std::size_t walks = 0;
    std::size_t failed = 0;  ///< of them, an xfail if it passes; what they visited before they ended counts
    double area = 0.0;       ///< of the ground under their visitors' bodies, m²
    double share = 0.0;      ///< of the ground that is reached, 0 to 1
    std::vector<bool> visited = {};  ///< by subject of the report: buildings and triggers
};

/// Plays the walks; their campus is the report's.
Coverage measure_coverage(const scene::Campus& campus, const engine::WalkReport& report,
                          const std::vector<engine::Walk>& walks);

}  // namespace campuswalk::tools::explore

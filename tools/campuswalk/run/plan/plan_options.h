#pragma once

#include <optional>
#include <set>
#include <string>

#include "collision/geometry/shapes.h"
#include "tools/campuswalk/run/plan/run_options.h"
#include "tools/campuswalk/run/plan/selector.h"

namespace campuswalk::tools {

/// What decides which cases a run has, besides its settings.
struct PlanOptions {
    Selector selector;
    std::optional<std::set<std::string>> ids;  ///< only these cases
    int repeat_each = 1;
    std::optional<collision::TreeKind> tree;
    std::optional<double> max_timeout;  ///< seconds; limits the walks' own timeouts, too
    bool images = false;                ///< images will be drawn
    bool summary_only = false;          ///< no cases, so that no campus is loaded
};

/// All but what depends on the machine and on an earlier run. Throws scene::InputError (bad-regex).
PlanOptions plan_options(const RunOptions& options);

}  // namespace campuswalk::tools

#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/report/walk_result.h"
#include "scene/base/diagnostic.h"
#include "tools/campuswalk/loading/walk_loader.h"
#include "tools/campuswalk/run/plan/run_settings.h"
#include "tools/campuswalk/run/plan/selector.h"

namespace campuswalk::tools {

/// A walk, in a project, in a repetition.
struct Case {
    engine::WalkResult result;               ///< what is known before it is played
    std::shared_ptr<const LoadedWalk> walk;  ///< null when it isn't to be played
    std::string folder;                      ///< for what it leaves behind, below the output folder, with `/`
};

/// What a run consists of, in the order in which it is told of: by file, project and repetition.
struct Plan {
    std::vector<Case> cases;
    std::size_t selected = 0;  ///< cases before they were divided into shards
    std::size_t files = 0;     ///< walk files there are
};

struct PlanOptions {
    Selector selector;
    std::optional<std::set<std::string>> ids;  ///< only these cases
    int repeat_each = 1;
    std::optional<collision::TreeKind> tree;
};

/// Which walks a project plays. Throws scene::InputError (bad-regex).
Selector selector_of(const config::ProjectConfig& project);

/// Reads and checks every walk that is wanted; those with mistakes become cases that say so, after their
/// mistakes have been printed. Throws scene::InputError for what concerns the run as a whole.
Plan make_plan(const RunSettings& settings, PlanOptions options);

/// Prints what would be played, a case a line, with its tags and its status.
void print_cases(const Plan& plan);

}  // namespace campuswalk::tools

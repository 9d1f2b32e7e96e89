#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "engine/report/run_plan.h"
#include "engine/report/walk_result.h"
#include "tools/campuswalk/loading/walk_loader.h"
#include "tools/campuswalk/run/plan/plan_options.h"
#include "tools/campuswalk/run/plan/run_settings.h"

namespace campuswalk::tools {

/// A walk, in a project, in a repetition.
struct Case {
    engine::WalkResult result;               ///< what is known before it is played
    std::shared_ptr<const LoadedWalk> walk;  ///< null if it isn't to be played
    std::string folder;                      ///< of its files, relative to the output folder, with `/`
};

/// Files that belong together.
struct Inputs {
    std::string owner;  ///< the file of a campus or a walk, as found
    std::set<std::filesystem::path> files;
};

/// The cases of a run in the order in which they are reported: by file, project and repetition.
struct Plan {
    std::vector<Case> cases;
    engine::RunPlan summary;  ///< for reports
    std::size_t files = 0;    ///< number of walk files found
    /// Number of selected walks, of all shards: of files or, if the run is strict, of different contents.
    std::size_t walks = 0;
    std::size_t same_walks = 0;  ///< number of further selected files, each the same as one of them
    std::size_t left_out = 0;    ///< number of selected walks that aren't marked `only` where others are
    std::vector<std::string> other_folders;  ///< as Case::folder, of the walks in other shards
    /// What the walks of all shards are read from or compared with besides YAML files: of each campus, once,
    /// its models, buffers, textures and lists of places; of each walk its golden files.
    std::vector<Inputs> inputs;
};

/// Reads and checks every selected walk. Prints the errors of walks, which become cases with these errors.
/// Throws scene::InputError for errors of the run as a whole.
Plan make_plan(const RunSettings& settings, const PlanOptions& options);

/// Throws scene::InputError (too-few-cases) if there are fewer walks.
void require_walks(const Plan& plan, int at_least);

/// Prints what would be played, one case per line, with its tags and its status.
void print_cases(const Plan& plan);

}  // namespace campuswalk::tools

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "config/loader/load_run.h"
#include "engine/report/walk_result.h"
#include "tools/campuswalk/loading/walk_loader.h"
#include "tools/campuswalk/run/plan/plan_options.h"
#include "tools/campuswalk/run/plan/run_settings.h"

namespace campuswalk::tools {

/// A walk in a project, as far as it could be read.
struct PlannedWalk {
    engine::WalkResult result;       ///< what is known before it is played
    std::string folder;              ///< of its files, as Case::folder, without the repetition
    std::optional<config::Run> run;  ///< nullopt if it has errors

    /// Whether there is something to play.
    bool is_playable() const { return run && result.outcome != engine::Outcome::skipped; }
    /// The id of its case in a repetition, counted from 0, of so many.
    std::string id_of(int repetition, int repeat_each) const;
};

/// The walks of a run, by file and project.
struct SelectedWalks {
    std::vector<PlannedWalk> walks;
    std::size_t files = 0;     ///< number of walk files found
    std::size_t left_out = 0;  ///< number of selected walks that aren't marked `only` where others are
};

/// Reads every walk file, and keeps those walks that the settings and options select; a walk's errors become
/// part of its result. Throws scene::InputError for errors of the run as a whole.
SelectedWalks select_walks(const RunSettings& settings, const PlanOptions& options, WalkLoader& loader);

/// Throws them as a scene::InputError, unless there are none.
void refuse(std::vector<scene::Diagnostic> errors);

/// Adds the errors to the walk's result.
void note_errors(engine::WalkResult& result, const scene::InputError& error);

}  // namespace campuswalk::tools

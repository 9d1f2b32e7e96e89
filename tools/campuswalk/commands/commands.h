#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision/geometry/shapes.h"
#include "scene/campus/campus.h"
#include "scene/campus/campus_description.h"
#include "tools/campuswalk/cluster/slurm_options.h"
#include "tools/campuswalk/command_line/command.h"
#include "tools/campuswalk/images/rendering_backend.h"
#include "tools/campuswalk/run/plan/run_options.h"

namespace campuswalk::tools {

// Each function adds a command with its options, from a file of the same name. The command that the user
// names sets `chosen`.

void add_init(Command program, CommandAction& chosen);
void add_import(Command program, CommandAction& chosen);
void add_validate(Command program, CommandAction& chosen);
void add_run(Command program, CommandAction& chosen);
void add_merge_reports(Command program, CommandAction& chosen);
void add_report(Command program, CommandAction& chosen);
void add_diff(Command program, CommandAction& chosen);
void add_imgdiff(Command program, CommandAction& chosen);
void add_replay(Command program, CommandAction& chosen);
void add_info(Command program, CommandAction& chosen);
void add_snapshot(Command program, CommandAction& chosen);
void add_collide(Command program, CommandAction& chosen);
void add_explore(Command program, CommandAction& chosen);
void add_route(Command program, CommandAction& chosen);
void add_completion(Command program, CommandAction& chosen);
void add_help(Command program, CommandAction& chosen);

// Options that several commands have, in shared_options.cpp.

/// `--up` and `--scale`: how to read model files that no campus file describes. `whose` ends the help texts,
/// as in "the file".
void add_file_frame(Command command, scene::SceneFile& file, const std::string& whose);
/// Whether the user has typed the option.
bool is_typed(const Command& command, const std::string& option);
/// `--rendering-backend`, for a command that draws.
void add_rendering_backend(Command command, Backend& backend);
/// `--tree`: the kind of trees of the walks' campuses.
void add_tree(Command command, std::optional<collision::TreeKind>& tree);
/// `--color`, for a command that prints reports.
void add_color(Command command, ColorChoice& color);

/// `--report-geometry`, for a command that writes html reports.
void add_report_geometry(Command command, ReportGeometry& geometry);

/// `--slurm` and the options of sbatch.
void add_slurm(Command command, SlurmOptions& options);
/// Throws scene::InputError (bad-value) for options of sbatch without --slurm.
void check_slurm(const SlurmOptions& options);
/// What is wrong with the number of a job of Slurm as written; empty when nothing is.
std::string why_no_job_number(const std::string& text);

/// `--disable`: globs over the campus' objects.
void add_disable(Command command, std::vector<std::string>& globs);
/// By object, whether a glob of `--disable` matches it. Throws for a glob that matches none.
std::vector<bool> disabled_objects(const scene::Campus& campus, const std::vector<std::string>& globs);

}  // namespace campuswalk::tools

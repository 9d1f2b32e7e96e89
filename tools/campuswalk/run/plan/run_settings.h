#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "config/loader/walks_config.h"
#include "engine/script/image_tolerance.h"
#include "scene/base/diagnostic.h"
#include "tools/campuswalk/base/json_text.h"
#include "tools/campuswalk/run/plan/run_options.h"
#include "tools/campuswalk/run/plan/shard.h"

namespace campuswalk::tools {

/// One report and where it goes.
struct ReportTarget {
    std::string name;                           ///< of a reporter, or "log"
    std::optional<std::filesystem::path> file;  ///< nullopt: standard output
    /// Where walks.config.yaml names it. Then it replaces only a report of the same kind.
    std::optional<scene::SourceMark> configured = {};
};

/// The settings of a run, from command line, walks.config.yaml and environment. Paths are as seen from the
/// current folder.
struct RunSettings {
    std::vector<std::filesystem::path> paths;
    bool single = false;                          ///< one walk, named by its file
    std::filesystem::path config;                 ///< empty if there is none
    std::vector<config::ProjectConfig> projects;  ///< the selected ones; one without a name if there are none
    std::optional<Shard> shard;
    std::optional<std::filesystem::path> shard_times;  ///< see case_times.h
    int workers = 1;
    std::optional<int> max_failures;
    std::optional<double> timeout;
    std::optional<double> kill_after;
    bool forbid_only = false;
    bool ci = false;      ///< CI is set: the project is a checkout of what anybody may have written
    bool strict = false;  ///< see strict_rules.h; images that can't be evaluated are failures
    int min_cases = 0;    ///< a run of fewer walks is an error
    std::filesystem::path output;
    std::filesystem::path saved;        ///< the file of results that a later run can use
    std::vector<ReportTarget> reports;  ///< that to standard output first, if there is one
    std::vector<std::string> records;   ///< names of what is recorded of each walk
    UpdateSnapshots update = UpdateSnapshots::none;
    engine::ImageTolerance tolerance;  ///< of snapshots, unless a walk says otherwise
    bool color = false;
};

/// Throws scene::InputError for invalid options, such as an unknown reporter or project.
RunSettings resolve_settings(const RunOptions& options, const Environment& environment);

/// Throws scene::InputError (unknown-name) when there is no such reporter.
void check_reporter(const std::string& name, const scene::SourceMark& mark);

/// Only the settings of reports.
RunSettings resolve_report_settings(const RunOptions& options, const Environment& environment);

Json json_of(const engine::ImageTolerance& tolerance);

/// As JSON, for `--print-config`.
std::string to_json(const RunSettings& settings, const RunOptions& options);

}  // namespace campuswalk::tools

#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "config/loader/walks_config.h"
#include "engine/script/image_tolerance.h"
#include "scene/base/diagnostic.h"
#include "tools/campuswalk/run/plan/run_options.h"
#include "tools/campuswalk/run/plan/shard.h"

namespace campuswalk::tools {

/// Where one of the reports goes.
struct ReportTarget {
    std::string name;                           ///< of a reporter, or "log"
    std::optional<std::filesystem::path> file;  ///< standard output without one
};

/// How a run is done, once command line, walks.config.yaml and environment have been heard. Paths are as seen
/// from the current folder.
struct RunSettings {
    std::vector<std::filesystem::path> paths;
    bool single = false;                          ///< one walk, named by its file
    std::filesystem::path config;                 ///< empty without
    std::vector<config::ProjectConfig> projects;  ///< those wanted; one without a name if there are none
    std::optional<Shard> shard;
    int workers = 1;
    std::optional<int> max_failures;
    std::optional<double> timeout;
    std::optional<double> kill_after;
    bool forbid_only = false;
    std::filesystem::path output;
    std::vector<ReportTarget> reports;  ///< standard output's first, if there is any
    UpdateSnapshots update = UpdateSnapshots::missing;
    engine::ImageTolerance tolerance;  ///< of snapshots that are compared, where a walk doesn't say
    bool color = false;
};

/// Throws scene::InputError for what can't be meant, as an unknown reporter or project.
RunSettings settle(const RunOptions& options, const Environment& environment);

/// Throws scene::InputError (unknown-name) when there is no such reporter.
void check_reporter(const std::string& name, const scene::SourceMark& mark);

/// What reports alone need of it.
RunSettings settle_reports(const RunOptions& options, const Environment& environment);

/// As JSON, for `--print-config`.
std::string to_json(const RunSettings& settings, const RunOptions& options);

}  // namespace campuswalk::tools

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "config/loader/overrides.h"
#include "config/loader/search_paths.h"
#include "engine/script/image_tolerance.h"
#include "scene/base/diagnostic.h"

namespace campuswalk::config {

/// A text and where it is written, for diagnostics of code that checks it later.
struct MarkedText {
    scene::SourceMark mark;
    std::string text;
};

struct MarkedPath {
    scene::SourceMark mark;
    std::filesystem::path path;
};

struct ConfiguredReporter {
    scene::SourceMark mark;
    std::string name;
    std::optional<std::filesystem::path> file;  ///< standard output without one
};

/// Which walks a project runs, and with which campus, avatar and spawn.
struct ProjectConfig {
    scene::SourceMark mark;
    std::string name;
    Overrides overrides;
    std::optional<MarkedText> grep;         ///< only walks that match this regular expression
    std::optional<MarkedText> grep_invert;  ///< only walks that don't match this one
    std::vector<std::string> tags;          ///< only walks with one of these; all of them if there are none
    std::optional<double> timeout;          ///< simulated seconds, for walks without their own
};

/// `walks.config.yaml`. Paths are resolved against its folder.
struct WalksConfig {
    std::filesystem::path file;
    std::vector<MarkedPath> walks;  ///< files, or folders to search for *.walk.yaml
    std::optional<MarkedPath> output;
    std::vector<ConfiguredReporter> reporters;
    std::optional<int> workers;
    std::optional<int> max_failures;
    std::optional<double> timeout;     ///< simulated seconds, for walks without their own
    std::optional<double> kill_after;  ///< wall-clock seconds that a walk may take
    bool forbid_only = false;
    bool strict = false;                  ///< nothing counts as passed that wasn't evaluated
    std::optional<int> min_cases;         ///< a run of fewer walks is an error
    engine::ToleranceChanges snapshots;   ///< for images that are compared
    std::vector<ProjectConfig> projects;  ///< sorted by name
};

/// Throws scene::InputError with all errors; search_paths.h lists their codes.
WalksConfig load_walks_config(const std::filesystem::path& file, const SearchPaths& search = {});

/// `walks.config.yaml` in the folder or in the nearest one above that has one (see folders_upwards.h).
std::optional<std::filesystem::path> find_walks_config(const std::filesystem::path& folder);

}  // namespace campuswalk::config

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "config/loader/overrides.h"
#include "engine/script/image_tolerance.h"
#include "scene/base/diagnostic.h"

namespace campuswalk::config {

/// A text and where it stands, for whoever finds out later whether it holds.
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

/// One way to play the walks: with whose body, on which campus, from where, and which of them.
struct ProjectConfig {
    scene::SourceMark mark;
    std::string name;
    Overrides overrides;
    std::optional<MarkedText> grep;         ///< only walks that the regular expression finds
    std::optional<MarkedText> grep_invert;  ///< only walks that it doesn't
    std::vector<std::string> tags;          ///< only walks with one of these; all of them if there are none
    std::optional<double> timeout;          ///< simulated seconds, for walks without their own
};

/// `walks.config.yaml`. Paths are resolved against its folder.
struct WalksConfig {
    std::filesystem::path file;
    std::vector<MarkedPath> walks;  ///< files, or folders to look for *.walk.yaml in
    std::optional<std::filesystem::path> output;
    std::vector<ConfiguredReporter> reporters;
    std::optional<int> workers;
    std::optional<int> max_failures;
    std::optional<double> timeout;     ///< simulated seconds, for walks without their own
    std::optional<double> kill_after;  ///< seconds of wall clock a walk may take
    bool forbid_only = false;
    engine::ToleranceChanges snapshots;   ///< for images that are compared
    std::vector<ProjectConfig> projects;  ///< in the order of their names
};

/// Throws scene::InputError with all mistakes, with the codes of load_run.h.
WalksConfig load_walks_config(const std::filesystem::path& file);

/// `walks.config.yaml` in the folder or the nearest one above it that has it.
std::optional<std::filesystem::path> find_walks_config(const std::filesystem::path& folder);

}  // namespace campuswalk::config

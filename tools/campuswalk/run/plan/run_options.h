#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/campuswalk/images/rendering_backend.h"
#include "tools/campuswalk/images/sequence_request.h"
#include "tools/campuswalk/logs/golden_log.h"

namespace campuswalk::tools {

enum class ColorChoice { automatic, always, never };

/// What the command line of `run` says. Where something is left out, walks.config.yaml is asked, then a
/// default.
struct RunOptions {
    std::vector<std::filesystem::path> paths;     ///< walks, or folders to look for them in
    std::optional<std::filesystem::path> config;  ///< in the place of the walks.config.yaml found upwards

    std::optional<std::string> grep;
    std::optional<std::string> grep_invert;
    std::vector<std::string> tags;      ///< a walk needs one of them
    std::vector<std::string> projects;  ///< names; all of them if there are none
    std::optional<std::string> shard;   ///< "i/n"
    bool last_failed = false;
    bool forbid_only = false;
    bool pass_with_no_tests = false;
    bool list = false;          ///< say what would be run
    bool print_config = false;  ///< say how it would be run
    bool watch = false;         ///< run again whenever a file changes

    std::optional<int> workers;
    bool stop_at_first = false;
    std::optional<int> max_failures;
    int repeat_each = 1;
    bool require_identical = false;
    std::optional<collision::TreeKind> tree;
    std::optional<double> timeout;     ///< simulated seconds
    std::optional<double> kill_after;  ///< seconds of wall clock
    bool resume = false;
    std::optional<UpdateSnapshots> update;

    std::optional<std::filesystem::path> output;
    std::vector<std::string> reporters;  ///< NAME or NAME=FILE
    std::vector<std::string> records;    ///< names of record_kinds()
    SequenceRequest sequence;
    std::optional<std::filesystem::path> log;    ///< the text log once more, in a file
    std::optional<std::filesystem::path> jsonl;  ///< the events as JSON lines
    Backend backend = engine::render::RenderingBackend::automatic;
    bool quiet = false;
    bool verbose = false;
    ColorChoice color = ColorChoice::automatic;
};

}  // namespace campuswalk::tools

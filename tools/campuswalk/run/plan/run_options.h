#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/campuswalk/images/rendering_backend.h"
#include "tools/campuswalk/images/sequence_request.h"
#include "tools/campuswalk/logs/golden_log.h"

namespace campuswalk::tools {

enum class ColorChoice { automatic, always, never };

/// Whether a run must find saved results to continue from, or may start anew without.
enum class Resume { required, automatic };

/// How much of a campus an html report shows.
enum class ReportGeometry {
    exact,       ///< every triangle
    simplified,  ///< to a few centimetres
    boxes,       ///< of its objects
    none,
};

/// The command line of `run`. What it leaves out is taken from walks.config.yaml or else is a default.
struct RunOptions {
    std::vector<std::filesystem::path> paths;     ///< walks, or folders to look for them in
    std::optional<std::filesystem::path> config;  ///< instead of the walks.config.yaml found upwards

    std::optional<std::string> grep;
    std::optional<std::string> grep_invert;
    std::vector<std::string> tags;                     ///< a walk needs at least one of them
    std::vector<std::string> projects;                 ///< names; all projects if empty
    std::optional<std::string> shard;                  ///< "i/n"
    std::optional<std::filesystem::path> shard_times;  ///< by which the shards are balanced
    bool last_failed = false;
    bool forbid_only = false;
    bool strict = false;
    std::optional<int> min_cases;
    bool pass_with_no_tests = false;
    bool list = false;          ///< list what would be run
    bool print_config = false;  ///< print the settings of the run
    bool watch = false;         ///< run again whenever a file changes

    std::optional<int> workers;
    bool stop_at_first = false;
    std::optional<int> max_failures;
    int repeat_each = 1;
    bool require_identical = false;
    std::optional<collision::TreeKind> tree;
    std::optional<double> timeout;     ///< simulated seconds
    std::optional<double> kill_after;  ///< seconds of wall clock
    std::optional<Resume> resume;
    std::optional<UpdateSnapshots> update;

    std::optional<std::filesystem::path> output;
    std::optional<std::filesystem::path> save;  ///< instead of OUTPUT/last-run.jsonl
    std::vector<std::string> reporters;         ///< NAME or NAME=FILE
    std::vector<std::string> records;           ///< names of record_kinds()
    ReportGeometry report_geometry = ReportGeometry::simplified;
    SequenceRequest sequence;
    std::optional<std::filesystem::path> log;    ///< the text log, also in a file
    std::optional<std::filesystem::path> jsonl;  ///< the events as JSON lines
    Backend backend = engine::render::RenderingBackend::automatic;
    bool quiet = false;
    bool verbose = false;
    ColorChoice color = ColorChoice::automatic;
};

}  // namespace campuswalk::tools

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/expect/failure.h"

namespace campuswalk::engine {

enum class Outcome {
    passed,       ///< as expected; also an xfail that failed as it said
    failed,       ///< an expectation was not met, a step gave up, or an xfail passed
    skipped,      ///< `status: skip`
    bad_input,    ///< not run: its files have mistakes
    broken,       ///< it ended with an error that is not the walk's: disk full, a crash, killed
    interrupted,  ///< not finished when the run was stopped
};

/// A file that a walk left behind. Paths are relative to the run's output folder, with `/`.
struct Artifact {
    std::string name;  ///< "log", "trajectory", "failure from above", a snapshot's name, …
    std::string path;
    std::string media_type;  ///< "image/png", "text/csv", …
};

/// What is known of one case, a walk in a project in a repetition, once it has ended. Plain data: it
/// travels between processes and into reports as JSON (see result_json.h). Knows no clock and no absolute
/// path, so that equal runs give equal bytes.
struct WalkResult {
    std::string id;       ///< unique in a run: FILE[ PROJECT][ #REPETITION]
    std::string file;     ///< the walk file as found, relative to where the run was started, with `/`
    std::string name;     ///< NAME of NAME.walk.yaml
    std::string project;  ///< of walks.config.yaml; empty without
    std::string config;   ///< that file, as found, when there is a project
    int repetition = 0;   ///< of --repeat-each, from 0
    std::vector<std::string> tags;
    std::string status_reason;  ///< of a skip or an xfail
    bool expected_to_fail = false;

    Outcome outcome = Outcome::passed;
    std::vector<Failure> failures;         ///< of an xfail too
    std::vector<std::string> diagnostics;  ///< bad_input, broken: `file:line:col: error CODE: message`
    std::string campus;
    int ticks_per_second = 60;
    std::optional<double> timeout;  ///< simulated seconds for all of it, whoever said so
    Tick ticks = 0;
    std::int64_t events = 0;
    double distance = 0.0;  ///< metres
    std::uint64_t hash = 0;
    std::vector<Artifact> artifacts;
};

/// A whole run, results in the plan's order: by file, project and repetition.
struct RunReport {
    std::vector<WalkResult> results;
};

}  // namespace campuswalk::engine

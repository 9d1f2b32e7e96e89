#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/expect/failure.h"
#include "scene/base/diagnostic.h"

namespace campuswalk::engine {

enum class Outcome {
    passed,       ///< as expected; also an xfail that failed as its status says
    failed,       ///< an expectation doesn't hold, a step gave up, or an xfail passed
    skipped,      ///< `status: skip`
    bad_input,    ///< not run: there are errors in its files
    broken,       ///< an error outside the walk ended it: disk full, a crash, killed
    interrupted,  ///< not finished when the run was stopped
};

/// As in reports.
constexpr std::array<std::pair<Outcome, std::string_view>, 6> kOutcomeNames = {{
    {Outcome::passed, "passed"},
    {Outcome::failed, "failed"},
    {Outcome::skipped, "skipped"},
    {Outcome::bad_input, "bad_input"},
    {Outcome::broken, "broken"},
    {Outcome::interrupted, "interrupted"},
}};

constexpr std::string_view name_of(Outcome outcome) {
    for (const auto& [value, name] : kOutcomeNames) {
        if (value == outcome) {
            return name;
        }
    }
    return "";
}

/// A file that a walk has written. Paths are relative to the run's output folder, with `/`.
struct Artifact {
    std::string name;  ///< "log", "trajectory", "failure from above", a snapshot's name, …
    std::string path;
    std::string media_type;  ///< "image/png", "text/csv", …
};

/// The result of a case: a walk in a project and a repetition. Plain data, which processes exchange and
/// reports contain as JSON (see result_json.h). It has no wall-clock time and no absolute path, so that equal
/// runs produce equal bytes.
struct WalkResult {
    std::string id;    ///< unique in a run: FILE[ PROJECT][ #REPETITION]
    std::string file;  ///< the walk file as found, relative to the folder where the run was started, with `/`
    std::string name;  ///< NAME of NAME.walk.yaml
    std::string project;  ///< of walks.config.yaml; empty if there is none
    std::string config;   ///< that file, as found, if there is a project
    int repetition = 0;   ///< of --repeat-each, from 0
    std::vector<std::string> tags;
    std::string status_reason;  ///< of a skip or an xfail
    bool expected_to_fail = false;

    Outcome outcome = Outcome::passed;
    std::vector<Failure> failures;  ///< of an xfail too
    std::vector<scene::Diagnostic>
        diagnostics;  ///< bad_input, broken: errors, of a broken one without a code
    std::string campus;
    int ticks_per_second = 60;
    std::optional<double> timeout;  ///< simulated seconds for the whole walk, wherever it was set
    Tick ticks = 0;
    std::int64_t events = 0;
    double distance = 0.0;            ///< metres
    std::uint32_t not_evaluated = 0;  ///< expectations about images where none are drawn
    std::uint64_t hash = 0;
    std::vector<Artifact> artifacts;
};

/// A whole run, results in the plan's order: by file, project and repetition.
struct RunReport {
    std::vector<WalkResult> results;
};

}  // namespace campuswalk::engine

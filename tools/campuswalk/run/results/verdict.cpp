#include "tools/campuswalk/run/results/verdict.h"

#include "engine/events/decimals.h"
#include "scene/base/diagnostic.h"
#include "tools/campuswalk/base/exit_codes.h"

namespace campuswalk::tools {

using engine::Outcome;
using engine::WalkResult;

namespace {

std::string shown_name(const WalkResult& result) {
    const std::size_t repetition = result.id.rfind(" #");
    return result.name + (result.project.empty() ? "" : " [" + result.project + "]") +
           (repetition == std::string::npos ? "" : result.id.substr(repetition));
}

std::string after(const WalkResult& result) {
    const double seconds = static_cast<double>(result.ticks) / result.ticks_per_second;
    return " after " + engine::fixed(seconds, 1) + " s and " + engine::fixed(result.distance, 1) + " m";
}

std::string because(const WalkResult& result) {
    return result.status_reason.empty() ? "" : ": " + result.status_reason;
}

}  // namespace

bool is_good(const WalkResult& result) {
    return result.outcome == Outcome::passed || result.outcome == Outcome::skipped;
}

std::vector<std::string> verdict_lines(const WalkResult& result, const std::filesystem::path& output) {
    std::vector<std::string> lines;
    const bool as_expected = result.expected_to_fail && result.outcome == Outcome::passed;
    if (result.outcome == Outcome::failed) {
        for (const engine::Failure& failure : result.failures) {
            lines.push_back(scene::error_line(failure.mark, failure.code, failure.message));
        }
        for (const engine::Artifact& artifact : result.artifacts) {
            if (artifact.name.starts_with("failure ")) {
                lines.push_back(artifact.name + ": " + (output / artifact.path).generic_string());
            }
        }
    }
    const std::string name = shown_name(result);
    switch (result.outcome) {
        case Outcome::passed:
            lines.push_back(name + (as_expected ? ": fails as expected" : ": pass") + after(result) +
                            (as_expected ? because(result) : ""));
            break;
        case Outcome::failed:
            lines.push_back(name + ": FAIL" + after(result));
            break;
        case Outcome::skipped:
            lines.push_back(name + ": skipped" + because(result));
            break;
        case Outcome::broken:
            for (const scene::Diagnostic& diagnostic : result.diagnostics) {
                lines.push_back(to_string(diagnostic));
            }
            break;
        case Outcome::bad_input:
        case Outcome::interrupted:
            break;  // the errors have been printed, and the run is about to say that it was interrupted
    }
    return lines;
}

int exit_code_of(const std::set<Outcome>& outcomes) {
    const auto some = [&](Outcome outcome) { return outcomes.contains(outcome); };
    return some(Outcome::interrupted) ? kInterrupted
           : some(Outcome::broken)    ? kRunFailed
           : some(Outcome::bad_input) ? kBadInput
           : some(Outcome::failed)    ? kExpectationFailed
                                      : kPass;
}

int exit_code_for(const std::vector<WalkResult>& results) {
    std::set<Outcome> outcomes;
    for (const WalkResult& result : results) {
        outcomes.insert(result.outcome);
    }
    return exit_code_of(outcomes);
}

void compare_repetitions(const WalkResult& first, WalkResult& later) {
    const bool both_played =
        later.outcome <= Outcome::failed && first.outcome <= Outcome::failed;  // passed or failed
    if (!both_played || (first.hash == later.hash && first.ticks == later.ticks)) {
        return;
    }
    engine::Failure failure;
    failure.mark.file = later.file;
    failure.code = engine::kNotIdentical;
    failure.message = "repetition " + std::to_string(later.repetition + 1) + " ended with hash " +
                      engine::hexadecimal(later.hash) + " after " + std::to_string(later.ticks) +
                      " ticks, the first with " + engine::hexadecimal(first.hash) + " after " +
                      std::to_string(first.ticks);
    later.outcome = Outcome::failed;
    later.failures.push_back(std::move(failure));
}

}  // namespace campuswalk::tools

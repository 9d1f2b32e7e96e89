#pragma once

#include <string>

#include "engine/report/walk_result.h"

namespace campuswalk::engine {

// Words as they are: the reporter that makes them part of its text calls scene::printable() or its own
// format's escape, which includes it.

/// An xfail that failed as its status says.
constexpr bool failed_as_expected(const WalkResult& result) {
    return result.outcome == Outcome::passed && result.expected_to_fail;
}

/// Simulated seconds.
double seconds_of(const WalkResult& result);

/// What is wrong with a case besides its failures and diagnostics, for instance that it was interrupted.
/// Empty if those say everything.
std::string verdict_in_words(const WalkResult& result);

/// "2 expectations not evaluated"; empty if all were.
std::string not_evaluated_in_words(std::size_t not_evaluated);

/// `file:line:col: error CODE: message`.
std::string headline_of(const Failure& failure);

/// One line: when, where and near what; empty if nothing is known.
std::string place_of(const FailureScene& scene);

/// The counts of a run.
struct Tally {
    std::size_t passed = 0;
    std::size_t failed = 0;
    std::size_t skipped = 0;
    std::size_t expected_failures = 0;  ///< among the passed
    std::size_t bad_input = 0;
    std::size_t broken = 0;
    std::size_t interrupted = 0;
    std::size_t not_evaluated = 0;  ///< expectations about images where none are drawn
    double seconds = 0.0;           ///< simulated
    double distance = 0.0;          ///< metres

    void add(const WalkResult& result);
};

/// "12 passed (2 by failing as expected), 1 failed: 135.2 simulated seconds, 180.4 m"
std::string summary_of(const Tally& tally);

}  // namespace campuswalk::engine

#pragma once

#include <vector>

#include "engine/report/walk_result.h"
#include "engine/script/walk.h"
#include "engine/simulation/run_walk.h"

namespace campuswalk::engine {

struct EvaluatedWalk {
    Outcome outcome = Outcome::passed;
    std::vector<Failure> failures;  ///< the walk's own and, where it should have failed otherwise, "xfail"
};

/// What to think of a walk that has been run: `failures` are all there are of it, also those that observers
/// found. One with the status xfail passes if it failed with just the codes that were named, in any order
/// and number, or with any if none was; otherwise it fails, and says so at the status.
EvaluatedWalk outcome_of_evaluators(std::vector<Failure> failures, const WalkStatus& status);

}  // namespace campuswalk::engine

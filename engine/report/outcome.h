#pragma once

#include <vector>

#include "engine/report/walk_result.h"
#include "engine/script/walk.h"
#include "engine/simulation/run_walk.h"

namespace campuswalk::engine {

struct EvaluatedWalk {
    Outcome outcome = Outcome::passed;
    std::vector<Failure> failures;  ///< the walk's own and, if it should have failed differently, kXfailCode
};

/// The verdict on a walk that has been run. `failures` are all of them, including those that observers found.
/// A walk with the status xfail passes if it failed with exactly the codes that its status lists, in any
/// order, or with any code if it lists none; otherwise, and if something that its verdict needs is lacking
/// (is_lack()), it fails with a failure at its status. How often each code is listed counts only if
/// `each_counts`: else one that is expected may hide another of the same code.
EvaluatedWalk outcome_of_failures(std::vector<Failure> failures, const WalkStatus& status,
                                  bool each_counts = false);

}  // namespace campuswalk::engine

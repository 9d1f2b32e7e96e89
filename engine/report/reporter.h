#pragma once

#include "engine/report/result_sequence.h"
#include "engine/report/run_plan.h"
#include "engine/report/walk_result.h"

namespace campuswalk::engine {

/// Reports a run as it progresses. Results come in the plan's order for any number of workers, so that a
/// report's bytes don't depend on it. A failure to write is thrown as std::runtime_error.
class Reporter {
public:
    virtual ~Reporter() = default;
    virtual void begin(const RunPlan& plan) { static_cast<void>(plan); }
    virtual void result(const WalkResult& result) = 0;
    /// Once, with the results that it got one by one; everything must be written when this returns.
    virtual void end(const ResultSequence& results) { static_cast<void>(results); }
};

}  // namespace campuswalk::engine

#pragma once

#include <functional>
#include <utility>

#include "engine/report/run_plan.h"
#include "engine/report/walk_result.h"

namespace campuswalk::engine {

/// The results of a whole run in the plan's order, as often as they are needed: from memory, or from the
/// files that they are in, so that a run of a million walks needs no more memory than one of a hundred.
class ResultSequence {
public:
    using Visit = std::function<void(const WalkResult& result)>;

    /// Those of a report, which must live as long as this.
    ResultSequence(const RunReport& report)  // NOLINT(google-explicit-constructor): it is one
        : for_each_([&report](const Visit& visit) {
              for (const WalkResult& result : report.results) {
                  visit(result);
              }
          }) {}
    explicit ResultSequence(std::function<void(const Visit& visit)> for_each)
        : for_each_(std::move(for_each)) {}

    void for_each(const Visit& visit) const { for_each_(visit); }

private:
    std::function<void(const Visit& visit)> for_each_;
};

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

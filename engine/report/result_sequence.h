#pragma once

#include <functional>
#include <utility>

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

}  // namespace campuswalk::engine

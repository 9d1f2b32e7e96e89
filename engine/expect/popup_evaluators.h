#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/expect/finding.h"
#include "engine/record/tick_record.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

// Judges of which information windows open; see event_evaluators.h.

class PopupEvaluator {
public:
    explicit PopupEvaluator(const ExpectPopup& expected) : expected_(&expected) {}
    void see(const TickRecord& record, const StateSnapshot& now);
    Finding finding(bool ended) const;

private:
    const ExpectPopup* expected_;
    int times_ = 0;
    std::string other_;  ///< the last of the building that said something else, as it would be told
    std::optional<StateSnapshot> when_;
};

class VisitsEvaluator {
public:
    VisitsEvaluator(const ExpectVisits& expected, const scene::Campus& campus);
    void see(const TickRecord& record, const StateSnapshot& now);
    Finding finding(bool ended) const;

private:
    const ExpectVisits* expected_;
    std::vector<std::string> mode_;  ///< in the campus' order
    std::set<std::string> visited_;  ///< of those
};

inline PopupEvaluator evaluator_of(const ExpectPopup& expected, const EvaluatorContext&) {
    return PopupEvaluator(expected);
}
inline VisitsEvaluator evaluator_of(const ExpectVisits& expected, const EvaluatorContext& context) {
    return VisitsEvaluator(expected, context.campus);
}

}  // namespace campuswalk::engine

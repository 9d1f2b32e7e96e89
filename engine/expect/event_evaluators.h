#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/expect/finding.h"
#include "engine/record/tick_record.h"

namespace campuswalk::engine {

// Judges of what events come. A judge sees every frame, with the moment at its end, and says at any time what
// it has found so far; `ended` tells it that nothing more will come. A copy goes on by itself. The
// expectation must outlive it.

class SequenceEvaluator {
public:
    explicit SequenceEvaluator(const ExpectSequence& expected)
        : expected_(&expected), early_(expected.events.size()) {}
    void see(const TickRecord& record, const StateSnapshot& now);
    Finding finding(bool ended) const;

private:
    const ExpectSequence* expected_;
    std::size_t met_ = 0;                ///< how many of the events have come
    std::string last_event_;             ///< of those, as it would be told
    std::optional<StateSnapshot> last_;  ///< when that came
    std::vector<std::string> early_;     ///< for each, the last event like it that came before its turn
};

class NeverEvaluator {
public:
    explicit NeverEvaluator(const ExpectNever& expected) : expected_(&expected) {}
    void see(const TickRecord& record, const StateSnapshot& now);
    Finding finding(bool ended) const;

private:
    const ExpectNever* expected_;
    int times_ = 0;
    std::string first_event_;
    std::optional<StateSnapshot> first_;
};

class CountEvaluator {
public:
    explicit CountEvaluator(const ExpectCount& expected) : expected_(&expected) {}
    void see(const TickRecord& record, const StateSnapshot& now);
    Finding finding(bool ended) const;

private:
    const ExpectCount* expected_;
    int times_ = 0;
    std::optional<StateSnapshot> too_many_;
};

class WithinEvaluator {
public:
    explicit WithinEvaluator(const ExpectWithin& expected) : expected_(&expected) {}
    void see(const TickRecord& record, const StateSnapshot& now);
    Finding finding(bool ended) const;

private:
    struct Wait {
        std::string event;  ///< as it would be told
        double since = 0.0;
    };
    bool late(const Wait& wait, double time) const;
    std::string told_miss(const Wait& wait) const;

    const ExpectWithin* expected_;
    int times_ = 0;            ///< how often `after` has come
    std::vector<Wait> waits_;  ///< those that nothing has followed yet
    std::optional<Wait> miss_;
    std::optional<StateSnapshot> missed_;
    std::string too_late_;  ///< what came after the miss, as it would be told
};

inline SequenceEvaluator evaluator_of(const ExpectSequence& expected, const EvaluatorContext&) {
    return SequenceEvaluator(expected);
}
inline NeverEvaluator evaluator_of(const ExpectNever& expected, const EvaluatorContext&) {
    return NeverEvaluator(expected);
}
inline CountEvaluator evaluator_of(const ExpectCount& expected, const EvaluatorContext&) {
    return CountEvaluator(expected);
}
inline WithinEvaluator evaluator_of(const ExpectWithin& expected, const EvaluatorContext&) {
    return WithinEvaluator(expected);
}

}  // namespace campuswalk::engine

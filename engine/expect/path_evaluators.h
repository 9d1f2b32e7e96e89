#pragma once

#include <optional>
#include <string>

#include "engine/expect/finding.h"
#include "engine/record/tick_record.h"

namespace campuswalk::engine {

// Judges of where the avatar went; see event_evaluators.h.

class ReachesEvaluator {
public:
    explicit ReachesEvaluator(const ExpectReaches& expected) : expected_(&expected) {}
    void see(const TickRecord& record, const StateSnapshot& now);
    Finding finding(bool ended) const;

private:
    const ExpectReaches* expected_;
    double nearest_ = 1e300;  ///< metres
    StateSnapshot when_;
};

class NearEvaluator {
public:
    explicit NearEvaluator(const ExpectNear& expected) : expected_(&expected) {}
    void see(const TickRecord& record, const StateSnapshot& now);
    Finding finding(bool ended) const;

private:
    struct Place {
        double distance = 0.0;  ///< metres, from the target
        std::string when;       ///< as it would be told
        StateSnapshot moment;
    };
    std::string told_place(const Place& place) const;

    const ExpectNear* expected_;
    std::optional<Place> last_;   ///< the end of the last tick, or the last event's
    std::optional<Place> first_;  ///< too far away: the first event's
};

class DurationEvaluator {
public:
    explicit DurationEvaluator(const ExpectDuration& expected) : expected_(&expected) {}
    void see(const TickRecord& record, const StateSnapshot& /*now*/) { time_ = record.time; }
    Finding finding(bool ended) const;

private:
    const ExpectDuration* expected_;
    double time_ = 0.0;
};

class DistanceEvaluator {
public:
    explicit DistanceEvaluator(const ExpectDistance& expected) : expected_(&expected) {}
    void see(const TickRecord& record, const StateSnapshot& /*now*/) { distance_ = record.distance; }
    Finding finding(bool ended) const;

private:
    const ExpectDistance* expected_;
    double distance_ = 0.0;
};

inline ReachesEvaluator evaluator_of(const ExpectReaches& expected, const EvaluatorContext&) {
    return ReachesEvaluator(expected);
}
inline NearEvaluator evaluator_of(const ExpectNear& expected, const EvaluatorContext&) {
    return NearEvaluator(expected);
}
inline DurationEvaluator evaluator_of(const ExpectDuration& expected, const EvaluatorContext&) {
    return DurationEvaluator(expected);
}
inline DistanceEvaluator evaluator_of(const ExpectDistance& expected, const EvaluatorContext&) {
    return DistanceEvaluator(expected);
}

}  // namespace campuswalk::engine

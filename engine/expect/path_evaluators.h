#pragma once

#include <optional>
#include <string>

#include "engine/events/decimals.h"
#include "engine/expect/finding.h"
#include "engine/script/event_pattern.h"

namespace campuswalk::engine {

// Evaluators of expectations about where the avatar went.

inline double distance_between(const Target& target, const Eigen::Vector3d& position) {
    Eigen::Vector3d difference = target.point - position;
    if (!target.has_height) {
        difference.y() = 0.0;
    }
    return difference.norm();
}

template <>
class EvaluatorOf<ExpectReaches> {
public:
    EvaluatorOf(const ExpectReaches& expected, const EvaluatorContext&) : expected_(&expected) {}

    void on_tick(const TickRecord& record, const StateSnapshot& now) {
        const double distance = distance_between(expected_->target, record.avatar.position);
        if (distance < nearest_) {
            nearest_ = distance;
            when_ = now;
        }
    }

    static PossibleVerdicts possible(const ExpectReaches& expected, const WalkBounds& bounds) {
        return {.holds = expected.within >= bounds.distance(expected.target).least,
                .fails = expected.within < bounds.distance_at_start(expected.target).most};
    }

    Finding finding(bool /*ended*/) const {
        const bool reached = nearest_ <= expected_->within;
        const std::string closest =
            "the avatar came within " + in_metres(nearest_) + " " + at_time(when_.time);
        return {.holds = reached,
                .mark = expected_->mark,
                .message =
                    expected_->target.label + (reached ? " was reached: " : " was not reached: ") + closest,
                .when = when_,
                .can_change = !reached,
                .expected = reached ? "" : in_metres(expected_->within)};
    }

private:
    const ExpectReaches* expected_;
    double nearest_ = 1e300;  ///< metres
    StateSnapshot when_;
};

template <>
class EvaluatorOf<ExpectNear> {
public:
    EvaluatorOf(const ExpectNear& expected, const EvaluatorContext&) : expected_(&expected) {}

    void on_tick(const TickRecord& record, const StateSnapshot& now) {
        const Eigen::Vector3d& end = record.avatar.position;
        if (!expected_->at) {
            last_ = Approach{distance_between(expected_->target, end), at_time(record.time), now};
            return;
        }
        for (const Event& event : record.events) {
            if (!matches(*expected_->at, event)) {
                continue;
            }
            // Contacts have a position within the tick; other events are about its end.
            const auto* position = find_field<Eigen::Vector3d>(event, "pos");
            last_ = Approach{distance_between(expected_->target, position != nullptr ? *position : end),
                             "at " + describe(event, record.time), now};
            if (last_->distance > expected_->within && !first_miss_) {
                first_miss_ = last_;
            }
        }
    }

    static PossibleVerdicts possible(const ExpectNear& expected, const WalkBounds& bounds) {
        const bool at_start = expected.at && bounds.is_only(*expected.at, EventKind::walk_start);
        const Interval distance =
            at_start ? bounds.distance_at_start(expected.target) : bounds.distance(expected.target);
        const bool comes = !expected.at || bounds.times(*expected.at).least > 0.0;
        return {.holds = expected.within >= distance.least &&
                         (!expected.at || bounds.times(*expected.at).most > 0.0),
                .fails = !comes || expected.within < distance.most};
    }

    Finding finding(bool /*ended*/) const {
        const std::string& target = expected_->target.label;
        if (!last_) {
            const EventPattern at = expected_->at ? *expected_->at : EventPattern();
            return {false, at.mark, "'" + to_string(at) + "' never occurred, so nothing was near " + target,
                    std::nullopt, true};
        }
        const Approach& decisive = first_miss_ ? *first_miss_ : *last_;
        const bool near = decisive.distance <= expected_->within;
        return {.holds = near,
                .mark = expected_->mark,
                .message = "the avatar was " + in_metres(decisive.distance) + " from " + target + " " +
                           decisive.when,
                .when = decisive.state,
                .can_change = !first_miss_,
                .expected = near ? "" : "within " + in_metres(expected_->within)};
    }

private:
    struct Approach {
        double distance = 0.0;  ///< metres, from the target
        std::string when;       ///< in words
        StateSnapshot state;
    };

    const ExpectNear* expected_;
    std::optional<Approach> last_;        ///< at the end of the last tick, or at the last event
    std::optional<Approach> first_miss_;  ///< at the first event that was too far away
};

template <>
class EvaluatorOf<ExpectDuration> {
public:
    EvaluatorOf(const ExpectDuration& expected, const EvaluatorContext&) : expected_(&expected) {}

    void on_tick(const TickRecord& record, const StateSnapshot& /*now*/) { time_ = record.time; }

    static PossibleVerdicts possible(const ExpectDuration& expected, const WalkBounds& bounds) {
        return possible_verdicts(expected.seconds, bounds.seconds());
    }

    Finding finding(bool ended) const {
        const std::string limit = violated_limit(expected_->seconds, time_, " s");
        return {.holds = limit.empty(),
                .mark = expected_->mark,
                .message = (ended ? "the walk took " : "the walk had taken ") + fixed(time_, 3) + " s",
                .when = std::nullopt,
                .can_change = can_still_change(expected_->seconds, time_),
                .expected = limit};
    }

private:
    const ExpectDuration* expected_;
    double time_ = 0.0;
};

template <>
class EvaluatorOf<ExpectDistance> {
public:
    EvaluatorOf(const ExpectDistance& expected, const EvaluatorContext&) : expected_(&expected) {}

    void on_tick(const TickRecord& record, const StateSnapshot& /*now*/) { distance_ = record.distance; }

    static PossibleVerdicts possible(const ExpectDistance& expected, const WalkBounds& bounds) {
        return possible_verdicts(expected.metres, {0.0, bounds.metres()});
    }

    Finding finding(bool ended) const {
        const std::string limit = violated_limit(expected_->metres, distance_, " m");
        return {.holds = limit.empty(),
                .mark = expected_->mark,
                .message = (ended ? "the avatar went " : "the avatar had gone ") + in_metres(distance_),
                .when = std::nullopt,
                .can_change = can_still_change(expected_->metres, distance_),
                .expected = limit};
    }

private:
    const ExpectDistance* expected_;
    double distance_ = 0.0;
};

}  // namespace campuswalk::engine

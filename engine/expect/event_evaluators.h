#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/events/decimals.h"
#include "engine/expect/finding.h"
#include "engine/script/event_pattern.h"

namespace campuswalk::engine {

// Evaluators of expectations about which events come.

template <>
class EvaluatorOf<ExpectSequence> {
public:
    EvaluatorOf(const ExpectSequence& expected, const EvaluatorContext&)
        : expected_(&expected), early_(expected.events.size()) {}

    void on_tick(const TickRecord& record, const StateSnapshot& now) {
        const std::vector<EventPattern>& events = expected_->events;
        for (const Event& event : record.events) {
            if (count_ < events.size() && matches(events[count_], event)) {
                last_event_ = describe(event, record.time);
                last_ = now;
                ++count_;
                continue;
            }
            for (std::size_t i = count_; i < events.size(); ++i) {
                if (matches(events[i], event)) {
                    early_[i] = describe(event, record.time);
                }
            }
        }
    }

    static PossibleVerdicts possible(const ExpectSequence& expected, const WalkBounds& bounds) {
        // Nothing comes after walk.end, and little after a fall.
        const std::vector<EventPattern>& events = expected.events;
        PossibleVerdicts possible{.holds = bounds.can_come(events), .fails = !bounds.are_certain(events)};
        for (std::size_t i = 0; i + 1 < events.size(); ++i) {
            const bool too_early = bounds.is_only(events[i], EventKind::walk_end);
            const bool too_low =
                bounds.is_only(events[i], EventKind::avatar_fell) && !bounds.can_follow_fall(events[i + 1]);
            possible.holds = possible.holds && !too_early && !too_low;
        }
        return possible;
    }

    Finding finding(bool /*ended*/) const {
        if (count_ == expected_->events.size()) {
            return {true, expected_->mark, "all occurred in this order, the last " + last_event_, last_};
        }
        const EventPattern& missing = expected_->events[count_];
        std::string message = "'" + to_string(missing) + "' never occurred";
        if (!last_event_.empty()) {
            message += " after " + last_event_;
        }
        if (!early_[count_].empty()) {
            message += ", only before: " + early_[count_];
        }
        return {.mark = missing.mark,
                .message = std::move(message),
                .when = std::nullopt,
                .can_change = true,
                .object = missing.object};
    }

private:
    const ExpectSequence* expected_;
    std::size_t count_ = 0;              ///< how many of the events have come
    std::string last_event_;             ///< of those, in words
    std::optional<StateSnapshot> last_;  ///< when that came
    std::vector<std::string> early_;     ///< for each, the last matching event that came before its turn
};

template <>
class EvaluatorOf<ExpectNever> {
public:
    EvaluatorOf(const ExpectNever& expected, const EvaluatorContext&) : expected_(&expected) {}

    void on_tick(const TickRecord& record, const StateSnapshot& now) {
        for (const Event& event : record.events) {
            if (matches(expected_->event, event) && ++times_ == 1) {
                first_event_ = describe(event, record.time);
                first_object_ = event.object;
                first_ = now;
            }
        }
    }

    static PossibleVerdicts possible(const ExpectNever& expected, const WalkBounds& bounds) {
        const Interval times = bounds.times(expected.event);
        return {.holds = times.least == 0.0, .fails = times.most > 0.0};
    }

    Finding finding(bool /*ended*/) const {
        const std::string event = "'" + to_string(expected_->event) + "'";
        if (times_ == 0) {
            return {true, expected_->event.mark, event + " never occurred", std::nullopt, true};
        }
        return {.mark = expected_->event.mark,
                .message = event + " occurred " + times_in_words(times_) + ", first " + first_event_,
                .when = first_,
                .object = first_object_};
    }

private:
    const ExpectNever* expected_;
    int times_ = 0;
    std::string first_event_;
    std::string first_object_;
    std::optional<StateSnapshot> first_;
};

template <>
class EvaluatorOf<ExpectCount> {
public:
    EvaluatorOf(const ExpectCount& expected, const EvaluatorContext&) : expected_(&expected) {}

    void on_tick(const TickRecord& record, const StateSnapshot& now) {
        const Limits<int>& limits = expected_->times;
        for (const Event& event : record.events) {
            times_ += matches(expected_->event, event) ? 1 : 0;
        }
        const bool too_many =
            (limits.equals && times_ > *limits.equals) || (limits.at_most && times_ > *limits.at_most);
        if (too_many && !too_many_) {
            too_many_ = now;
        }
    }

    static PossibleVerdicts possible(const ExpectCount& expected, const WalkBounds& bounds) {
        return possible_verdicts(expected.times, bounds.times(expected.event));
    }

    Finding finding(bool /*ended*/) const {
        const std::string limit = violated_limit(expected_->times, times_);
        return {.holds = limit.empty(),
                .mark = expected_->mark,
                .message = "'" + to_string(expected_->event) + "' occurred " + times_in_words(times_),
                .when = too_many_,
                .can_change = can_still_change(expected_->times, times_),
                .expected = limit,
                .object = expected_->event.object};
    }

private:
    const ExpectCount* expected_;
    int times_ = 0;
    std::optional<StateSnapshot> too_many_;
};

template <>
class EvaluatorOf<ExpectWithin> {
public:
    EvaluatorOf(const ExpectWithin& expected, const EvaluatorContext&) : expected_(&expected) {}

    void on_tick(const TickRecord& record, const StateSnapshot& now) {
        constexpr double kRounding = 1e-9;  // seconds
        if (!miss_ && !waits_.empty() &&
            record.time - waits_.front().since > expected_->seconds + kRounding) {
            miss_ = waits_.front();
            missed_ = now;
        }
        for (const Event& event : record.events) {
            if (matches(expected_->event, event)) {
                if (miss_ && too_late_.empty()) {
                    too_late_ = describe(event, record.time);
                }
                waits_.clear();
            }
            if (matches(expected_->after, event)) {
                ++times_;
                waits_.push_back({describe(event, record.time), record.time});
            }
        }
    }

    static PossibleVerdicts possible(const ExpectWithin& expected, const WalkBounds& bounds) {
        const bool long_enough =
            bounds.times(expected.after).least > 0.0 && expected.seconds >= bounds.seconds().most;
        // In the middle of a walk the event may still come; at the end walk.end is the last that can.
        const bool comes = bounds.in_step() || (bounds.is_certain(expected.event, EventKind::walk_end) &&
                                                bounds.is_only(expected.after, EventKind::walk_start));
        // Nothing follows walk.end, and walk.start follows nothing.
        const bool can_follow = !bounds.is_only(expected.event, EventKind::walk_start) &&
                                !bounds.is_only(expected.after, EventKind::walk_end) &&
                                !bounds.is_certain(expected.after, EventKind::walk_end);
        return {.holds = bounds.times(expected.after).most > 0.0 && can_follow,
                .fails = !(long_enough && comes && can_follow)};
    }

    Finding finding(bool ended) const {
        if (miss_) {
            return {false, expected_->mark, describe_miss(*miss_), missed_};
        }
        if (times_ == 0) {
            return {false, expected_->after.mark,
                    "'" + to_string(expected_->after) + "' never occurred, so nothing could follow it",
                    std::nullopt, true};
        }
        if (ended && !waits_.empty()) {
            return {false, expected_->mark, describe_miss(waits_.front()) + ": the walk was over by then",
                    std::nullopt, true};
        }
        return {true, expected_->mark,
                "'" + to_string(expected_->event) + "' occurred within " + fixed(expected_->seconds, 3) +
                    " s after '" + to_string(expected_->after) + "', which occurred " +
                    times_in_words(times_),
                std::nullopt, true};
    }

private:
    struct Wait {
        std::string event;  ///< in words
        double since = 0.0;
    };

    std::string describe_miss(const Wait& wait) const {
        return "'" + to_string(expected_->event) + "' did not occur within " + fixed(expected_->seconds, 3) +
               " s after " + wait.event + (too_late_.empty() ? "" : ", only as " + too_late_);
    }

    const ExpectWithin* expected_;
    int times_ = 0;            ///< how many times `after` has occurred
    std::vector<Wait> waits_;  ///< those that `event` hasn't followed yet
    std::optional<Wait> miss_;
    std::optional<StateSnapshot> missed_;
    std::string too_late_;  ///< what came after the miss, in words
};

}  // namespace campuswalk::engine

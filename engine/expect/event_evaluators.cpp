#include "engine/expect/event_evaluators.h"

#include <utility>

#include "engine/events/decimals.h"
#include "engine/script/event_pattern.h"

namespace campuswalk::engine {

// ---- sequence -------------------------------------------------------------------------------------------

void SequenceEvaluator::see(const TickRecord& record, const StateSnapshot& now) {
    const std::vector<EventPattern>& events = expected_->events;
    for (const Event& event : record.events) {
        if (met_ < events.size() && matches(events[met_], event)) {
            last_event_ = told(event, record.time);
            last_ = now;
            ++met_;
            continue;
        }
        for (std::size_t i = met_; i < events.size(); ++i) {
            if (matches(events[i], event)) {
                early_[i] = told(event, record.time);
            }
        }
    }
}

Finding SequenceEvaluator::finding(bool /*ended*/) const {
    if (met_ == expected_->events.size()) {
        return {true, expected_->mark, "all came in this order, the last " + last_event_, last_};
    }
    const EventPattern& missing = expected_->events[met_];
    std::string message = "'" + told(missing) + "' never came";
    if (!last_event_.empty()) {
        message += " after " + last_event_;
    }
    if (!early_[met_].empty()) {
        message += ", only before: " + early_[met_];
    }
    return {false, missing.mark, std::move(message), std::nullopt, true};
}

// ---- never ----------------------------------------------------------------------------------------------

void NeverEvaluator::see(const TickRecord& record, const StateSnapshot& now) {
    for (const Event& event : record.events) {
        if (matches(expected_->event, event) && ++times_ == 1) {
            first_event_ = told(event, record.time);
            first_ = now;
        }
    }
}

Finding NeverEvaluator::finding(bool /*ended*/) const {
    const std::string event = "'" + told(expected_->event) + "'";
    if (times_ == 0) {
        return {true, expected_->event.mark, event + " never happened", std::nullopt, true};
    }
    return {false, expected_->event.mark,
            event + " happened " + told_times(times_) + ", first " + first_event_, first_};
}

// ---- count ----------------------------------------------------------------------------------------------

void CountEvaluator::see(const TickRecord& record, const StateSnapshot& now) {
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

Finding CountEvaluator::finding(bool /*ended*/) const {
    const std::string wanted = broken_limit(expected_->times, times_);
    return {wanted.empty(), expected_->mark,
            "'" + told(expected_->event) + "' happened " + told_times(times_) +
                (wanted.empty() ? "" : ", expected " + wanted),
            too_many_, still_open(expected_->times, times_)};
}

// ---- within ---------------------------------------------------------------------------------------------

bool WithinEvaluator::late(const Wait& wait, double time) const {
    constexpr double kRounding = 1e-9;  // seconds
    return time - wait.since > expected_->seconds + kRounding;
}

void WithinEvaluator::see(const TickRecord& record, const StateSnapshot& now) {
    if (!miss_ && !waits_.empty() && late(waits_.front(), record.time)) {
        miss_ = waits_.front();
        missed_ = now;
    }
    for (const Event& event : record.events) {
        if (matches(expected_->event, event)) {
            if (miss_ && too_late_.empty()) {
                too_late_ = told(event, record.time);
            }
            waits_.clear();
        }
        if (matches(expected_->after, event)) {
            ++times_;
            waits_.push_back({told(event, record.time), record.time});
        }
    }
}

std::string WithinEvaluator::told_miss(const Wait& wait) const {
    return "'" + told(expected_->event) + "' did not come within " + fixed(expected_->seconds, 3) +
           " s after " + wait.event + (too_late_.empty() ? "" : ", only as " + too_late_);
}

Finding WithinEvaluator::finding(bool ended) const {
    if (miss_) {
        return {false, expected_->mark, told_miss(*miss_), missed_};
    }
    if (times_ == 0) {
        return {false, expected_->after.mark,
                "'" + told(expected_->after) + "' never came, so nothing could follow it", std::nullopt,
                true};
    }
    if (ended && !waits_.empty()) {
        return {false, expected_->mark, told_miss(waits_.front()) + ": the walk was over by then",
                std::nullopt, true};
    }
    return {true, expected_->mark,
            "'" + told(expected_->event) + "' came within " + fixed(expected_->seconds, 3) + " s after '" +
                told(expected_->after) + "', which came " + told_times(times_),
            std::nullopt, true};
}

}  // namespace campuswalk::engine

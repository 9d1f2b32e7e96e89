#include "engine/expect/expectation_judge.h"

#include <utility>

#include "engine/decimals.h"

namespace campuswalk::engine {

namespace {

std::string told(const Event& event, double time) {
    return std::string(name_of(event.kind)) + " " + event.object + " at " + fixed(time, 3) + " s";
}

std::string times(int count) {
    return count == 1 ? "once" : std::to_string(count) + " times";
}

Judge judge_of(const ExpectSequence& expected) {
    return SequenceJudge(expected);
}
Judge judge_of(const ExpectNever& expected) {
    return NeverJudge(expected);
}
Judge judge_of(const ExpectCount& expected) {
    return CountJudge(expected);
}
Judge judge_of(const ExpectReaches& expected) {
    return ReachesJudge(expected);
}

}  // namespace

// ---- sequence -------------------------------------------------------------------------------------------

void SequenceJudge::see(const FrameRecord& record) {
    for (const Event& event : record.events) {
        if (met_ < expected_.events.size() && matches(expected_.events[met_], event)) {
            last_event_ = told(event, record.time);
            ++met_;
            continue;
        }
        for (std::size_t i = met_; i < expected_.events.size(); ++i) {
            if (matches(expected_.events[i], event)) {
                early_[i] = told(event, record.time);
            }
        }
    }
}

std::optional<Failure> SequenceJudge::verdict() const {
    if (met_ == expected_.events.size()) {
        return std::nullopt;
    }
    const EventPattern& missing = expected_.events[met_];
    std::string message = "'" + told(missing) + "' never came";
    if (!last_event_.empty()) {
        message += " after " + last_event_;
    }
    if (!early_[met_].empty()) {
        message += ", only before: " + early_[met_];
    }
    return Failure{missing.mark, "sequence", std::move(message)};
}

// ---- never ----------------------------------------------------------------------------------------------

void NeverJudge::see(const FrameRecord& record) {
    for (const Event& event : record.events) {
        if (matches(expected_.event, event) && ++times_ == 1) {
            first_event_ = told(event, record.time);
        }
    }
}

std::optional<Failure> NeverJudge::verdict() const {
    if (times_ == 0) {
        return std::nullopt;
    }
    return Failure{expected_.event.mark, "never",
                   "'" + told(expected_.event) + "' happened " + times(times_) + ", first " + first_event_};
}

// ---- count ----------------------------------------------------------------------------------------------

void CountJudge::see(const FrameRecord& record) {
    for (const Event& event : record.events) {
        times_ += matches(expected_.event, event) ? 1 : 0;
    }
}

std::optional<Failure> CountJudge::verdict() const {
    std::string wanted;
    if (expected_.equals && times_ != *expected_.equals) {
        wanted = "exactly " + std::to_string(*expected_.equals);
    } else if (expected_.at_least && times_ < *expected_.at_least) {
        wanted = "at least " + std::to_string(*expected_.at_least);
    } else if (expected_.at_most && times_ > *expected_.at_most) {
        wanted = "at most " + std::to_string(*expected_.at_most);
    } else {
        return std::nullopt;
    }
    return Failure{expected_.mark, "count",
                   "'" + told(expected_.event) + "' happened " + times(times_) + ", expected " + wanted};
}

// ---- reaches --------------------------------------------------------------------------------------------

void ReachesJudge::see(const FrameRecord& record) {
    Eigen::Vector3d way = expected_.target.point - record.avatar.position;
    if (!expected_.target.has_height) {
        way.y() = 0.0;
    }
    if (const double distance = way.norm(); distance < nearest_) {
        nearest_ = distance;
        nearest_time_ = record.time;
    }
}

std::optional<Failure> ReachesJudge::verdict() const {
    if (nearest_ <= expected_.within) {
        return std::nullopt;
    }
    return Failure{expected_.mark, "reaches",
                   expected_.target.label + " was not reached: the avatar came within " + fixed(nearest_, 3) +
                       " m at " + fixed(nearest_time_, 3) + " s, expected " + fixed(expected_.within, 3) +
                       " m"};
}

// ---- all of them ----------------------------------------------------------------------------------------

Jury::Jury(const Walk& walk) {
    for (const Expectation& expectation : walk.expectations) {
        judges_.push_back(std::visit([](const auto& expected) { return judge_of(expected); }, expectation));
    }
}

void Jury::see(const FrameRecord& record) {
    for (Judge& judge : judges_) {
        std::visit([&](auto& j) { j.see(record); }, judge);
    }
}

std::vector<Failure> Jury::verdicts() const {
    std::vector<Failure> failures;
    for (const Judge& judge : judges_) {
        if (auto failure = std::visit([](const auto& j) { return j.verdict(); }, judge)) {
            failures.push_back(std::move(*failure));
        }
    }
    return failures;
}

}  // namespace campuswalk::engine

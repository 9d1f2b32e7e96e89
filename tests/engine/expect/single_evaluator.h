#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/expect/evaluator.h"

namespace campuswalk::engine {

/// Evaluates one expectation over tick records that a test makes.
class SingleEvaluator {
public:
    /// An avatar with the default profile; the campus must outlive the evaluator.
    explicit SingleEvaluator(Expectation expected);
    SingleEvaluator(Expectation expected, const scene::Campus& campus);

    void on_tick(const TickRecord& record);

    /// At the walk's end.
    std::optional<Failure> failure() const { return evaluator_->failure(true, history_.now()); }
    /// During the walk: more events may follow.
    std::optional<Failure> failure_so_far() const { return evaluator_->failure(false, history_.now()); }

private:
    Expectation expected_;
    AvatarProfile avatar_;
    std::optional<Evaluator> evaluator_;
    StateHistory history_;
};

/// "KIND OBJECT" as an event with fields.
Event made_event(const std::string& words, std::vector<Field> fields = {});

/// Feeds tick records, a tenth of a second apart, to an evaluator, an expectation set or a state history.
class TickFeed {
public:
    template <typename Receiver>
    explicit TickFeed(Receiver& receiver)
        : on_tick_([&receiver](const TickRecord& record) { receiver.on_tick(record); }) {}

    TickFeed& tick(const std::vector<std::string>& event_lines,
                   const Eigen::Vector3d& position = Eigen::Vector3d::Zero());
    TickFeed& with(std::vector<Event> events, const Eigen::Vector3d& position = Eigen::Vector3d::Zero());
    /// For the ticks that follow.
    TickFeed& in_the_air(bool airborne);
    TickFeed& after_metres(double distance);

private:
    std::function<void(const TickRecord&)> on_tick_;
    Tick tick_ = 0;
    bool grounded_ = true;
    double distance_ = 0.0;
};

/// Expects a failure at this line with this code, whose message mentions all facts.
void expect_failure(const std::optional<Failure>& failure, int mark_line, const std::string& code,
                    const std::vector<std::string>& facts);

}  // namespace campuswalk::engine

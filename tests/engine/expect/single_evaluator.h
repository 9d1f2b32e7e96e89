#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/expect/expectation_set.h"

namespace campuswalk::engine {

/// Holds one expectation against frames made by hand.
class OneEvaluator {
public:
    /// An avatar with the default profile; the campus must outlive the judge.
    explicit OneEvaluator(Expectation expected);
    OneEvaluator(Expectation expected, const scene::Campus& campus);

    void see(const TickRecord& record);

    /// As at the walk's end.
    std::optional<Failure> failure() const { return evaluator_->failure(true, history_.now()); }
    /// As in a step: more may come.
    std::optional<Failure> failure_so_far() const { return evaluator_->failure(false, history_.now()); }

private:
    Expectation expected_;
    AvatarProfile avatar_;
    std::optional<Evaluator> evaluator_;
    StateHistory history_;
};

/// "KIND OBJECT" as an event with fields.
Event made_event(const std::string& words, std::vector<Field> fields = {});

/// Frames, a tenth of a second apart, for a judge or a expectation set.
class Frames {
public:
    template <typename Evaluator>
    explicit Frames(Evaluator& evaluator)
        : see_([&evaluator](const TickRecord& record) { evaluator.see(record); }) {}

    Frames& tick(const std::vector<std::string>& told_events,
                 const Eigen::Vector3d& position = Eigen::Vector3d::Zero());
    Frames& with(std::vector<Event> events, const Eigen::Vector3d& position = Eigen::Vector3d::Zero());
    /// For the frames that follow.
    Frames& in_the_air(bool airborne);
    Frames& after_metres(double distance);

private:
    std::function<void(const TickRecord&)> see_;
    Tick tick_ = 0;
    bool grounded_ = true;
    double distance_ = 0.0;
};

/// There is one, with all of these.
void expect_failure(const std::optional<Failure>& failure, int mark_line, const std::string& code,
                    const std::string& message);

}  // namespace campuswalk::engine

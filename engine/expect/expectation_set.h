#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "engine/expect/body_evaluators.h"
#include "engine/expect/event_evaluators.h"
#include "engine/expect/failure.h"
#include "engine/expect/path_evaluators.h"
#include "engine/expect/popup_evaluators.h"
#include "engine/expect/route_evaluators.h"

namespace campuswalk::engine {

/// The evaluator of each expectation, in the same order; one without doesn't compile.
template <typename... Expected>
std::variant<EvaluatorOf<Expected>...> each_evaluator(const std::variant<Expected...>&);
using PlainEvaluator = decltype(each_evaluator(std::declval<PlainExpectation>()));

/// Evaluates one expectation over a walk's tick records.
class Evaluator {
public:
    /// What it refers to must outlive it. None for those that are evaluated elsewhere: logs and images.
    static std::optional<Evaluator> of(const Expectation& expectation, const scene::Campus& campus,
                                       const AvatarProfile& avatar);

    void on_tick(const TickRecord& record, const StateSnapshot& now);

    /// Why the expectation doesn't hold for what has been seen, if it doesn't; if it wasn't decided earlier,
    /// it is decided `now`.
    std::optional<Failure> failure(bool ended, const StateSnapshot& now) const;

    /// The part of the expectation that doesn't hold at the walk's end, if it might have held had the walk
    /// gone on.
    std::optional<SourceMark> undecided() const;

private:
    Finding finding(bool ended) const;

    Evaluator(PlainEvaluator evaluator, const scene::Campus& campus, const AvatarProfile& avatar)
        : evaluator_(std::move(evaluator)), campus_(&campus), avatar_(&avatar) {}

    PlainEvaluator evaluator_;
    std::string_view name_;
    bool negated_ = false;
    const scene::Campus* campus_;
    const AvatarProfile* avatar_;
};

/// All expectations of a walk: those of the whole walk and those of its steps. Each is evaluated over
/// everything since the walk's start.
class ExpectationSet {
public:
    /// Both must outlive it.
    ExpectationSet(const scene::Campus& campus, const Walk& walk);

    /// Every record but the closing one.
    void on_tick(const TickRecord& record);
    /// The walk's last record, in which all contacts end. It isn't part of the history, and no step is left
    /// to expect anything.
    void on_close(const TickRecord& record);

    /// The first of the step's expectations that doesn't hold, if any; `record` is the tick so far, which
    /// `on_tick` gets afterwards in full.
    std::optional<Failure> failure_at(const ExpectStep& step, const TickRecord& record) const;

    /// The failures of the whole walk's expectations, in the order of the file; empty if all hold.
    std::vector<Failure> verdicts() const;

    /// Of a walk that a step or its timeout stopped: the failures that the rest of the walk couldn't have
    /// changed, and the other expectations that don't hold, which are due to the stop.
    struct StoppedVerdicts {
        std::vector<Failure> failures;
        std::vector<SourceMark> undecided;
    };
    StoppedVerdicts verdicts_when_stopped() const;
    /// The state of the walk now, or at its end.
    const StateSnapshot& now() const { return history_.now(); }

private:
    /// The evaluators of one `expect`. The rounds of a `repeat` share them, by the step's mark.
    struct Group {
        SourceMark mark;
        std::vector<Evaluator> evaluators;
    };
    std::vector<Group>::const_iterator group_of(const ExpectStep& step) const;

    StateHistory history_;
    std::vector<Evaluator> of_walk_;
    std::vector<Group> of_steps_;
};

}  // namespace campuswalk::engine

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

namespace campuswalk::engine {

/// The evaluator of each expectation, in the same order; one without doesn't compile.
template <typename... Expected>
std::variant<EvaluatorOf<Expected>...> each_evaluator(const std::variant<Expected...>&);
using PlainEvaluator = decltype(each_evaluator(std::declval<PlainExpectation>()));

/// Holds one expectation against a walk's frames.
class Evaluator {
public:
    /// What it refers to must outlive it. None for those that are judged elsewhere: logs and images.
    static std::optional<Evaluator> of(const Expectation& expectation, const scene::Campus& campus,
                                       const AvatarProfile& avatar);

    void see(const TickRecord& record, const StateSnapshot& now);

    /// Why the expectation is not met by what has been seen, if it isn't; what wasn't decided before was
    /// decided `now`.
    std::optional<Failure> failure(bool ended, const StateSnapshot& now) const;

    /// What of the expectation isn't as expected at a walk's end, if it might have become so had the walk
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

/// All that is expected of a walk: for the whole of it, and in its steps. Each expectation is held against
/// everything since the walk's start.
class ExpectationSet {
public:
    /// Both must outlive it.
    ExpectationSet(const scene::Campus& campus, const Walk& walk);

    /// Every tick but the closing one.
    void see(const TickRecord& record);
    /// The walk's last record, in which all contacts end: it is not told among what came before.
    void see_closing(const TickRecord& record);

    /// What isn't as the step expects, if anything; `record` is the tick so far, which `see` will be shown in
    /// full afterwards.
    std::optional<Failure> failure_at(const ExpectStep& step, const TickRecord& record) const;

    /// Of what holds for the whole walk, in the order of the file; empty when everything was as expected.
    std::vector<Failure> verdicts() const;

    /// Of a walk that a step or its time-out stopped: what nothing that was still to come could have mended,
    /// and what else isn't as expected. The latter is the stop's fault.
    struct StoppedVerdicts {
        std::vector<Failure> failures;
        std::vector<SourceMark> undecided;
    };
    StoppedVerdicts verdicts_when_stopped() const;
    /// Where the walk is, or ended.
    const StateSnapshot& now() const { return history_.now(); }

private:
    /// The evaluators of one `expect`. Rounds of a `repeat` share theirs, by the step's mark.
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

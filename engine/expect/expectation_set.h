#pragma once

#include <cstddef>
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

/// An expectation that a walk which stopped early leaves undecided.
struct Undecided {
    SourceMark mark;            ///< of the part of it that decides
    bool holds_so_far = false;  ///< never of a step that the walk didn't get to
};

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

    /// At the walk's end, if the verdict might have been another had the walk gone on.
    std::optional<Undecided> undecided() const;
    /// The part of the expectation that decides so far.
    SourceMark mark() const { return finding(false).mark; }

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

    /// Evaluates a step that the walk has come to: the first of its expectations that doesn't hold, if any.
    /// `record` is the tick so far, which `on_tick` gets afterwards in full.
    std::optional<Failure> evaluate(const ExpectStep& step, const TickRecord& record);

    /// The failures of the whole walk's expectations, in the order of the file; empty if all hold.
    std::vector<Failure> verdicts() const;

    /// Of a walk that a step or its timeout stopped: the failures that the rest of the walk couldn't have
    /// changed, and the expectations that it might have decided otherwise, those of its steps last.
    struct StoppedVerdicts {
        std::vector<Failure> failures;
        std::vector<Undecided> undecided;
    };
    StoppedVerdicts verdicts_when_stopped() const;
    /// The state of the walk now, or at its end.
    const StateSnapshot& now() const { return history_.now(); }

private:
    /// The evaluators of one `expect`. The rounds of a `repeat` share them, by the step's mark.
    struct Group {
        SourceMark mark;
        std::vector<Evaluator> evaluators;
        std::size_t rounds = 0;  ///< how often the steps come to it, if nothing stops the walk
        std::size_t held = 0;    ///< how often it was evaluated and held
        std::optional<std::size_t> failed = std::nullopt;  ///< the evaluator that stopped the walk
    };
    std::vector<Group>::iterator group_of(const ExpectStep& step);

    StateHistory history_;
    std::vector<Evaluator> of_walk_;
    std::vector<Group> of_steps_;
};

}  // namespace campuswalk::engine

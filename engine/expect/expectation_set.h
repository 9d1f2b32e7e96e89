#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/expect/failure.h"
#include "engine/expect/state_snapshot.h"
#include "engine/record/tick_record.h"
#include "engine/script/walk.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

class Evaluator;  // its variant of all expectations is a lot to read

/// An expectation that a walk which stopped early leaves undecided.
struct Undecided {
    SourceMark mark;            ///< of the part of it that decides
    bool holds_so_far = false;  ///< never of a step that the walk didn't get to
};

/// All expectations of a walk: those of the whole walk and those of its steps. Each is evaluated over
/// everything since the walk's start.
class ExpectationSet {
public:
    /// Both must outlive it.
    ExpectationSet(const scene::Campus& campus, const Walk& walk);
    ~ExpectationSet();

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

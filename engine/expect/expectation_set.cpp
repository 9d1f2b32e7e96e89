#include "engine/expect/expectation_set.h"

#include <algorithm>
#include <utility>

#include "engine/expect/evaluator.h"

namespace campuswalk::engine {

namespace {

std::vector<Evaluator> evaluators_of(const std::vector<Expectation>& expectations,
                                     const scene::Campus& campus, const AvatarProfile& avatar) {
    std::vector<Evaluator> evaluators;
    for (const Expectation& expectation : expectations) {
        if (auto evaluator = Evaluator::of(expectation, campus, avatar)) {
            evaluators.push_back(std::move(*evaluator));
        }
    }
    return evaluators;
}

}  // namespace

ExpectationSet::ExpectationSet(const scene::Campus& campus, const Walk& walk)
    : of_walk_(evaluators_of(walk.expectations, campus, walk.avatar)) {
    for (const Step& step : walk.steps) {
        const auto* expect = std::get_if<ExpectStep>(&step);
        if (expect == nullptr) {
            continue;
        }
        if (group_of(*expect) == of_steps_.end()) {
            of_steps_.push_back({expect->mark, evaluators_of(expect->expectations, campus, walk.avatar)});
        }
        ++group_of(*expect)->rounds;
    }
}

ExpectationSet::~ExpectationSet() = default;

void ExpectationSet::on_tick(const TickRecord& record) {
    history_.on_tick(record);
    for (Evaluator& evaluator : of_walk_) {
        evaluator.on_tick(record, history_.now());
    }
    for (Group& group : of_steps_) {
        for (Evaluator& evaluator : group.evaluators) {
            evaluator.on_tick(record, history_.now());
        }
    }
}

void ExpectationSet::on_close(const TickRecord& record) {
    for (Evaluator& evaluator : of_walk_) {
        evaluator.on_tick(record, history_.now());
    }
}

std::vector<ExpectationSet::Group>::iterator ExpectationSet::group_of(const ExpectStep& step) {
    return std::ranges::find_if(of_steps_, [&](const Group& group) { return group.mark == step.mark; });
}

std::optional<Failure> ExpectationSet::evaluate(const ExpectStep& step, const TickRecord& record) {
    StateHistory so_far = history_;
    so_far.on_tick(record);
    Group& group = *group_of(step);
    for (std::size_t i = 0; i < group.evaluators.size(); ++i) {
        Evaluator evaluator = group.evaluators[i];
        evaluator.on_tick(record, so_far.now());
        if (auto failure = evaluator.failure(false, so_far.now())) {
            group.failed = i;
            return failure;
        }
    }
    ++group.held;
    return std::nullopt;
}

std::vector<Failure> ExpectationSet::verdicts() const {
    std::vector<Failure> failures;
    for (const Evaluator& evaluator : of_walk_) {
        if (auto failure = evaluator.failure(true, history_.now())) {
            failures.push_back(std::move(*failure));
        }
    }
    return failures;
}

ExpectationSet::StoppedVerdicts ExpectationSet::verdicts_when_stopped() const {
    StoppedVerdicts verdicts;
    for (const Evaluator& evaluator : of_walk_) {
        if (auto undecided = evaluator.undecided()) {
            verdicts.undecided.push_back(std::move(*undecided));
        } else if (auto failure = evaluator.failure(true, history_.now())) {
            verdicts.failures.push_back(std::move(*failure));
        }
    }
    for (const Group& group : of_steps_) {
        const std::size_t rounds_left = group.rounds - group.held - (group.failed ? 1 : 0);
        for (std::size_t i = 0; i < group.evaluators.size(); ++i) {
            if (i != group.failed && (rounds_left > 0 || (group.failed && i > *group.failed))) {
                verdicts.undecided.push_back({group.evaluators[i].mark(), false});
            }
        }
    }
    return verdicts;
}

}  // namespace campuswalk::engine

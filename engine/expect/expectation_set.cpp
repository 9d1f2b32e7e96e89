#include "engine/expect/expectation_set.h"

#include <string>
#include <utility>

#include "engine/expect/failure_scene.h"

namespace campuswalk::engine {

namespace {

/// What judges are made from.
struct EvaluationContext {
    const scene::Campus& campus;
    const AvatarProfile& avatar;

    PlainEvaluator evaluator(const ExpectSequence& expected) const { return SequenceEvaluator(expected); }
    PlainEvaluator evaluator(const ExpectNever& expected) const { return NeverEvaluator(expected); }
    PlainEvaluator evaluator(const ExpectCount& expected) const { return CountEvaluator(expected); }
    PlainEvaluator evaluator(const ExpectWithin& expected) const { return WithinEvaluator(expected); }
    PlainEvaluator evaluator(const ExpectPopup& expected) const { return PopupEvaluator(expected); }
    PlainEvaluator evaluator(const ExpectVisits& expected) const { return VisitsEvaluator(expected, campus); }
    PlainEvaluator evaluator(const ExpectReaches& expected) const { return ReachesEvaluator(expected); }
    PlainEvaluator evaluator(const ExpectNear& expected) const { return NearEvaluator(expected); }
    PlainEvaluator evaluator(const ExpectDuration& expected) const { return DurationEvaluator(expected); }
    PlainEvaluator evaluator(const ExpectDistance& expected) const { return DistanceEvaluator(expected); }
    PlainEvaluator evaluator(const ExpectNoPenetration& expected) const {
        return NoPenetrationEvaluator(expected, campus, avatar);
    }
    PlainEvaluator evaluator(const ExpectGrounded& expected) const { return GroundedEvaluator(expected); }
    PlainEvaluator evaluator(const ExpectBlockedBy& expected) const { return BlockedByEvaluator(expected); }
    PlainEvaluator evaluator(const ExpectStuck& expected) const { return StuckEvaluator(expected); }
    PlainEvaluator evaluator(const ExpectFell& expected) const { return FellEvaluator(expected); }
};

}  // namespace

std::optional<Evaluator> Evaluator::of(const Expectation& expectation, const scene::Campus& campus,
                                       const AvatarProfile& avatar) {
    const auto* negation = std::get_if<ExpectNot>(&expectation);
    const PlainExpectation* plain =
        negation != nullptr ? &negation->what : std::get_if<PlainExpectation>(&expectation);
    if (plain == nullptr) {
        return std::nullopt;
    }
    const EvaluationContext court{campus, avatar};
    Evaluator made(std::visit([&](const auto& expected) { return court.evaluator(expected); }, *plain),
                   campus, avatar);
    made.name_ = std::visit([](const auto& expected) { return std::string_view(expected.kName); }, *plain);
    made.negated_ = negation != nullptr;
    return made;
}

void Evaluator::see(const TickRecord& record, const StateSnapshot& now) {
    std::visit([&](auto& evaluator) { evaluator.see(record, now); }, evaluator_);
}

Finding Evaluator::finding(bool ended) const {
    return std::visit([&](const auto& evaluator) { return evaluator.finding(ended); }, evaluator_);
}

std::optional<SourceMark> Evaluator::undecided() const {
    const Finding found = finding(true);
    return found.met == negated_ && found.open ? std::optional(found.mark) : std::nullopt;
}

std::optional<Failure> Evaluator::failure(bool ended, const StateSnapshot& now) const {
    const Finding found = finding(ended);
    if (found.met != negated_) {
        return std::nullopt;
    }
    const std::string name(name_);
    return Failure{found.mark, negated_ ? "not-" + name : name,
                   negated_ ? "not expected, but " + found.told : found.told,
                   scene_of(found.when.value_or(now), *campus_, *avatar_)};
}

// ---- at the end -----------------------------------------------------------------------------------------

ExpectationSet::ExpectationSet(const scene::Campus& campus, const Walk& walk) {
    for (const Expectation& expectation : walk.expectations) {
        if (auto evaluator = Evaluator::of(expectation, campus, walk.avatar)) {
            evaluators_.push_back(std::move(*evaluator));
        }
    }
}

void ExpectationSet::see(const TickRecord& record) {
    history_.see(record);
    see_closing(record);
}

void ExpectationSet::see_closing(const TickRecord& record) {
    for (Evaluator& evaluator : evaluators_) {
        evaluator.see(record, history_.now());
    }
}

std::vector<Failure> ExpectationSet::verdicts() const {
    std::vector<Failure> failures;
    for (const Evaluator& evaluator : evaluators_) {
        if (auto failure = evaluator.failure(true, history_.now())) {
            failures.push_back(std::move(*failure));
        }
    }
    return failures;
}

ExpectationSet::StoppedVerdicts ExpectationSet::verdicts_when_stopped() const {
    StoppedVerdicts verdicts;
    for (const Evaluator& evaluator : evaluators_) {
        if (auto mark = evaluator.undecided()) {
            verdicts.undecided.push_back(std::move(*mark));
        } else if (auto failure = evaluator.failure(true, history_.now())) {
            verdicts.failures.push_back(std::move(*failure));
        }
    }
    return verdicts;
}

// ---- in steps -------------------------------------------------------------------------------------------

StepExpectations::StepExpectations(const scene::Campus& campus, const Walk& walk) {
    for (const Step& step : walk.steps) {
        const auto* expect = std::get_if<ExpectStep>(&step);
        if (expect == nullptr) {
            continue;
        }
        const auto [expectation_set, fresh] = step_expectations_.try_emplace(place_of(expect->mark));
        for (const Expectation& expectation : expect->expectations) {
            if (auto evaluator = fresh ? Evaluator::of(expectation, campus, walk.avatar) : std::nullopt) {
                expectation_set->second.push_back(std::move(*evaluator));
            }
        }
    }
}

void StepExpectations::see(const TickRecord& record) {
    if (step_expectations_.empty()) {
        return;
    }
    history_.see(record);
    for (auto& [place, evaluators] : step_expectations_) {
        for (Evaluator& evaluator : evaluators) {
            evaluator.see(record, history_.now());
        }
    }
}

std::optional<Failure> StepExpectations::failure(const ExpectStep& step, const TickRecord& record) const {
    StateHistory so_far = history_;
    so_far.see(record);
    for (const Evaluator& evaluator : step_expectations_.at(place_of(step.mark))) {
        Evaluator copy = evaluator;
        copy.see(record, so_far.now());
        if (auto failure = copy.failure(false, so_far.now())) {
            return failure;
        }
    }
    return std::nullopt;
}

}  // namespace campuswalk::engine

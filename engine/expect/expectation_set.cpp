#include "engine/expect/expectation_set.h"

#include <algorithm>
#include <string>
#include <utility>

#include "engine/expect/failure_scene.h"

namespace campuswalk::engine {

namespace {

/// Whether it fails for what kept the avatar from getting somewhere.
bool is_about_getting_there(std::string_view expectation) {
    return expectation == ExpectReaches::kName || expectation == ExpectNear::kName ||
           expectation == ExpectGrounded::kName;
}

}  // namespace

std::optional<Evaluator> Evaluator::of(const Expectation& expectation, const scene::Campus& campus,
                                       const AvatarProfile& avatar) {
    const PlainExpectation* plain = plain_part(expectation);
    if (plain == nullptr) {
        return std::nullopt;
    }
    Evaluator made(std::visit(
                       [&]<typename Expected>(const Expected& expected) {
                           return PlainEvaluator(EvaluatorOf<Expected>(expected, {campus, avatar}));
                       },
                       *plain),
                   campus, avatar);
    made.name_ = std::visit([](const auto& expected) { return expected.kName; }, *plain);
    made.negated_ = std::holds_alternative<ExpectNot>(expectation);
    return made;
}

void Evaluator::on_tick(const TickRecord& record, const StateSnapshot& now) {
    std::visit([&](auto& evaluator) { evaluator.on_tick(record, now); }, evaluator_);
}

Finding Evaluator::finding(bool ended) const {
    return std::visit([&](const auto& evaluator) { return evaluator.finding(ended); }, evaluator_);
}

std::optional<Undecided> Evaluator::undecided() const {
    Finding found = finding(true);
    return found.can_change ? std::optional(Undecided{std::move(found.mark), found.holds != negated_})
                            : std::nullopt;
}

std::optional<Failure> Evaluator::failure(bool ended, const StateSnapshot& now) const {
    const Finding found = finding(ended);
    std::optional<std::string> code = failure_code(found, name_, negated_);
    if (!code) {
        return std::nullopt;
    }
    const bool is_unwanted = negated_ && found.lack.empty();
    const StateSnapshot& when = found.when ? *found.when : now;
    Failure failure{found.mark, std::move(*code), (is_unwanted ? "not expected, but " : "") + found.message,
                    scene_of(when, *campus_, *avatar_), found.reason};
    if (!found.expected.empty()) {
        failure.actual = found.message;
        failure.expected = found.expected;
        failure.message += ", expected " + found.expected;
    }
    const auto& objects = campus_->objects;
    if (std::ranges::find(objects, found.object, &scene::CampusObject::id) != objects.end()) {
        failure.object = found.object;  // an event may be about the walk, or be a pattern
    }
    if (is_about_getting_there(name_) && !negated_) {
        // What stopped the avatar after its nearest approach also kept it from the target.
        add_obstacle(name_ == ExpectReaches::kName ? now : when, failure);
    }
    return failure;
}

// ---- the set --------------------------------------------------------------------------------------------

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

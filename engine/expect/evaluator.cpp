#include "engine/expect/evaluator.h"

#include <algorithm>
#include <string>

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

}  // namespace campuswalk::engine

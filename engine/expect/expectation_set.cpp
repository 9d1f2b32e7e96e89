#include "engine/expect/expectation_set.h"

#include <string>
#include <utility>

#include "engine/expect/failure_scene.h"

namespace campuswalk::engine {

namespace {

/// What judges are made from.
struct Court {
    const scene::Campus& campus;
    const AvatarProfile& avatar;

    PlainJudge judge(const ExpectSequence& expected) const { return SequenceJudge(expected); }
    PlainJudge judge(const ExpectNever& expected) const { return NeverJudge(expected); }
    PlainJudge judge(const ExpectCount& expected) const { return CountJudge(expected); }
    PlainJudge judge(const ExpectWithin& expected) const { return WithinJudge(expected); }
    PlainJudge judge(const ExpectPopup& expected) const { return PopupJudge(expected); }
    PlainJudge judge(const ExpectVisits& expected) const { return VisitsJudge(expected, campus); }
    PlainJudge judge(const ExpectReaches& expected) const { return ReachesJudge(expected); }
    PlainJudge judge(const ExpectNear& expected) const { return NearJudge(expected); }
    PlainJudge judge(const ExpectDuration& expected) const { return DurationJudge(expected); }
    PlainJudge judge(const ExpectDistance& expected) const { return DistanceJudge(expected); }
    PlainJudge judge(const ExpectNoPenetration& expected) const {
        return NoPenetrationJudge(expected, campus, avatar);
    }
    PlainJudge judge(const ExpectGrounded& expected) const { return GroundedJudge(expected); }
    PlainJudge judge(const ExpectBlockedBy& expected) const { return BlockedByJudge(expected); }
    PlainJudge judge(const ExpectStuck& expected) const { return StuckJudge(expected); }
    PlainJudge judge(const ExpectFell& expected) const { return FellJudge(expected); }
};

}  // namespace

std::optional<Judge> Judge::of(const Expectation& expectation, const scene::Campus& campus,
                               const AvatarProfile& avatar) {
    const auto* negation = std::get_if<ExpectNot>(&expectation);
    const PlainExpectation* plain =
        negation != nullptr ? &negation->what : std::get_if<PlainExpectation>(&expectation);
    if (plain == nullptr) {
        return std::nullopt;
    }
    const Court court{campus, avatar};
    Judge made(std::visit([&](const auto& expected) { return court.judge(expected); }, *plain), campus,
               avatar);
    made.name_ = std::visit([](const auto& expected) { return std::string_view(expected.kName); }, *plain);
    made.negated_ = negation != nullptr;
    return made;
}

void Judge::see(const FrameRecord& record, const Moment& now) {
    std::visit([&](auto& judge) { judge.see(record, now); }, judge_);
}

Finding Judge::finding(bool ended) const {
    return std::visit([&](const auto& judge) { return judge.finding(ended); }, judge_);
}

std::optional<SourceMark> Judge::undecided() const {
    const Finding found = finding(true);
    return found.met == negated_ && found.open ? std::optional(found.mark) : std::nullopt;
}

std::optional<Failure> Judge::failure(bool ended, const Moment& now) const {
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

Jury::Jury(const scene::Campus& campus, const Walk& walk) {
    for (const Expectation& expectation : walk.expectations) {
        if (auto judge = Judge::of(expectation, campus, walk.avatar)) {
            judges_.push_back(std::move(*judge));
        }
    }
}

void Jury::see(const FrameRecord& record) {
    chronicle_.see(record);
    see_closing(record);
}

void Jury::see_closing(const FrameRecord& record) {
    for (Judge& judge : judges_) {
        judge.see(record, chronicle_.now());
    }
}

std::vector<Failure> Jury::verdicts() const {
    std::vector<Failure> failures;
    for (const Judge& judge : judges_) {
        if (auto failure = judge.failure(true, chronicle_.now())) {
            failures.push_back(std::move(*failure));
        }
    }
    return failures;
}

Jury::StoppedVerdicts Jury::verdicts_when_stopped() const {
    StoppedVerdicts verdicts;
    for (const Judge& judge : judges_) {
        if (auto mark = judge.undecided()) {
            verdicts.undecided.push_back(std::move(*mark));
        } else if (auto failure = judge.failure(true, chronicle_.now())) {
            verdicts.failures.push_back(std::move(*failure));
        }
    }
    return verdicts;
}

// ---- in steps -------------------------------------------------------------------------------------------

StepJuries::StepJuries(const scene::Campus& campus, const Walk& walk) {
    for (const Step& step : walk.steps) {
        const auto* expect = std::get_if<ExpectStep>(&step);
        if (expect == nullptr) {
            continue;
        }
        const auto [jury, fresh] = juries_.try_emplace(place_of(expect->mark));
        for (const Expectation& expectation : expect->expectations) {
            if (auto judge = fresh ? Judge::of(expectation, campus, walk.avatar) : std::nullopt) {
                jury->second.push_back(std::move(*judge));
            }
        }
    }
}

void StepJuries::see(const FrameRecord& record) {
    if (juries_.empty()) {
        return;
    }
    chronicle_.see(record);
    for (auto& [place, judges] : juries_) {
        for (Judge& judge : judges) {
            judge.see(record, chronicle_.now());
        }
    }
}

std::optional<Failure> StepJuries::failure(const ExpectStep& step, const FrameRecord& record) const {
    Chronicle so_far = chronicle_;
    so_far.see(record);
    for (const Judge& judge : juries_.at(place_of(step.mark))) {
        Judge copy = judge;
        copy.see(record, so_far.now());
        if (auto failure = copy.failure(false, so_far.now())) {
            return failure;
        }
    }
    return std::nullopt;
}

}  // namespace campuswalk::engine

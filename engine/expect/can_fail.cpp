#include "engine/expect/can_fail.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>

#include "engine/expect/certain_timeout.h"
#include "engine/expect/evaluator.h"
#include "engine/expect/walk_bounds.h"

namespace campuswalk::engine {

namespace {

PossibleVerdicts possible(const PlainExpectation& expectation, const WalkBounds& bounds) {
    return std::visit(
        [&]<typename Expected>(const Expected& expected) {
            return EvaluatorOf<Expected>::possible(expected, bounds);
        },
        expectation);
}

std::string name_of(const PlainExpectation& expectation) {
    return std::string(std::visit([](const auto& expected) { return expected.kName; }, expectation));
}

const SourceMark& mark_of(const PlainExpectation& expectation) {
    return std::visit([](const auto& expected) -> const SourceMark& { return expected.mark; }, expectation);
}

/// Adds an expectation that can't fail, or can't but fail in a walk that is expected to.
class Finder {
public:
    Finder(const Walk& walk, const WalkBounds& bounds, std::vector<VacuousExpectation>& found)
        : walk_(walk), bounds_(bounds), found_(found) {}

    void operator()(const PlainExpectation& expected) const {
        add_if_vacuous(possible(expected, bounds_), mark_of(expected), name_of(expected));
    }
    void operator()(const ExpectNot& negation) const {
        const PossibleVerdicts denied = possible(negation.what, bounds_);
        add_if_vacuous({.holds = denied.fails, .fails = denied.holds}, negation.mark,
                       "not-" + name_of(negation.what));
    }
    void operator()(const ExpectLog& log) const {
        add_if_vacuous({.holds = true, .fails = log.golden}, log.mark, std::string(ExpectLog::kName));
    }
    /// How much images may differ is decided where the run's own tolerance is known.
    void operator()(const ExpectSnapshot&) const {}
    void operator()(const ExpectVisible& expected) const {
        const bool always = expected.min_pixels <= 0 && expected.min_ratio.value_or(0.0) <= 0.0;
        const bool never = expected.min_pixels > pixels_of(expected.snapshot);
        const PossibleVerdicts seen{.holds = !never, .fails = !always};
        add_if_vacuous(expected.negated ? PossibleVerdicts{.holds = seen.fails, .fails = seen.holds} : seen,
                       expected.mark, code_of(expected));
    }

private:
    std::int64_t pixels_of(const std::string& snapshot) const {
        for (const Step& step : walk_.steps) {
            const auto* taken = std::get_if<SnapshotStep>(&step);
            if (taken != nullptr && taken->name == snapshot) {
                return static_cast<std::int64_t>(taken->camera.width) * taken->camera.height;
            }
        }
        return 0;
    }

    void add_if_vacuous(const PossibleVerdicts& verdicts, const SourceMark& mark,
                        const std::string& name) const {
        const bool must_fail = walk_.status.kind == WalkStatus::Kind::xfail;
        if (!verdicts.fails || (must_fail && !verdicts.holds)) {
            found_.push_back({mark, name, verdicts.holds});
        }
    }

    const Walk& walk_;
    const WalkBounds& bounds_;
    std::vector<VacuousExpectation>& found_;
};

}  // namespace

std::vector<VacuousExpectation> vacuous_expectations(const scene::Campus& campus, const Walk& walk) {
    std::vector<VacuousExpectation> found;
    WalkBounds at_end(campus, walk);
    at_end.come_to(walk.steps.size() + 1);
    for (const Expectation& expectation : walk.expectations) {
        std::visit(Finder(walk, at_end, found), expectation);
    }
    WalkBounds so_far(campus, walk);
    std::set<SourceMark> seen;  // the rounds of a `repeat` share them
    for (std::size_t i = 0; i < walk.steps.size(); ++i) {
        const auto* expect = std::get_if<ExpectStep>(&walk.steps[i]);
        if (expect != nullptr && seen.insert(expect->mark).second) {
            so_far.come_to(i);
            for (const Expectation& expectation : expect->expectations) {
                std::visit(Finder(walk, so_far, found), expectation);
            }
        }
    }
    for (const CertainTimeout& certain : certain_timeouts(walk)) {
        if (std::ranges::find(walk.status.codes, certain.code) != walk.status.codes.end()) {
            found.push_back({certain.mark, certain.code, false});
        }
    }
    return found;
}

}  // namespace campuswalk::engine

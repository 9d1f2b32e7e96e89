#include "engine/expect/expectation_set.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/engine/expect/single_evaluator.h"
#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"

namespace campuswalk::engine {
namespace {

const SourceMark kWhole = {"a.walk.yaml", 7, 5};

// ---- at the end -----------------------------------------------------------------------------------------

TEST(ExpectationSet, ReportsFailuresInTheOrderOfTheFile) {
    Walk walk;
    walk.expectations = {expect_reaches({"far", {50, 0, 0}, false}, 0.5), ExpectLog{kWhole},
                         expect_never("popup.open"), expect_count("popup.open", 1),
                         expect_sequence({"popup.open b"})};
    const scene::Campus campus = empty_campus();
    ExpectationSet set(campus, walk);
    TickFeed(set).tick({"popup.open a"});
    const std::vector<Failure> failures = set.verdicts();
    ASSERT_EQ(failures.size(), 3U) << "logs are evaluated elsewhere";
    EXPECT_EQ(failures[0].code, "reaches");
    EXPECT_EQ(failures[1].code, "never");
    EXPECT_EQ(failures[2].code, "sequence");
}

TEST(ExpectationSet, HasNoFailuresWithoutExpectations) {
    const Walk walk;
    const scene::Campus campus = empty_campus();
    ExpectationSet set(campus, walk);
    TickFeed(set).tick({"popup.open a"});
    EXPECT_TRUE(set.verdicts().empty());
}

// ---- when the walk is stopped ----------------------------------------------------------------------------

/// Whether an expectation "fails", is "open", "holds so far" or "holds" when a walk stops after three events
/// and 3 m.
std::string when_stopped(const Expectation& expectation) {
    Walk walk;
    walk.expectations = {expectation};
    const scene::Campus campus = empty_campus();
    ExpectationSet set(campus, walk);
    TickFeed(set)
        .tick({"walk.start me"})
        .after_metres(3)
        .in_the_air(true)
        .tick({"popup.open a", "avatar.stuck me"});
    const ExpectationSet::StoppedVerdicts verdicts = set.verdicts_when_stopped();
    EXPECT_LE(verdicts.failures.size() + verdicts.undecided.size(), 1U);
    if (!verdicts.failures.empty() || verdicts.undecided.empty()) {
        EXPECT_EQ(verdicts.failures.empty(), set.verdicts().empty());
        return verdicts.failures.empty() ? "holds" : "fails";
    }
    EXPECT_EQ(verdicts.undecided.front().holds_so_far, set.verdicts().empty());
    return verdicts.undecided.front().holds_so_far ? "holds so far" : "open";
}

TEST(StoppedWalk, FailsExpectationsThatCanNoLongerHold) {
    for (const Expectation& lost : std::vector<Expectation>{
             expect_never("popup.open"), expect_count("popup.open", 0), expect_count("popup.open", {}, {}, 0),
             ExpectWithin{kWhole, pattern("walk.start"), pattern("avatar.fell"), 0.05},
             ExpectNear{kWhole, {"far", {9, 0, 0}, true}, 1.0, pattern("popup.open")},
             ExpectDuration{kWhole, {{}, {}, 0.05}}, ExpectDistance{kWhole, {{}, {}, 2.0}},
             ExpectGrounded{kWhole, 1.0}, ExpectNot{kWhole, ExpectStuck{kWhole, {kWhole, "*"}}},
             ExpectNot{kWhole, expect_sequence({"walk.start", "popup.open"})}}) {
        EXPECT_EQ(when_stopped(lost), "fails") << lost.index();
    }
}

TEST(StoppedWalk, LeavesExpectationsOpenThatCouldStillHold) {
    int index = 0;
    for (const Expectation& open : std::vector<Expectation>{
             expect_sequence({"popup.open", "popup.close"}), expect_count("popup.open", 2),
             expect_count("popup.open", {}, 2),
             ExpectWithin{kWhole, pattern("popup.open"), pattern("popup.close"), 5.0},
             ExpectWithin{kWhole, pattern("avatar.jump"), pattern("avatar.landed"), 5.0},
             ExpectPopup{kWhole, {kWhole, "b"}}, expect_reaches({"far", {9, 0, 0}, true}, 1.0),
             ExpectNear{kWhole, {"far", {9, 0, 0}, true}, 1.0, std::nullopt},
             ExpectNear{kWhole, {"here", {0, 0, 0}, true}, 1.0, pattern("avatar.fell")},
             ExpectDuration{kWhole, {5.0, {}, {}}}, ExpectDistance{kWhole, {{}, 5.0, {}}},
             ExpectGrounded{kWhole, 0.9}, ExpectBlockedBy{kWhole, {kWhole, "wall"}},
             ExpectStuck{kWhole, {kWhole, "wall"}}, ExpectFell{kWhole},
             ExpectNot{kWhole, expect_never("avatar.fell")}, ExpectNot{kWhole, ExpectNoPenetration{kWhole}},
             ExpectNot{kWhole, expect_count("popup.open", 1)}}) {
        EXPECT_EQ(when_stopped(open), "open") << index;
        ++index;
    }
}

TEST(StoppedWalk, PassesExpectationsThatHold) {
    for (const Expectation& held : std::vector<Expectation>{
             expect_sequence({"popup.open"}), expect_count("popup.open", {}, 1),
             ExpectStuck{kWhole, {kWhole, "*"}}, expect_reaches({"here", {0, 0, 0}, true}, 1.0)}) {
        EXPECT_EQ(when_stopped(held), "holds") << held.index();
    }
}

TEST(StoppedWalk, TellsWhatOnlyHoldsSoFar) {
    for (const Expectation& held :
         std::vector<Expectation>{expect_never("avatar.fell"), expect_count("popup.open", 1),
                                  ExpectNot{kWhole, ExpectFell{kWhole}}, ExpectNoPenetration{kWhole},
                                  ExpectDuration{kWhole, {{}, {}, 5.0}}}) {
        EXPECT_EQ(when_stopped(held), "holds so far") << held.index();
    }
}

TEST(StoppedWalk, LeavesStepsOpenThatItDidNotGetTo) {
    const auto expects = [](int line, Expectation first, Expectation second) {
        ExpectStep step;
        step.mark = {"walk.yaml", line, 1};
        step.expectations = {std::move(first), std::move(second)};
        return step;
    };
    const Expectation holds = expect_never("avatar.fell");
    const Expectation fails = expect_never("walk.start");
    Walk walk;
    const ExpectStep held = expects(3, holds, holds);
    const ExpectStep repeated = expects(4, holds, holds);
    const ExpectStep failing = expects(5, fails, holds);
    const ExpectStep later = expects(6, fails, holds);
    walk.steps = {held, repeated, repeated, failing, later};
    const scene::Campus campus = empty_campus();
    ExpectationSet set(campus, walk);
    TickFeed(set).tick({"walk.start me"});
    const TickRecord record;
    EXPECT_FALSE(set.evaluate(held, record));
    EXPECT_FALSE(set.evaluate(repeated, record));
    ASSERT_TRUE(set.evaluate(failing, record));
    const ExpectationSet::StoppedVerdicts verdicts = set.verdicts_when_stopped();
    EXPECT_TRUE(verdicts.failures.empty());
    ASSERT_EQ(verdicts.undecided.size(), 2U + 1U + 2U) << "a round of 4, the rest of 5, and 6";
    EXPECT_TRUE(std::ranges::none_of(verdicts.undecided, &Undecided::holds_so_far));
    walk.steps = {expects(7, holds, fails)};
    ExpectationSet evaluated(campus, walk);
    TickFeed(evaluated).tick({"walk.start me"});
    ASSERT_TRUE(evaluated.evaluate(std::get<ExpectStep>(walk.steps.front()), record));
    EXPECT_TRUE(evaluated.verdicts_when_stopped().undecided.empty()) << "one held, the other failed";
}

// ---- not ------------------------------------------------------------------------------------------------

TEST(NotExpectation, FailsIfTheExpectationHolds) {
    SingleEvaluator evaluator(ExpectNot{kWhole, ExpectStuck{kWhole, {kWhole, "*"}}});
    TickFeed feed(evaluator);
    feed.tick({"avatar.arrive goal"});
    EXPECT_FALSE(evaluator.failure());
    feed.tick({"avatar.stuck me"}).tick({});
    expect_failure(evaluator.failure(), 7, "not-stuck", {"0.100 s"});
    EXPECT_EQ(evaluator.failure()->scene.tick, 1);
}

TEST(NotExpectation, DescribesWhatHappenedForEveryKind) {
    struct Case {
        PlainExpectation expectation;
        std::vector<std::string> facts;
    };
    const std::vector<Case> cases = {
        {expect_sequence({"walk.start", "popup.open a"}), {"popup.open a at 0.100 s"}},
        {expect_never("avatar.fell"), {"'avatar.fell'"}},
        {expect_count("popup.open", 1), {"'popup.open'"}},
        {ExpectWithin{kWhole, pattern("walk.start"), pattern("popup.open"), 1.0},
         {"'popup.open'", "1.000 s", "'walk.start'"}},
        {ExpectPopup{kWhole, {kWhole, "a"}}, {"'a'"}},
        {ExpectVisits{kWhole, {{kWhole, "*"}}, 1.0}, {"0 of 0"}},
        {expect_reaches({"here", {0, 0, 0}, true}, 1.0), {"here", "0.000 m", "0.000 s"}},
        {ExpectNear{kWhole, {"here", {0, 0, 0}, true}, 1.0, std::nullopt}, {"here", "0.000 m", "0.100 s"}},
        {ExpectDuration{kWhole, {{}, {}, 1.0}}, {"0.100 s"}},
        {ExpectDistance{kWhole, {{}, {}, 1.0}}, {"0.000 m"}},
        {ExpectNoPenetration{kWhole}, {"nothing"}},
        {ExpectGrounded{kWhole}, {"on the ground"}},
        {ExpectBlockedBy{kWhole, {kWhole, "wall"}}, {"wall", "0.100 s"}},
        {ExpectStuck{kWhole, {kWhole, "wall"}}, {"wall", "0.100 s"}},
        {ExpectFell{kWhole}, {"fell", "0.100 s"}}};
    // The last two, reachable and route, don't depend on what happens: route_check_test.cpp.
    ASSERT_EQ(cases.size(), std::variant_size_v<PlainExpectation> - 2);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        EXPECT_EQ(cases[i].expectation.index(), i) << "each kind once";
        SingleEvaluator evaluator(ExpectNot{kWhole, cases[i].expectation});
        std::vector<Event> events = {made_event("popup.open a")};
        if (i >= 12) {
            events = {made_event("avatar.stuck me", {{"by", std::string("wall")}}),
                      made_event("avatar.fell me")};
        }
        TickFeed(evaluator).tick({"walk.start me"}).with(std::move(events));
        ASSERT_TRUE(evaluator.failure()) << i;
        EXPECT_THAT(evaluator.failure()->message, testing::StartsWith("not expected, but ")) << i;
        for (const std::string& fact : cases[i].facts) {
            EXPECT_THAT(evaluator.failure()->message, testing::HasSubstr(fact)) << i;
        }
    }
}

TEST(FailureCodes, AreTheNamesAndTheirNegations) {
    const std::vector<std::string> codes = failure_codes();
    for (const char* code : {"blocked", "enclosed", "timeout", "fell", "sequence", "no_penetration",
                             "not-sequence", "not-fell", "log"}) {
        EXPECT_EQ(std::ranges::count(codes, code), 1) << code;
    }
}

// ---- in steps -------------------------------------------------------------------------------------------

ExpectStep expect_here(Expectation expected, int line = 4) {
    return {{"a.walk.yaml", line, 5}, {std::move(expected)}};
}

TEST(ExpectStep, LetsTheWalkContinueIfItHolds) {
    const RecordedRun result =
        run(level_campus(),
            walk_of({spawn_at({0, 0, 0}), walk_to(0, -1), expect_here(expect_count("avatar.arrive", 1)),
                     walk_to(0, -2), expect_here(expect_count("avatar.arrive", 2), 6)}));
    EXPECT_TRUE(result.summary.passed);
    EXPECT_EQ(result.recorder.events("avatar.arrive").size(), 2U);
}

TEST(ExpectStep, EndsTheWalkIfItFails) {
    const RecordedRun result =
        run(level_campus(), walk_of({spawn_at({0, 0, 0}), walk_to(0, -1),
                                     expect_here(expect_count("avatar.arrive", 2, {}, {}, 4)),
                                     disable("ground"), walk_to(0, -2)}));
    ASSERT_EQ(result.summary.failures.size(), 1U);
    const Failure& failure = result.summary.failures[0];
    EXPECT_EQ(failure.code, "count");
    EXPECT_THAT(failure.message, testing::HasSubstr("'avatar.arrive'"));
    EXPECT_EQ(failure.mark.line, 4);
    EXPECT_EQ(failure.scene.tick, result.summary.ticks);
    EXPECT_EQ(result.recorder.event_lines(),
              std::vector<std::string>({"avatar.arrive goal", "expect.fail count"}))
        << "no later step is played";
}

TEST(ExpectStep, SeesEverythingSinceTheStart) {
    const RecordedRun result = run(
        level_campus(), walk_of({spawn_at({0, 0, 0}), walk_to(0, -1), walk_to(0, -2),
                                 expect_here(expect_reaches({"a", {0, 0, -1}, true}, 0.1)), walk_to(0, -3)}));
    EXPECT_TRUE(result.summary.passed);
}

TEST(ExpectStep, IsEvaluatedAgainInEachRound) {
    std::vector<Step> steps = {spawn_at({0, 0, 0})};
    for (int round = 0; round < 3; ++round) {
        steps.emplace_back(wait_for(1.0));
        steps.emplace_back(expect_here(ExpectDuration{{"a.walk.yaml", 4, 5}, {{}, {}, 2.0}}));
    }
    const RecordedRun result = run(level_campus(), walk_of(steps));
    ASSERT_EQ(result.summary.failures.size(), 1U);
    EXPECT_THAT(result.summary.failures[0].message,
                testing::AllOf(testing::HasSubstr("3.000 s"), testing::HasSubstr("2.000 s")));
}

TEST(ExpectStep, DoesNotChangeTheHash) {
    const Walk without = walk_of({spawn_at({0, 0, 0}), walk_to(0, -1), walk_to(0, -2)});
    const Walk with = walk_of({spawn_at({0, 0, 0}), walk_to(0, -1), expect_here(ExpectGrounded{kWhole}),
                               walk_to(0, -2), expect_here(ExpectNoPenetration{kWhole}, 6)});
    EXPECT_EQ(run(level_campus(), with).summary.hash, run(level_campus(), without).summary.hash);
}

}  // namespace
}  // namespace campuswalk::engine

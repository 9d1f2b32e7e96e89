#include "engine/expect/event_evaluators.h"

#include <gtest/gtest.h>

#include "tests/engine/expect/single_evaluator.h"
#include "tests/engine/short_walk.h"

namespace campuswalk::engine {
namespace {

// ---- sequence -------------------------------------------------------------------------------------------

TEST(SequenceEvaluator, PassesIfAllOccurInOrderWithOthersBetween) {
    const ExpectSequence expected = expect_sequence({"trigger.enter a", "popup.open *", "trigger.exit"}, 3);
    SingleEvaluator evaluator(expected);
    TickFeed(evaluator)
        .tick({"trigger.enter b", "trigger.enter a"})
        .tick({"popup.open x"})
        .tick({"trigger.exit b"});
    EXPECT_FALSE(evaluator.failure());
}

TEST(SequenceEvaluator, AcceptsSeveralEventsOfOneTick) {
    const ExpectSequence expected = expect_sequence({"trigger.enter a", "popup.open a"}, 3);
    SingleEvaluator evaluator(expected);
    TickFeed(evaluator).tick({"trigger.enter a", "popup.open a"});
    EXPECT_FALSE(evaluator.failure());
}

TEST(SequenceEvaluator, FailsAtTheFirstMissingEvent) {
    const ExpectSequence expected = expect_sequence({"trigger.enter a", "popup.open x", "trigger.exit a"}, 3);
    SingleEvaluator evaluator(expected);
    TickFeed(evaluator).tick({}).tick({"popup.open x", "trigger.enter a"}).tick({"trigger.exit a"});
    expect_failure(evaluator.failure(), 5, "sequence",
                   {"'popup.open x'", "trigger.enter a at 0.100 s", "popup.open x at 0.100 s"});
}

TEST(SequenceEvaluator, MentionsEarlierOccurrencesOnlyIfThereWereAny) {
    const ExpectSequence expected = expect_sequence({"trigger.enter a", "popup.open x"}, 3);
    SingleEvaluator evaluator(expected);
    TickFeed(evaluator).tick({"trigger.enter a", "popup.open y"});
    expect_failure(evaluator.failure(), 5, "sequence", {"'popup.open x'", "trigger.enter a at 0.000 s"});
    EXPECT_EQ(evaluator.failure()->message.find("popup.open x at"), std::string::npos);
}

TEST(SequenceEvaluator, FailsIfEvenTheFirstIsMissing) {
    const ExpectSequence expected = expect_sequence({"trigger.enter"}, 3);
    SingleEvaluator evaluator(expected);
    TickFeed(evaluator).tick({"trigger.exit a"});
    expect_failure(evaluator.failure(), 4, "sequence", {"'trigger.enter'"});
    EXPECT_EQ(evaluator.failure()->message.find("after"), std::string::npos);
}

TEST(SequenceEvaluator, MatchesEachEventToOneItem) {
    const ExpectSequence expected = expect_sequence({"popup.open x", "popup.open x"}, 3);
    SingleEvaluator evaluator(expected);
    TickFeed feed(evaluator);
    feed.tick({"popup.open x"});
    expect_failure(evaluator.failure(), 5, "sequence", {"'popup.open x'", "popup.open x at 0.000 s"});
    feed.tick({"popup.open x"});
    EXPECT_FALSE(evaluator.failure());
}

// ---- never ----------------------------------------------------------------------------------------------

TEST(NeverEvaluator, PassesWhenNothingMatches) {
    const ExpectNever expected = expect_never("collision.enter pond*", 7);
    SingleEvaluator evaluator(expected);
    TickFeed(evaluator).tick({"collision.exit pond", "collision.enter bench", "trigger.enter pond"});
    EXPECT_FALSE(evaluator.failure());
}

TEST(NeverEvaluator, ReportsTheFirstMatchAndTheCount) {
    ExpectNever expected = expect_never("collision.enter pond*", 7);
    expected.event.mark.line = 8;
    SingleEvaluator evaluator(expected);
    TickFeed feed(evaluator);
    feed.tick({}).tick({}).tick({"collision.enter pond/rim"});
    expect_failure(evaluator.failure(), 8, "never",
                   {"'collision.enter pond*'", "once", "collision.enter pond/rim at 0.200 s"});
    feed.tick({"collision.enter pond", "collision.enter pond-2"});
    expect_failure(evaluator.failure(), 8, "never",
                   {"'collision.enter pond*'", "3 times", "collision.enter pond/rim at 0.200 s"});
}

// ---- count ----------------------------------------------------------------------------------------------

std::optional<Failure> count_three(const ExpectCount& expected) {
    SingleEvaluator evaluator(expected);
    TickFeed(evaluator).tick({"popup.open a", "popup.close a"}).tick({"popup.open b", "popup.open a"});
    return evaluator.failure();
}

ExpectCount count(std::optional<int> equals, std::optional<int> at_least, std::optional<int> at_most) {
    return expect_count("popup.open *", equals, at_least, at_most, 9);
}

TEST(CountEvaluator, PassesAtTheBounds) {
    EXPECT_FALSE(count_three(count(3, {}, {})));
    EXPECT_FALSE(count_three(count({}, 3, {})));
    EXPECT_FALSE(count_three(count({}, 0, {})));
    EXPECT_FALSE(count_three(count({}, {}, 3)));
    EXPECT_FALSE(count_three(count({}, 3, 3)));
}

TEST(CountEvaluator, FailsBeyondTheBounds) {
    expect_failure(count_three(count(2, {}, {})), 9, "count", {"'popup.open'", "3 times", "exactly 2"});
    expect_failure(count_three(count(4, {}, {})), 9, "count", {"'popup.open'", "3 times", "exactly 4"});
    expect_failure(count_three(count({}, 4, {})), 9, "count", {"'popup.open'", "3 times", "at least 4"});
    expect_failure(count_three(count({}, {}, 2)), 9, "count", {"'popup.open'", "3 times", "at most 2"});
    expect_failure(count_three(count({}, 1, 2)), 9, "count", {"'popup.open'", "3 times", "at most 2"});
}

TEST(CountEvaluator, ReportsOneOccurrenceAndNone) {
    ExpectCount expected = count(5, {}, {});
    expected.event = pattern("popup.close a");
    expect_failure(count_three(expected), 9, "count", {"'popup.close a'", "once", "exactly 5"});
    expected.event = pattern("popup.close b");
    expect_failure(count_three(expected), 9, "count", {"'popup.close b'", "0 times", "exactly 5"});
}

// ---- within ---------------------------------------------------------------------------------------------

ExpectWithin soon(double seconds = 0.2) {
    return {{"a.walk.yaml", 12, 5}, pattern("trigger.enter door"), pattern("popup.open *"), seconds};
}

TEST(WithinEvaluator, PassesIfEachIsFollowedInTime) {
    SingleEvaluator evaluator(soon());
    TickFeed(evaluator)
        .tick({"trigger.enter door", "popup.open a"})
        .tick({"trigger.enter door"})
        .tick({"trigger.enter door"})
        .tick({"popup.open b"})
        .tick({});
    EXPECT_FALSE(evaluator.failure()) << "in the last tick that is in time, and one event follows both";
}

TEST(WithinEvaluator, FailsAtTheFirstThatIsNotFollowedInTime) {
    SingleEvaluator evaluator(soon());
    TickFeed(evaluator)
        .tick({"popup.open early", "trigger.enter door"})
        .tick({"trigger.enter door"})
        .tick({})
        .tick({"popup.open a"})
        .tick({"popup.open b"});
    expect_failure(evaluator.failure(), 12, "within",
                   {"'popup.open'", "0.200 s", "trigger.enter door at 0.000 s", "popup.open a at 0.300 s"});
    EXPECT_EQ(evaluator.failure()->scene.tick, 3) << "the first tick that is too late";
}

TEST(WithinEvaluator, FailsIfTheWalkEndsBefore) {
    SingleEvaluator evaluator(soon());
    TickFeed(evaluator).tick({}).tick({"trigger.enter door"});
    EXPECT_FALSE(evaluator.failure_so_far()) << "it may still follow";
    expect_failure(evaluator.failure(), 12, "within",
                   {"'popup.open'", "0.200 s", "trigger.enter door at 0.100 s", "the walk was over"});
}

TEST(WithinEvaluator, FailsIfTheFirstEventIsMissing) {
    ExpectWithin expected = soon();
    expected.after.mark = {"a.walk.yaml", 13, 9};
    SingleEvaluator evaluator(expected);
    TickFeed(evaluator).tick({"popup.open a"});
    expect_failure(evaluator.failure(), 13, "within", {"'trigger.enter door'"});
}

// ---- the deciding tick ----------------------------------------------------------------------------------

TEST(EventEvaluators, ReportTheDecidingTick) {
    SingleEvaluator never(expect_never("popup.open"));
    SingleEvaluator at_most(count({}, {}, 1));
    SingleEvaluator at_least(count({}, 5, {}));
    for (SingleEvaluator* evaluator : {&never, &at_most, &at_least}) {
        TickFeed(*evaluator).tick({}).tick({"popup.open a"}).tick({"popup.open b"}).tick({});
    }
    EXPECT_EQ(never.failure()->scene.tick, 1);
    EXPECT_EQ(at_most.failure()->scene.tick, 2);
    EXPECT_EQ(at_least.failure()->scene.tick, 3) << "undecided until the end";
}

}  // namespace
}  // namespace campuswalk::engine

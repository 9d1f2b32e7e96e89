#include "engine/expect/event_evaluators.h"

#include <gtest/gtest.h>

#include "tests/engine/expect/single_evaluator.h"
#include "tests/engine/short_walk.h"

namespace campuswalk::engine {
namespace {

// ---- sequence -------------------------------------------------------------------------------------------

TEST(SequenceEvaluator, PassesWhenAllComeInOrderWithOthersBetween) {
    const ExpectSequence expected = expect_sequence({"trigger.enter a", "popup.open *", "trigger.exit"}, 3);
    OneEvaluator evaluator(expected);
    Frames(evaluator)
        .tick({"trigger.enter b", "trigger.enter a"})
        .tick({"popup.open x"})
        .tick({"trigger.exit b"});
    EXPECT_FALSE(evaluator.failure());
}

TEST(SequenceEvaluator, TakesSeveralOfOneTick) {
    const ExpectSequence expected = expect_sequence({"trigger.enter a", "popup.open a"}, 3);
    OneEvaluator evaluator(expected);
    Frames(evaluator).tick({"trigger.enter a", "popup.open a"});
    EXPECT_FALSE(evaluator.failure());
}

TEST(SequenceEvaluator, FailsAtTheFirstThatNeverCame) {
    const ExpectSequence expected = expect_sequence({"trigger.enter a", "popup.open x", "trigger.exit a"}, 3);
    OneEvaluator evaluator(expected);
    Frames(evaluator).tick({}).tick({"popup.open x", "trigger.enter a"}).tick({"trigger.exit a"});
    expect_failure(evaluator.failure(), 5, "sequence",
                   "'popup.open x' never came after trigger.enter a at 0.100 s, only before: popup.open x at "
                   "0.100 s");
}

TEST(SequenceEvaluator, SaysNothingOfEarlierOnesWhenThereWereNone) {
    const ExpectSequence expected = expect_sequence({"trigger.enter a", "popup.open x"}, 3);
    OneEvaluator evaluator(expected);
    Frames(evaluator).tick({"trigger.enter a", "popup.open y"});
    expect_failure(evaluator.failure(), 5, "sequence",
                   "'popup.open x' never came after trigger.enter a at 0.000 s");
}

TEST(SequenceEvaluator, SaysWhenEvenTheFirstNeverCame) {
    const ExpectSequence expected = expect_sequence({"trigger.enter"}, 3);
    OneEvaluator evaluator(expected);
    Frames(evaluator).tick({"trigger.exit a"});
    expect_failure(evaluator.failure(), 4, "sequence", "'trigger.enter' never came");
}

TEST(SequenceEvaluator, CountsOneEventForOneItem) {
    const ExpectSequence expected = expect_sequence({"popup.open x", "popup.open x"}, 3);
    OneEvaluator evaluator(expected);
    Frames frames(evaluator);
    frames.tick({"popup.open x"});
    expect_failure(evaluator.failure(), 5, "sequence",
                   "'popup.open x' never came after popup.open x at 0.000 s");
    frames.tick({"popup.open x"});
    EXPECT_FALSE(evaluator.failure());
}

// ---- never ----------------------------------------------------------------------------------------------

TEST(NeverEvaluator, PassesWhenNothingMatches) {
    const ExpectNever expected = expect_never("collision.enter pond*", 7);
    OneEvaluator evaluator(expected);
    Frames(evaluator).tick({"collision.exit pond", "collision.enter bench", "trigger.enter pond"});
    EXPECT_FALSE(evaluator.failure());
}

TEST(NeverEvaluator, FailsWithTheFirstAndHowOften) {
    ExpectNever expected = expect_never("collision.enter pond*", 7);
    expected.event.mark.line = 8;
    OneEvaluator evaluator(expected);
    Frames frames(evaluator);
    frames.tick({}).tick({}).tick({"collision.enter pond/rim"});
    expect_failure(evaluator.failure(), 8, "never",
                   "'collision.enter pond*' happened once, first collision.enter pond/rim at 0.200 s");
    frames.tick({"collision.enter pond", "collision.enter pond-2"});
    expect_failure(evaluator.failure(), 8, "never",
                   "'collision.enter pond*' happened 3 times, first collision.enter pond/rim at 0.200 s");
}

// ---- count ----------------------------------------------------------------------------------------------

std::optional<Failure> count_three(const ExpectCount& expected) {
    OneEvaluator evaluator(expected);
    Frames(evaluator).tick({"popup.open a", "popup.close a"}).tick({"popup.open b", "popup.open a"});
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

TEST(CountEvaluator, FailsBeyondThem) {
    expect_failure(count_three(count(2, {}, {})), 9, "count",
                   "'popup.open' happened 3 times, expected exactly 2");
    expect_failure(count_three(count(4, {}, {})), 9, "count",
                   "'popup.open' happened 3 times, expected exactly 4");
    expect_failure(count_three(count({}, 4, {})), 9, "count",
                   "'popup.open' happened 3 times, expected at least 4");
    expect_failure(count_three(count({}, {}, 2)), 9, "count",
                   "'popup.open' happened 3 times, expected at most 2");
    expect_failure(count_three(count({}, 1, 2)), 9, "count",
                   "'popup.open' happened 3 times, expected at most 2");
}

TEST(CountEvaluator, SaysOnceAndNoTimes) {
    ExpectCount expected = count(5, {}, {});
    expected.event = pattern("popup.close a");
    expect_failure(count_three(expected), 9, "count", "'popup.close a' happened once, expected exactly 5");
    expected.event = pattern("popup.close b");
    expect_failure(count_three(expected), 9, "count", "'popup.close b' happened 0 times, expected exactly 5");
}

// ---- within ---------------------------------------------------------------------------------------------

ExpectWithin soon(double seconds = 0.2) {
    return {{"a.walk.yaml", 12, 5}, pattern("trigger.enter door"), pattern("popup.open *"), seconds};
}

TEST(WithinEvaluator, PassesWhenEachIsFollowedInTime) {
    OneEvaluator evaluator(soon());
    Frames(evaluator)
        .tick({"trigger.enter door", "popup.open a"})
        .tick({"trigger.enter door"})
        .tick({"trigger.enter door"})
        .tick({"popup.open b"})
        .tick({});
    EXPECT_FALSE(evaluator.failure()) << "at the last moment, and one for both";
}

TEST(WithinEvaluator, FailsAtTheFirstThatIsNot) {
    OneEvaluator evaluator(soon());
    Frames(evaluator)
        .tick({"popup.open early", "trigger.enter door"})
        .tick({"trigger.enter door"})
        .tick({})
        .tick({"popup.open a"})
        .tick({"popup.open b"});
    expect_failure(evaluator.failure(), 12, "within",
                   "'popup.open' did not come within 0.200 s after trigger.enter door at 0.000 s, only as "
                   "popup.open a at 0.300 s");
    EXPECT_EQ(evaluator.failure()->scene.tick, 3) << "when it was too late";
}

TEST(WithinEvaluator, FailsWhenTheWalkEndsBefore) {
    OneEvaluator evaluator(soon());
    Frames(evaluator).tick({}).tick({"trigger.enter door"});
    EXPECT_FALSE(evaluator.failure_so_far()) << "it may still come";
    expect_failure(evaluator.failure(), 12, "within",
                   "'popup.open' did not come within 0.200 s after trigger.enter door at 0.100 s: the walk "
                   "was over by then");
}

TEST(WithinEvaluator, FailsWhenThereWasNothingToFollow) {
    ExpectWithin expected = soon();
    expected.after.mark = {"a.walk.yaml", 13, 9};
    OneEvaluator evaluator(expected);
    Frames(evaluator).tick({"popup.open a"});
    expect_failure(evaluator.failure(), 13, "within",
                   "'trigger.enter door' never came, so nothing could follow it");
}

// ---- when -----------------------------------------------------------------------------------------------

TEST(EventJudges, TellWhenItWasDecided) {
    OneEvaluator never(expect_never("popup.open"));
    OneEvaluator at_most(count({}, {}, 1));
    OneEvaluator at_least(count({}, 5, {}));
    for (OneEvaluator* evaluator : {&never, &at_most, &at_least}) {
        Frames(*evaluator).tick({}).tick({"popup.open a"}).tick({"popup.open b"}).tick({});
    }
    EXPECT_EQ(never.failure()->scene.tick, 1);
    EXPECT_EQ(at_most.failure()->scene.tick, 2);
    EXPECT_EQ(at_least.failure()->scene.tick, 3) << "it might have come to the end";
}

}  // namespace
}  // namespace campuswalk::engine

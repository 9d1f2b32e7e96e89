#include "engine/expect/expectation_judge.h"

#include <algorithm>
#include <functional>

#include <gtest/gtest.h>

#include "tests/engine/short_walk.h"

namespace campuswalk::engine {
namespace {

using Eigen::Vector3d;

/// Frames made by hand, a tenth of a second apart.
class Frames {
public:
    template <typename Judge>
    explicit Frames(Judge& judge) : see_([&judge](const FrameRecord& record) { judge.see(record); }) {}

    Frames& tick(const std::vector<std::string>& told_events, const Vector3d& position = Vector3d::Zero()) {
        std::vector<Event> events;
        for (const std::string& words : told_events) {
            const EventPattern made = pattern(words);
            const std::vector<std::string> names = event_kind_names();
            const auto kind = std::find(names.begin(), names.end(), made.kind) - names.begin();
            events.push_back({tick_, 1.0, static_cast<EventKind>(kind), made.object, {}});
        }
        FrameRecord record;
        record.tick = tick_;
        record.time = static_cast<double>(tick_) / 10.0;
        record.avatar.position = position;
        record.events = events;
        see_(record);
        ++tick_;
        return *this;
    }

private:
    std::function<void(const FrameRecord&)> see_;
    Tick tick_ = 0;
};

void expect_failure(const std::optional<Failure>& failure, int mark_line, const std::string& code,
                    const std::string& message) {
    ASSERT_TRUE(failure);
    EXPECT_EQ(failure->mark.line, mark_line);
    EXPECT_EQ(failure->code, code);
    EXPECT_EQ(failure->message, message);
}

TEST(Matches, GlobsInKindAndObject) {
    const Event event{0, 1.0, EventKind::collision_enter, "bench/bench-01", {}};
    for (const char* words : {"collision.enter bench/bench-01", "collision.enter", "collision.* bench/*", "*",
                              "*.enter *-01", "collision.enter bench/bench-0[1-3]"}) {
        EXPECT_TRUE(matches(pattern(words), event)) << words;
    }
    for (const char* words : {"collision.exit bench/bench-01", "collision.enter bench", "collision bench/*",
                              "trigger.*", "collision.enter Bench/*"}) {
        EXPECT_FALSE(matches(pattern(words), event)) << words;
    }
}

// ---- sequence -------------------------------------------------------------------------------------------

TEST(SequenceJudge, PassesWhenAllComeInOrderWithOthersBetween) {
    const ExpectSequence expected = expect_sequence({"trigger.enter a", "popup.open *", "trigger.exit"}, 3);
    SequenceJudge judge(expected);
    Frames(judge)
        .tick({"trigger.enter b", "trigger.enter a"})
        .tick({"popup.open x"})
        .tick({"trigger.exit b"});
    EXPECT_FALSE(judge.verdict());
}

TEST(SequenceJudge, TakesSeveralOfOneTick) {
    const ExpectSequence expected = expect_sequence({"trigger.enter a", "popup.open a"}, 3);
    SequenceJudge judge(expected);
    Frames(judge).tick({"trigger.enter a", "popup.open a"});
    EXPECT_FALSE(judge.verdict());
}

TEST(SequenceJudge, FailsAtTheFirstThatNeverCame) {
    const ExpectSequence expected = expect_sequence({"trigger.enter a", "popup.open x", "trigger.exit a"}, 3);
    SequenceJudge judge(expected);
    Frames(judge).tick({}).tick({"popup.open x", "trigger.enter a"}).tick({"trigger.exit a"});
    expect_failure(judge.verdict(), 5, "sequence",
                   "'popup.open x' never came after trigger.enter a at 0.100 s, only before: popup.open x at "
                   "0.100 s");
}

TEST(SequenceJudge, SaysNothingOfEarlierOnesWhenThereWereNone) {
    const ExpectSequence expected = expect_sequence({"trigger.enter a", "popup.open x"}, 3);
    SequenceJudge judge(expected);
    Frames(judge).tick({"trigger.enter a", "popup.open y"});
    expect_failure(judge.verdict(), 5, "sequence",
                   "'popup.open x' never came after trigger.enter a at 0.000 s");
}

TEST(SequenceJudge, SaysWhenEvenTheFirstNeverCame) {
    const ExpectSequence expected = expect_sequence({"trigger.enter"}, 3);
    SequenceJudge judge(expected);
    Frames(judge).tick({"trigger.exit a"});
    expect_failure(judge.verdict(), 4, "sequence", "'trigger.enter' never came");
}

TEST(SequenceJudge, CountsOneEventForOneItem) {
    const ExpectSequence expected = expect_sequence({"popup.open x", "popup.open x"}, 3);
    SequenceJudge judge(expected);
    Frames frames(judge);
    frames.tick({"popup.open x"});
    expect_failure(judge.verdict(), 5, "sequence", "'popup.open x' never came after popup.open x at 0.000 s");
    frames.tick({"popup.open x"});
    EXPECT_FALSE(judge.verdict());
}

// ---- never ----------------------------------------------------------------------------------------------

TEST(NeverJudge, PassesWhenNothingMatches) {
    const ExpectNever expected = expect_never("collision.enter pond*", 7);
    NeverJudge judge(expected);
    Frames(judge).tick({"collision.exit pond", "collision.enter bench", "trigger.enter pond"});
    EXPECT_FALSE(judge.verdict());
}

TEST(NeverJudge, FailsWithTheFirstAndHowOften) {
    ExpectNever expected = expect_never("collision.enter pond*", 7);
    expected.event.mark.line = 8;
    NeverJudge judge(expected);
    Frames frames(judge);
    frames.tick({}).tick({}).tick({"collision.enter pond/rim"});
    expect_failure(judge.verdict(), 8, "never",
                   "'collision.enter pond*' happened once, first collision.enter pond/rim at 0.200 s");
    frames.tick({"collision.enter pond", "collision.enter pond-2"});
    expect_failure(judge.verdict(), 8, "never",
                   "'collision.enter pond*' happened 3 times, first collision.enter pond/rim at 0.200 s");
}

// ---- count ----------------------------------------------------------------------------------------------

std::optional<Failure> count_three(const ExpectCount& expected) {
    CountJudge judge(expected);
    Frames(judge).tick({"popup.open a", "popup.close a"}).tick({"popup.open b", "popup.open a"});
    return judge.verdict();
}

ExpectCount count(std::optional<int> equals, std::optional<int> at_least, std::optional<int> at_most) {
    return expect_count("popup.open *", equals, at_least, at_most, 9);
}

TEST(CountJudge, PassesAtTheBounds) {
    EXPECT_FALSE(count_three(count(3, {}, {})));
    EXPECT_FALSE(count_three(count({}, 3, {})));
    EXPECT_FALSE(count_three(count({}, 0, {})));
    EXPECT_FALSE(count_three(count({}, {}, 3)));
    EXPECT_FALSE(count_three(count({}, 3, 3)));
}

TEST(CountJudge, FailsBeyondThem) {
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

TEST(CountJudge, SaysOnceAndNoTimes) {
    ExpectCount expected = count(5, {}, {});
    expected.event = pattern("popup.close a");
    expect_failure(count_three(expected), 9, "count", "'popup.close a' happened once, expected exactly 5");
    expected.event = pattern("popup.close b");
    expect_failure(count_three(expected), 9, "count", "'popup.close b' happened 0 times, expected exactly 5");
}

// ---- reaches --------------------------------------------------------------------------------------------

TEST(ReachesJudge, PassesWhenSomeTickEndedNearEnough) {
    const ExpectReaches expected = expect_reaches({"square", {3, 0, 4}, true}, 5.0, 11);
    ReachesJudge judge(expected);
    Frames(judge).tick({}, {100, 0, 0}).tick({}, {0, 0, 0}).tick({}, {-100, 0, 0});
    EXPECT_FALSE(judge.verdict()) << "5 m away is within 5 m";
}

TEST(ReachesJudge, FailsWithTheNearest) {
    const ExpectReaches expected = expect_reaches({"square", {3, 0, 4}, true}, 1.0, 11);
    ReachesJudge judge(expected);
    Frames(judge).tick({}, {100, 0, 0}).tick({}, {0, 0, 0}).tick({}, {0, 0, 0}).tick({}, {-100, 0, 0});
    expect_failure(judge.verdict(), 11, "reaches",
                   "square was not reached: the avatar came within 5.000 m at 0.100 s, expected 1.000 m");
}

TEST(ReachesJudge, CountsHeightOnlyWhenTheTargetHasOne) {
    const ExpectReaches with_height = expect_reaches({"roof", {0, 12, 0}, true}, 0.5, 11);
    const ExpectReaches without = expect_reaches({"0,0", {0, 0, 0}, false}, 0.5, 11);
    ReachesJudge strict(with_height);
    ReachesJudge lenient(without);
    Frames(strict).tick({}, {0, 8, 0});
    Frames(lenient).tick({}, {0, 8, 0});
    EXPECT_FALSE(lenient.verdict());
    expect_failure(strict.verdict(), 11, "reaches",
                   "roof was not reached: the avatar came within 4.000 m at 0.000 s, expected 0.500 m");
}

// ---- all of them ----------------------------------------------------------------------------------------

TEST(Jury, GivesItsVerdictsInTheOrderOfTheFile) {
    Walk walk;
    walk.expectations = {expect_reaches({"far", {50, 0, 0}, false}, 0.5), expect_never("popup.open"),
                         count(1, {}, {}), expect_sequence({"popup.open b"})};
    Jury jury(walk);
    Frames(jury).tick({"popup.open a"});
    const std::vector<Failure> failures = jury.verdicts();
    ASSERT_EQ(failures.size(), 3U);
    EXPECT_EQ(failures[0].code, "reaches");
    EXPECT_EQ(failures[1].code, "never");
    EXPECT_EQ(failures[2].code, "sequence");
}

TEST(Jury, IsContentWithoutExpectations) {
    const Walk walk;
    Jury jury(walk);
    Frames(jury).tick({"popup.open a"});
    EXPECT_TRUE(jury.verdicts().empty());
}

}  // namespace
}  // namespace campuswalk::engine

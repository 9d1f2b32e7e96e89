#include "engine/testing/gmock_matchers.h"

#include <sstream>

#include <gtest/gtest.h>

#include "engine/record/tick_record.h"

namespace campuswalk::engine {
namespace {

using ::testing::Ge;
using ::testing::Not;

Event event(Tick tick, EventKind kind, const std::string& object) {
    Event made;
    made.tick = tick;
    made.kind = kind;
    made.object = object;
    return made;
}

/// A visitor goes through a door twice.
std::vector<Event> two_visits() {
    return {event(1, EventKind::trigger_enter, "library/door"), event(1, EventKind::popup_open, "library"),
            event(9, EventKind::trigger_exit, "library/door"), event(9, EventKind::popup_close, "library"),
            event(20, EventKind::trigger_enter, "library/door")};
}

std::string printed(const Verdict& verdict) {
    std::ostringstream out;
    out << verdict;
    return out.str();
}

TEST(EventLog, KeepsTheEventsOfEveryFrame) {
    EventLog log;
    const std::vector<Event> events = two_visits();
    TickRecord record;
    record.events = std::span(events).first(2);
    log.frame(record);
    record.events = std::span(events).subspan(2);
    log.frame(record);
    ASSERT_EQ(log.events().size(), 5U);
    EXPECT_EQ(log.events().back().tick, 20);
}

TEST(EventLog, FindsSequencesWithOthersInBetween) {
    EXPECT_TRUE(has_sequence(two_visits(), {"trigger.enter library/door", "popup.close library"}).holds);
    EXPECT_TRUE(has_sequence(two_visits(), {"trigger.enter", "popup.*", "trigger.enter library/*"}).holds);
    EXPECT_TRUE(has_sequence(two_visits(), {}).holds);
    const Verdict once = has_sequence(two_visits(), {"popup.close", "popup.open library"});
    EXPECT_FALSE(once.holds);
    EXPECT_EQ(printed(once), "no popup.open library after popup.close library in tick 9");
    EXPECT_EQ(printed(has_sequence(two_visits(), {"avatar.fell"})), "no avatar.fell after the walk's start");
}

TEST(EventLog, OneEventIsNotTwoOfASequence) {
    EXPECT_TRUE(has_sequence(two_visits(), {"trigger.enter", "trigger.enter"}).holds);
    EXPECT_FALSE(has_sequence(two_visits(), {"trigger.enter", "trigger.enter", "trigger.enter"}).holds);
}

TEST(EventLog, CountsAndMissesEvents) {
    EXPECT_EQ(count_of(two_visits(), "trigger.enter library/door"), 2U);
    EXPECT_EQ(count_of(two_visits(), "* library*"), 5U);
    EXPECT_EQ(count_of(two_visits(), "trigger.enter gym/*"), 0U);
    EXPECT_TRUE(has_never(two_visits(), "popup.open gym").holds);
    EXPECT_EQ(printed(has_never(two_visits(), "popup.*")), "popup.open library in tick 1");
}

TEST(GmockMatchers, SayWhatTheyFound) {
    EXPECT_THAT(two_visits(), HasSequence({"popup.open", "popup.close"}));
    EXPECT_THAT(two_visits(), Not(HasSequence({"popup.close", "popup.open"})));
    EXPECT_THAT(two_visits(), HasNever("avatar.fell"));
    EXPECT_THAT(two_visits(), HasCount("trigger.*", Ge(3U)));
    EXPECT_THAT(two_visits(), Not(HasCount("trigger.*", 2U)));

    ::testing::StringMatchResultListener said;
    EXPECT_FALSE(::testing::ExplainMatchResult(HasNever("popup.close library"), two_visits(), &said));
    EXPECT_EQ(said.str(), "popup.close library in tick 9");
}

}  // namespace
}  // namespace campuswalk::engine

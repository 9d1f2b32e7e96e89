#include "engine/testing/gmock_matchers.h"

#include <sstream>

#include <gtest/gtest.h>

#include "engine/record/tick_record.h"

namespace campuswalk::engine {
namespace {

using ::testing::AllOf;
using ::testing::Ge;
using ::testing::HasSubstr;
using ::testing::Not;

Event event(Tick tick, EventKind kind, const std::string& object) {
    Event made;
    made.tick = tick;
    made.kind = kind;
    made.object = object;
    return made;
}

/// A visitor walks through a door twice.
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

TEST(EventLog, RecordsTheEventsOfEveryTick) {
    EventLog log;
    const std::vector<Event> events = two_visits();
    TickRecord record;
    record.events = std::span(events).first(2);
    log.on_tick(record);
    record.events = std::span(events).subspan(2);
    log.on_tick(record);
    ASSERT_EQ(log.events().size(), 5U);
    EXPECT_EQ(log.events().back().tick, 20);
}

TEST(EventLog, FindsSequencesWithOtherEventsInBetween) {
    EXPECT_TRUE(has_sequence(two_visits(), {"trigger.enter library/door", "popup.close library"}).holds);
    EXPECT_TRUE(has_sequence(two_visits(), {"trigger.enter", "popup.*", "trigger.enter library/*"}).holds);
    EXPECT_TRUE(has_sequence(two_visits(), {}).holds);
    const Verdict verdict = has_sequence(two_visits(), {"popup.close", "popup.open library"});
    EXPECT_FALSE(verdict.holds);
    EXPECT_THAT(printed(verdict), AllOf(HasSubstr("popup.open library"), HasSubstr("popup.close library"),
                                        HasSubstr("tick 9")));
    EXPECT_THAT(printed(has_sequence(two_visits(), {"avatar.fell"})), HasSubstr("avatar.fell"));
}

TEST(EventLog, MatchesAnEventToOneItemOfASequenceOnly) {
    EXPECT_TRUE(has_sequence(two_visits(), {"trigger.enter", "trigger.enter"}).holds);
    EXPECT_FALSE(has_sequence(two_visits(), {"trigger.enter", "trigger.enter", "trigger.enter"}).holds);
}

TEST(EventLog, CountsEventsAndFindsForbiddenOnes) {
    EXPECT_EQ(count_of(two_visits(), "trigger.enter library/door"), 2U);
    EXPECT_EQ(count_of(two_visits(), "* library*"), 5U);
    EXPECT_EQ(count_of(two_visits(), "trigger.enter gym/*"), 0U);
    EXPECT_TRUE(has_never(two_visits(), "popup.open gym").holds);
    EXPECT_THAT(printed(has_never(two_visits(), "popup.*")),
                AllOf(HasSubstr("popup.open library"), HasSubstr("tick 1")));
}

TEST(GmockMatchers, ExplainTheirResult) {
    EXPECT_THAT(two_visits(), HasSequence({"popup.open", "popup.close"}));
    EXPECT_THAT(two_visits(), Not(HasSequence({"popup.close", "popup.open"})));
    EXPECT_THAT(two_visits(), HasNever("avatar.fell"));
    EXPECT_THAT(two_visits(), HasCount("trigger.*", Ge(3U)));
    EXPECT_THAT(two_visits(), Not(HasCount("trigger.*", 2U)));

    ::testing::StringMatchResultListener explanation;
    EXPECT_FALSE(::testing::ExplainMatchResult(HasNever("popup.close library"), two_visits(), &explanation));
    EXPECT_THAT(explanation.str(), AllOf(HasSubstr("popup.close library"), HasSubstr("tick 9")));
}

}  // namespace
}  // namespace campuswalk::engine

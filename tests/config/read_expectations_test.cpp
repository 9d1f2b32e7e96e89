#include "config/loader/read_expectations.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/config/config_folder.h"

namespace campuswalk::config {
namespace {

using namespace engine;
using testing::ElementsAre;

class ReadExpectations : public testing::Test {
protected:
    std::vector<Expectation> read(const std::string& text) {
        EXPECT_THAT(folder_.about_expectations(text), ElementsAre());
        return folder_.run().walk.expectations;
    }

    test::ConfigFolder folder_;
};

TEST_F(ReadExpectations, ReadsEventPatterns) {
    const auto all =
        read("  - sequence: [\"trigger.enter hut/door\", popup.open]\n  - never: collision.* pond*\n");
    const auto& sequence = std::get<ExpectSequence>(all.at(0));
    ASSERT_EQ(sequence.events.size(), 2U);
    EXPECT_EQ(sequence.events[0].kind, "trigger.enter");
    EXPECT_EQ(sequence.events[0].object, "hut/door");
    EXPECT_EQ(sequence.events[1].kind, "popup.open");
    EXPECT_EQ(sequence.events[1].object, "*");
    EXPECT_EQ(sequence.mark.line, 4);
    EXPECT_EQ(sequence.mark.column, 15);
    const auto& never = std::get<ExpectNever>(all.at(1));
    EXPECT_EQ(never.event.kind, "collision.*");
    EXPECT_EQ(never.event.object, "pond*");
}

TEST_F(ReadExpectations, ReadsCountsAndGoals) {
    const auto all = read(
        "  - count: {event: popup.open, equals: 0}\n"
        "  - count: {event: popup.open, at_least: 1, at_most: 4}\n"
        "  - reaches: square\n"
        "  - reaches: {place: [1, 2], within: 2}\n");
    EXPECT_EQ(std::get<ExpectCount>(all.at(0)).equals, 0);
    EXPECT_FALSE(std::get<ExpectCount>(all.at(0)).at_least);
    EXPECT_EQ(std::get<ExpectCount>(all.at(1)).at_least, 1);
    EXPECT_EQ(std::get<ExpectCount>(all.at(1)).at_most, 4);
    EXPECT_EQ(std::get<ExpectReaches>(all.at(2)).target.point, Eigen::Vector3d(2, 0, -3));
    EXPECT_EQ(std::get<ExpectReaches>(all.at(2)).within, 0.5);
    EXPECT_FALSE(std::get<ExpectReaches>(all.at(3)).target.has_height);
    EXPECT_EQ(std::get<ExpectReaches>(all.at(3)).within, 2.0);
}

TEST_F(ReadExpectations, WantsOneKeyEach) {
    EXPECT_THAT(folder_.about_expectations("  - {}\n  - squence: [a]\n  - never: a\n    count: b\n"),
                ElementsAre("a.walk.yaml:4:5: error bad-value: an expectation is empty",
                            "a.walk.yaml:5:5: error unknown-key: unknown key 'squence' for an expectation "
                            "(did you mean 'sequence'?)",
                            "a.walk.yaml:6:5: error bad-value: an expectation has one key; start 'count' on "
                            "a line of its own with '- '"));
    EXPECT_THAT(folder_.about_expectations("  never: popup.open\n"),
                ElementsAre("a.walk.yaml:4:3: error wrong-type: 'expect' must be a list, not a map of keys"));
}

TEST_F(ReadExpectations, ComplainsOfEvents) {
    EXPECT_THAT(
        folder_.about_expectations("  - sequence: [popup.opne hut, popup.open a b, '']\n"),
        ElementsAre("a.walk.yaml:4:16: error unknown-name: no event is called 'popup.opne' (did you mean "
                    "'popup.open'?)",
                    "a.walk.yaml:4:32: error bad-value: an event is written KIND OBJECT, as in 'popup.open "
                    "library'; 'b' is too much",
                    "a.walk.yaml:4:48: error bad-value: an event must be one line of text and not empty"));
    EXPECT_THAT(folder_.about_expectations("  - never: jump.* hut\n"),
                ElementsAre(testing::StartsWith("a.walk.yaml:4:12: error unknown-name: no event is called "
                                                "'jump.*'; known here: walk.start, walk.end, ")));
    EXPECT_THAT(folder_.about_expectations("  - sequence: []\n  - never: [a]\n"),
                ElementsAre("a.walk.yaml:4:15: error bad-value: 'sequence' needs at least one event",
                            "a.walk.yaml:5:12: error wrong-type: 'never' must be a text, not a list"));
}

TEST_F(ReadExpectations, ComplainsOfCountsAndGoals) {
    EXPECT_THAT(
        folder_.about_expectations("  - count: {event: popup.open}\n  - count: {at_least: 1.5}\n"
                                   "  - count: {event: popup.open, at_least: 3, at_most: 2}\n  - count: 3\n"),
        ElementsAre("a.walk.yaml:4:12: error missing-key: 'count' needs one of equals, at_least, at_most",
                    "a.walk.yaml:5:12: error missing-key: 'count' needs the key 'event'",
                    "a.walk.yaml:5:23: error bad-value: 'at_least' must be a whole number, not '1.5'",
                    "a.walk.yaml:6:54: error bad-value: 'at_most' is less than 'at_least'",
                    "a.walk.yaml:7:12: error wrong-type: 'count' must be a map of keys, as in {key: value}"));
    EXPECT_THAT(folder_.about_expectations("  - reaches: nowhere\n  - reaches: {within: 0}\n"),
                ElementsAre("a.walk.yaml:4:14: error unknown-name: the campus has no place or spawn "
                            "'nowhere'; known here: square, gate",
                            "a.walk.yaml:5:14: error missing-key: 'reaches' needs the key 'place'",
                            "a.walk.yaml:5:23: error bad-value: 'within' must be more than 0 and at most "
                            "1000000 m, not '0'"));
}

}  // namespace
}  // namespace campuswalk::config

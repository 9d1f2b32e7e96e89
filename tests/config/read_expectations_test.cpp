#include "config/loader/walk/read_expectations.h"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/config/config_folder.h"
#include "tests/support/says.h"

namespace campuswalk::config {
namespace {

using namespace engine;
using support::says;
using testing::ElementsAre;

template <typename Expected>
Expected plain(const std::vector<Expectation>& all, std::size_t index) {
    return std::get<Expected>(std::get<PlainExpectation>(all.at(index)));
}

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
    const auto sequence = plain<ExpectSequence>(all, 0);
    ASSERT_EQ(sequence.events.size(), 2U);
    EXPECT_EQ(sequence.events[0].kind, "trigger.enter");
    EXPECT_EQ(sequence.events[0].object, "hut/door");
    EXPECT_EQ(sequence.events[1].kind, "popup.open");
    EXPECT_EQ(sequence.events[1].object, "*");
    EXPECT_EQ(sequence.mark.line, 4);
    EXPECT_EQ(sequence.mark.column, 15);
    const auto never = plain<ExpectNever>(all, 1);
    EXPECT_EQ(never.event.kind, "collision.*");
    EXPECT_EQ(never.event.object, "pond*");
}

TEST_F(ReadExpectations, ReadsCountsAndGoals) {
    const auto all = read(
        "  - count: {event: popup.open, equals: 0}\n"
        "  - count: {event: popup.open, at_least: 1, at_most: 4}\n"
        "  - reaches: square\n"
        "  - reaches: {place: [1, 2], within: 2}\n");
    EXPECT_EQ(plain<ExpectCount>(all, 0).times.equals, 0);
    EXPECT_FALSE(plain<ExpectCount>(all, 0).times.at_least);
    EXPECT_EQ(plain<ExpectCount>(all, 1).times.at_least, 1);
    EXPECT_EQ(plain<ExpectCount>(all, 1).times.at_most, 4);
    EXPECT_EQ(plain<ExpectReaches>(all, 2).target.point, Eigen::Vector3d(2, 0, -3));
    EXPECT_EQ(plain<ExpectReaches>(all, 2).within, 0.5);
    EXPECT_FALSE(plain<ExpectReaches>(all, 3).target.has_height);
    EXPECT_EQ(plain<ExpectReaches>(all, 3).within, 2.0);
}

TEST_F(ReadExpectations, RequiresOneKeyPerExpectation) {
    EXPECT_THAT(folder_.about_expectations("  - {}\n  - squence: [a]\n  - never: a\n    count: b\n"),
                ElementsAre(says("a.walk.yaml:4:5: error bad-value"),
                            says("a.walk.yaml:5:5: error unknown-key", {"'squence'", "'sequence'"}),
                            says("a.walk.yaml:6:5: error bad-value", {"'count'"})));
    EXPECT_THAT(folder_.about_expectations("  never: popup.open\n"),
                ElementsAre(says("a.walk.yaml:4:3: error wrong-type", {"'expect'"})));
}

TEST_F(ReadExpectations, DiagnosesEventPatterns) {
    EXPECT_THAT(folder_.about_expectations("  - sequence: [popup.opne hut, popup.open a b, '']\n"),
                ElementsAre(says("a.walk.yaml:4:16: error unknown-name", {"'popup.opne'", "'popup.open'"}),
                            says("a.walk.yaml:4:32: error bad-value", {"'b'"}),
                            says("a.walk.yaml:4:48: error bad-value")));
    EXPECT_THAT(folder_.about_expectations("  - never: jump.* hut\n"),
                ElementsAre(says("a.walk.yaml:4:12: error unknown-name", {"'jump.*'"})));
    EXPECT_THAT(folder_.about_expectations("  - sequence: []\n  - never: [a]\n"),
                ElementsAre(says("a.walk.yaml:4:15: error bad-value", {"'sequence'"}),
                            says("a.walk.yaml:5:12: error wrong-type", {"'never'"})));
}

TEST_F(ReadExpectations, DiagnosesCountsAndGoals) {
    EXPECT_THAT(
        folder_.about_expectations("  - count: {event: popup.open}\n  - count: {at_least: 1.5}\n"
                                   "  - count: {event: popup.open, at_least: 3, at_most: 2}\n  - count: 3\n"),
        ElementsAre(says("a.walk.yaml:4:12: error missing-key", {"'count'"}),
                    says("a.walk.yaml:5:12: error missing-key", {"'count'", "'event'"}),
                    says("a.walk.yaml:5:23: error bad-value", {"'at_least'", "'1.5'"}),
                    says("a.walk.yaml:6:54: error bad-value", {"'at_most'", "'at_least'"}),
                    says("a.walk.yaml:7:12: error wrong-type", {"'count'"})));
    EXPECT_THAT(folder_.about_expectations("  - reaches: nowhere\n  - reaches: {within: 0}\n"),
                ElementsAre(says("a.walk.yaml:4:14: error unknown-name", {"'nowhere'"}),
                            says("a.walk.yaml:5:14: error missing-key", {"'reaches'"}),
                            says("a.walk.yaml:5:23: error bad-value", {"'within'", "'0'"})));
}

TEST_F(ReadExpectations, ReadsWithin) {
    const auto within = plain<ExpectWithin>(
        read("  - within: {after: trigger.enter hut, event: popup.open hut, seconds: 2}\n"), 0);
    EXPECT_EQ(within.after.object, "hut");
    EXPECT_EQ(within.event.kind, "popup.open");
    EXPECT_EQ(within.seconds, 2.0);
    EXPECT_THAT(folder_.about_expectations("  - within: {after: popup.open}\n"),
                ElementsAre(says("a.walk.yaml:4:13: error missing-key", {"'within'", "'event'"}),
                            says("a.walk.yaml:4:13: error missing-key", {"'within'", "'seconds'"})));
}

TEST_F(ReadExpectations, ReadsPopups) {
    const auto all = read(
        "  - popup: hut\n"
        "  - popup: {building: \"h*\", title: \"H*\", body: \"*books*\", times: 2}\n"
        "  - popup: {building: hut, times: {at_most: 3}}\n");
    EXPECT_EQ(plain<ExpectPopup>(all, 0).building.glob, "hut");
    EXPECT_EQ(plain<ExpectPopup>(all, 0).times.at_least, 1);
    EXPECT_EQ(plain<ExpectPopup>(all, 1).title, "H*");
    EXPECT_EQ(plain<ExpectPopup>(all, 1).body, "*books*");
    EXPECT_EQ(plain<ExpectPopup>(all, 1).times.equals, 2);
    EXPECT_FALSE(plain<ExpectPopup>(all, 2).times.at_least) << "it need not open";
    EXPECT_EQ(plain<ExpectPopup>(all, 2).times.at_most, 3);
    EXPECT_THAT(folder_.about_expectations("  - popup: {title: a, times: {}}\n"),
                ElementsAre(says("a.walk.yaml:4:12: error missing-key", {"'popup'", "'building'"}),
                            says("a.walk.yaml:4:30: error missing-key", {"'times'"})));
}

TEST_F(ReadExpectations, ReadsVisits) {
    const auto all = read(
        "  - visits: hut\n  - visits: [hut, \"l*\"]\n  - visits: {ratio: 0.8}\n"
        "  - visits: {buildings: [hut], ratio: 0.5}\n");
    EXPECT_EQ(plain<ExpectVisits>(all, 0).buildings.at(0).glob, "hut");
    EXPECT_EQ(plain<ExpectVisits>(all, 0).ratio, 1.0);
    EXPECT_EQ(plain<ExpectVisits>(all, 1).buildings.size(), 2U);
    EXPECT_EQ(plain<ExpectVisits>(all, 2).buildings.at(0).glob, "*");
    EXPECT_EQ(plain<ExpectVisits>(all, 2).ratio, 0.8);
    EXPECT_EQ(plain<ExpectVisits>(all, 3).buildings.at(0).glob, "hut");
    EXPECT_THAT(folder_.about_expectations("  - visits: {}\n  - visits: []\n  - visits: {ratio: 80}\n"),
                ElementsAre(says("a.walk.yaml:4:13: error missing-key", {"'visits'"}),
                            says("a.walk.yaml:5:13: error bad-value", {"'visits'"}),
                            says("a.walk.yaml:6:21: error bad-value", {"'ratio'", "'80'"})));
}

TEST_F(ReadExpectations, ReadsNear) {
    const auto all = read(
        "  - near: square\n  - near: {place: square, within: 2, at: end}\n"
        "  - near: {place: [1, 2], at: avatar.stuck}\n");
    EXPECT_EQ(plain<ExpectNear>(all, 0).target.point, Eigen::Vector3d(2, 0, -3));
    EXPECT_EQ(plain<ExpectNear>(all, 0).within, 0.5);
    EXPECT_FALSE(plain<ExpectNear>(all, 1).at);
    EXPECT_EQ(plain<ExpectNear>(all, 1).within, 2.0);
    EXPECT_EQ(plain<ExpectNear>(all, 2).at->kind, "avatar.stuck");
    EXPECT_THAT(folder_.about_expectations("  - near: squre\n  - near: {place: gate, at: ende}\n"),
                ElementsAre(says("a.walk.yaml:4:11: error unknown-name", {"'squre'", "'square'"}),
                            says("a.walk.yaml:5:29: error unknown-name", {"'ende'"})));
}

TEST_F(ReadExpectations, ReadsDurationsAndDistances) {
    const auto all =
        read("  - duration: 12.5\n  - duration: {at_least: 1, at_most: 2}\n  - distance: {at_most: 9}\n");
    EXPECT_EQ(plain<ExpectDuration>(all, 0).seconds.equals, 12.5);
    EXPECT_EQ(plain<ExpectDuration>(all, 1).seconds.at_least, 1.0);
    EXPECT_EQ(plain<ExpectDuration>(all, 1).seconds.at_most, 2.0);
    EXPECT_EQ(plain<ExpectDistance>(all, 2).metres.at_most, 9.0);
    EXPECT_THAT(
        folder_.about_expectations("  - duration: {}\n  - distance: far\n  - duration: {at_lest: 1}\n"),
        ElementsAre(says("a.walk.yaml:4:15: error missing-key", {"'duration'"}),
                    says("a.walk.yaml:5:15: error wrong-type", {"'distance'", "'far'"}),
                    says("a.walk.yaml:6:15: error missing-key", {"'duration'"}),
                    says("a.walk.yaml:6:16: error unknown-key", {"'at_lest'", "'duration'", "'at_least'"})));
}

TEST_F(ReadExpectations, ReadsWhereOneCanWalk) {
    const auto all = read(
        "  - reachable: {from: [1, 2, 3], to: [4, 5]}\n"
        "  - route: {from: [0, 0], to: [1, 1], max_length: 5, min_width: 0.9, max_slope_deg: 45}\n"
        "  - route: {from: [0, 0], to: [1, 1]}\n");
    EXPECT_EQ(plain<ExpectReachable>(all, 0).from.point, Eigen::Vector3d(1, 2, 3));
    EXPECT_FALSE(plain<ExpectReachable>(all, 0).to.has_height);
    EXPECT_EQ(plain<ExpectRoute>(all, 1).max_length, 5.0);
    EXPECT_EQ(plain<ExpectRoute>(all, 1).min_width, 0.9);
    EXPECT_NEAR(plain<ExpectRoute>(all, 1).max_slope.value(), std::numbers::pi / 4, 1e-12);
    EXPECT_FALSE(plain<ExpectRoute>(all, 2).max_slope);
    EXPECT_THAT(
        folder_.about_expectations("  - reachable: {from: [0, 0]}\n  - route: {from: [0, 0], to: [1, 1], "
                                   "min_width: 4}\n"),
        ElementsAre(says("a.walk.yaml:4:16: error missing-key", {"'to'"}),
                    says("a.walk.yaml:5:50: error bad-value", {"'min_width'"})));
}

TEST_F(ReadExpectations, ReadsWhoCanWalkThere) {
    folder_.write("avatars/robot.avatar.yaml", "step_height: 0.1\nheight: 0.7\neye_height: 0.5\n");
    const auto all = read(
        "  - reachable: {from: gate, to: square}\n"
        "  - reachable: {from: gate, to: square, avatar: robot}\n"
        "  - route: {from: gate, to: square, avatar: {profile: robot, step_height: 0.2}}\n"
        "  - not: {reachable: {from: gate, to: square, avatar: robot}}\n");
    EXPECT_FALSE(plain<ExpectReachable>(all, 0).avatar);
    EXPECT_EQ(plain<ExpectReachable>(all, 1).avatar.value().step_height, 0.1);
    EXPECT_EQ(plain<ExpectRoute>(all, 2).avatar.value().step_height, 0.2);
    EXPECT_EQ(plain<ExpectRoute>(all, 2).avatar.value().height, 0.7);
    const auto& negated = std::get<ExpectNot>(all.at(3)).what;
    EXPECT_EQ(std::get<ExpectReachable>(negated).avatar.value().height, 0.7);
    EXPECT_THAT(folder_.about_expectations("  - reachable: {from: gate, to: square, avatar: robbot}\n"
                                           "  - route: {from: gate, to: square, avatar: {profile: robot, "
                                           "radius: 1, ignore_layers: hedges}}\n"
                                           "  - reachable: {from: gate, to: square, avatar: [robot]}\n"),
                ElementsAre(says("a.walk.yaml:4:49: error unknown-name", {"robbot", "'robot'"}),
                            says("a.walk.yaml:5:70: error bad-value", {"radius"}),
                            says("a.walk.yaml:5:88: error unknown-name", {"'hedges'"}),
                            says("a.walk.yaml:6:49: error wrong-type", {"'avatar'"})));
}

TEST_F(ReadExpectations, ReadsExpectationsWithAndWithoutAValue) {
    const auto all = read(
        "  - stuck\n  - stuck: {by: \"bench/*\"}\n  - fell\n  - fell:\n  - grounded\n  - grounded: always\n"
        "  - grounded: {ratio: 0.9}\n  - no_penetration\n  - no_penetration: {tolerance: 0.01}\n"
        "  - blocked_by: wall\n");
    EXPECT_EQ(plain<ExpectStuck>(all, 0).by.glob, "*");
    EXPECT_EQ(plain<ExpectStuck>(all, 0).mark.line, 4);
    EXPECT_EQ(plain<ExpectStuck>(all, 0).mark.column, 5);
    EXPECT_EQ(plain<ExpectStuck>(all, 1).by.glob, "bench/*");
    EXPECT_EQ(plain<ExpectFell>(all, 2).mark.line, 6);
    EXPECT_EQ(plain<ExpectFell>(all, 3).mark.line, 7);
    EXPECT_EQ(plain<ExpectGrounded>(all, 4).ratio, 1.0);
    EXPECT_EQ(plain<ExpectGrounded>(all, 5).ratio, 1.0);
    EXPECT_EQ(plain<ExpectGrounded>(all, 6).ratio, 0.9);
    EXPECT_EQ(plain<ExpectNoPenetration>(all, 7).tolerance, 1e-4);
    EXPECT_EQ(plain<ExpectNoPenetration>(all, 8).tolerance, 0.01);
    EXPECT_EQ(plain<ExpectBlockedBy>(all, 9).object.glob, "wall");
}

TEST_F(ReadExpectations, DiagnosesMissingAndWrongValues) {
    EXPECT_THAT(
        folder_.about_expectations("  - reaches\n  - grounded: never\n  - fell: far\n  - stuck: hut\n"),
        ElementsAre(says("a.walk.yaml:4:5: error wrong-type"),
                    says("a.walk.yaml:5:15: error bad-value", {"'grounded'", "'never'"}),
                    says("a.walk.yaml:6:11: error wrong-type", {"'fell'"}),
                    says("a.walk.yaml:7:12: error wrong-type", {"'stuck'"})));
}

TEST_F(ReadExpectations, ReadsNegations) {
    const auto all = read("  - not: fell\n  - not: {stuck: {by: hut}}\n  - not: {reaches: square}\n");
    EXPECT_TRUE(std::holds_alternative<ExpectFell>(std::get<ExpectNot>(all.at(0)).what));
    EXPECT_EQ(std::get<ExpectStuck>(std::get<ExpectNot>(all.at(1)).what).by.glob, "hut");
    EXPECT_TRUE(std::holds_alternative<ExpectReaches>(std::get<ExpectNot>(all.at(2)).what));
    EXPECT_THAT(folder_.about_expectations("  - not: {not: fell}\n  - not: stcuk\n"),
                ElementsAre(says("a.walk.yaml:4:11: error unknown-key", {"'not'"}),
                            says("a.walk.yaml:5:10: error wrong-type")));
}

TEST_F(ReadExpectations, ReadsAGoldenLog) {
    EXPECT_TRUE(std::get<ExpectLog>(read("  - log: {golden: true}\n").at(0)).golden);
    EXPECT_FALSE(std::get<ExpectLog>(read("  - log: {golden: false}\n").at(0)).golden);
    EXPECT_THAT(folder_.about_expectations("  - log: golden\n  - log: {}\n"),
                ElementsAre(says("a.walk.yaml:4:10: error wrong-type", {"'log'"}),
                            says("a.walk.yaml:5:10: error missing-key", {"'log'", "'golden'"})));
}

TEST_F(ReadExpectations, ReadsSnapshotsAndVisibility) {
    const auto all = read(
        "  - snapshot: desk\n"
        "  - snapshot: {name: desk, threshold: 0.1, max_diff_pixels: 7, max_diff_pixel_ratio: 0.5,\n"
        "               min_tile_ssim: 0.9, masks: [[1, 2, 3, 4], [5, 6, 7, 8]]}\n"
        "  - visible: {building: hut, in: desk}\n"
        "  - visible: {building: \"h*\", in: desk, min_pixels: 50, min_ratio: 0.25}\n"
        "  - not: {visible: {building: hut, in: desk}}\n");
    EXPECT_EQ(std::get<ExpectSnapshot>(all.at(0)).name, "desk");
    const ImageTolerance unchanged = changed({}, std::get<ExpectSnapshot>(all.at(0)).tolerance);
    EXPECT_EQ(unchanged.threshold, ImageTolerance().threshold);
    EXPECT_FALSE(unchanged.max_diff_pixels);
    ImageTolerance before;
    before.masks = {{0, 0, 9, 9}};
    const ImageTolerance tolerance = changed(before, std::get<ExpectSnapshot>(all.at(1)).tolerance);
    EXPECT_EQ(tolerance.threshold, 0.1);
    EXPECT_EQ(tolerance.max_diff_pixels, 7);
    EXPECT_EQ(tolerance.max_diff_pixel_ratio, 0.5);
    EXPECT_EQ(tolerance.min_tile_ssim, 0.9);
    ASSERT_EQ(tolerance.masks.size(), 3U);
    EXPECT_EQ(tolerance.masks[2].height, 8);
    const auto& bare = std::get<ExpectVisible>(all.at(2));
    EXPECT_EQ(bare.building.glob + " " + bare.snapshot, "hut desk");
    EXPECT_EQ(bare.min_pixels, 1);
    EXPECT_FALSE(bare.min_ratio || bare.negated);
    EXPECT_EQ(std::get<ExpectVisible>(all.at(3)).min_pixels, 50);
    EXPECT_EQ(std::get<ExpectVisible>(all.at(3)).min_ratio, 0.25);
    EXPECT_TRUE(std::get<ExpectVisible>(all.at(4)).negated);
}

TEST_F(ReadExpectations, DiagnosesSnapshotsAndVisibility) {
    EXPECT_THAT(folder_.about_expectations("  - snapshot: My Desk\n  - snapshot: {threshold: 2}\n"
                                           "  - snapshot: {name: desk, masks: [[1, 2, 3]]}\n"
                                           "  - visible: hut\n  - visible: {in: desk, min_pixels: -1}\n"
                                           "  - not: {snapshot: desk}\n"),
                ElementsAre(says("a.walk.yaml:4:15: error bad-value"),
                            says("a.walk.yaml:5:15: error missing-key", {"'snapshot'", "'name'"}),
                            says("a.walk.yaml:5:27: error bad-value", {"'threshold'"}),
                            says("a.walk.yaml:6:36: error bad-value"),
                            says("a.walk.yaml:7:14: error wrong-type", {"'visible'"}),
                            says("a.walk.yaml:8:14: error missing-key", {"'visible'", "'building'"}),
                            says("a.walk.yaml:8:37: error bad-value", {"'min_pixels'"}),
                            says("a.walk.yaml:9:11: error unknown-key", {"'snapshot'"})));
    EXPECT_THAT(folder_.about_steps("  - spawn: gate\n  - expect: {snapshot: desk}\n"
                                    "  - expect: {not: {visible: {building: hut, in: desk}}}\n"),
                ElementsAre(says("a.walk.yaml:4:24: error bad-value", {"'snapshot'", "'expect'"}),
                            says("a.walk.yaml:5:29: error bad-value", {"'visible'", "'expect'"})));
}

TEST_F(ReadExpectations, ReadsExpectationsInSteps) {
    EXPECT_THAT(folder_.about_steps("  - spawn: gate\n  - expect: stuck\n  - expect: {never: popup.open}\n"
                                    "  - expect:\n      - fell\n      - not: grounded\n"),
                ElementsAre());
    const std::vector<Step> steps = folder_.run().walk.steps;
    EXPECT_TRUE(std::holds_alternative<ExpectStuck>(
        std::get<PlainExpectation>(std::get<ExpectStep>(steps.at(1)).expectations.at(0))));
    EXPECT_EQ(std::get<ExpectStep>(steps.at(2)).mark.line, 5);
    EXPECT_EQ(std::get<ExpectStep>(steps.at(3)).expectations.size(), 2U);
    EXPECT_THAT(folder_.about_steps("  - spawn: gate\n  - expect: []\n  - expect: {log: {golden: true}}\n"),
                ElementsAre(says("a.walk.yaml:4:13: error bad-value", {"'expect'"}),
                            says("a.walk.yaml:5:19: error bad-value", {"'log'", "'expect'"})));
}

}  // namespace
}  // namespace campuswalk::config

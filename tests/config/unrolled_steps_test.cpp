// `repeat` and `include`: a walk's steps as one plain list, each with the mark of where it is written.

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "config/loader/read_steps.h"
#include "tests/config/steps_fixture.h"

namespace campuswalk::config {
namespace {

using namespace engine;
using testing::ElementsAre;

class UnrolledSteps : public test::StepsFixture {
protected:
    /// The seconds of all `wait` steps, in their order.
    static std::vector<double> waits(const std::vector<Step>& steps) {
        std::vector<double> seconds;
        for (const Step& step : steps) {
            if (const auto* wait = std::get_if<WaitStep>(&step)) {
                seconds.push_back(wait->seconds);
            }
        }
        return seconds;
    }
    static SourceMark mark_of(const Step& step) {
        return std::visit([](const auto& s) { return s.mark; }, step);
    }
};

TEST_F(UnrolledSteps, GoRoundByRound) {
    const auto steps = read(
        "  - spawn: gate\n"
        "  - repeat:\n"
        "      times: 2\n"
        "      steps:\n"
        "        - wait: 1\n"
        "        - repeat: {times: 3, steps: [{wait: 2}]}\n"
        "  - wait: 4\n");
    EXPECT_THAT(waits(steps), ElementsAre(1, 2, 2, 2, 1, 2, 2, 2, 4));
    EXPECT_EQ(mark_of(steps.at(1)).line, 7);
    EXPECT_EQ(mark_of(steps.at(5)).line, 7) << "in the second round too";
}

TEST_F(UnrolledSteps, DiagnoseRoundsOnce) {
    EXPECT_THAT(about("repeat: {times: 3, steps: [{wait: -1}]}"),
                ElementsAre("a.walk.yaml:4:39: error bad-value: 'wait' must be from 0 to 86400 s, not '-1'"));
    EXPECT_THAT(about("repeat: {times: 0, step: []}"),
                ElementsAre("a.walk.yaml:4:13: error missing-key: 'repeat' needs the key 'steps'",
                            "a.walk.yaml:4:21: error bad-value: 'times' must be from 1 to 100000, not '0'",
                            "a.walk.yaml:4:24: error unknown-key: unknown key 'step' in 'repeat' (did you "
                            "mean 'steps'?)"));
    EXPECT_THAT(about("repeat: {times: 2, steps: []}"),
                ElementsAre("a.walk.yaml:4:31: error bad-value: 'steps' needs at least one step"));
    EXPECT_THAT(about("repeat: {times: 2, steps: [{spawn: gate}]}"),
                ElementsAre("a.walk.yaml:4:40: error bad-value: 'spawn' can only be the first step; later it "
                            "is 'teleport'"));
    EXPECT_THAT(about("repeat: {times: 2, steps: [{snapshot: a}]}"),
                ElementsAre("a.walk.yaml:4:43: error bad-value: a snapshot can't stand in 'repeat': every "
                            "round would write the same picture"));
}

TEST_F(UnrolledSteps, AreNotEndless) {
    const std::string inner = "{repeat: {times: 400, steps: [{wait: 1}]}}";
    EXPECT_THAT(about("repeat: {times: 400, steps: [" + inner + "]}"),
                ElementsAre("a.walk.yaml:4:13: error too-many-steps: with 'repeat' and 'include' the walk "
                            "has more than 100000 steps"));
}

TEST_F(UnrolledSteps, AreReadFromTheFileThatIsNamed) {
    folder_.write("parts/lap.steps.yaml", "steps:\n  - wait: 1\n  - include: ../pause.steps.yaml\n");
    folder_.write("pause.steps.yaml", "steps: [{wait: 2}]\n");
    const auto steps = read(
        "  - spawn: gate\n"
        "  - include: parts/lap.steps.yaml\n"
        "  - repeat: {times: 2, steps: [{include: parts/lap.steps.yaml}]}\n");
    EXPECT_THAT(waits(steps), ElementsAre(1, 2, 1, 2, 1, 2));
    EXPECT_TRUE(mark_of(steps.at(1)).file.ends_with("parts/lap.steps.yaml"));
    EXPECT_EQ(mark_of(steps.at(1)).line, 2);
    EXPECT_TRUE(mark_of(steps.at(2)).file.ends_with("pause.steps.yaml"));
}

TEST_F(UnrolledSteps, DiagnoseAFileWhereItIsWrongAndOnce) {
    folder_.write("lap.steps.yaml", "steps:\n  - wait: long\n  - spawn: gate\nstep: 1\n");
    EXPECT_THAT(
        about("include: lap.steps.yaml\n  - include: lap.steps.yaml"),
        ElementsAre("lap.steps.yaml:2:11: error wrong-type: 'wait' must be a number, not 'long'",
                    "lap.steps.yaml:3:12: error bad-value: 'spawn' can only be the first step; later it is "
                    "'teleport'",
                    "lap.steps.yaml:4:1: error unknown-key: unknown key 'step' in a steps file (did you mean "
                    "'steps'?)"));
}

TEST_F(UnrolledSteps, DiagnoseTheFileItself) {
    EXPECT_THAT(about("include: lap.steps.yaml"),
                ElementsAre("a.walk.yaml:4:14: error missing-file: 'lap.steps.yaml': no such file; check the "
                            "path"));
    EXPECT_THAT(about("include: a.campus.yaml"),
                ElementsAre("a.walk.yaml:4:14: error file-name: 'a.campus.yaml' is not called "
                            "NAME.steps.yaml; name another file or rename this one"));
    EXPECT_THAT(about("include: [lap]"),
                ElementsAre("a.walk.yaml:4:14: error wrong-type: 'include' must be a text, not a list"));
}

TEST_F(UnrolledSteps, DoNotGoInCircles) {
    folder_.write("a.steps.yaml", "steps: [{include: b.steps.yaml}]\n");
    folder_.write("b.steps.yaml", "steps:\n  - wait: 1\n  - include: ./a.steps.yaml\n");
    EXPECT_THAT(about("include: a.steps.yaml"),
                ElementsAre("b.steps.yaml:3:14: error include-cycle: a.steps.yaml includes itself, by way of "
                            "this line"));
}

TEST_F(UnrolledSteps, DoNotGoTooDeep) {
    for (int i = 1; i <= 20; ++i) {
        folder_.write("s" + std::to_string(i) + ".steps.yaml",
                      "steps: [{include: s" + std::to_string(i + 1) + ".steps.yaml}]\n");
    }
    EXPECT_THAT(about("include: s1.steps.yaml"),
                ElementsAre("s16.steps.yaml:1:19: error include-depth: files include each other more than 16 "
                            "deep; put the steps into fewer files"));
}

TEST_F(UnrolledSteps, TakeAImageOfANameOnce) {
    folder_.write("lap.steps.yaml", "steps: [{snapshot: view}]\n");
    EXPECT_EQ(read("  - spawn: gate\n  - include: lap.steps.yaml\n").size(), 2U);
    EXPECT_THAT(about("snapshot: view\n  - include: lap.steps.yaml"),
                ElementsAre(testing::MatchesRegex("lap.steps.yaml:1:20: error duplicate-name: the snapshot "
                                                  "'view' stands on line 4 of .*a.walk.yaml already")));
}

}  // namespace
}  // namespace campuswalk::config

// `repeat` and `include`: a walk's steps as one plain list, each with the mark of where it is written.

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "config/loader/walk/read_steps.h"
#include "tests/config/steps_fixture.h"
#include "tests/support/says.h"

namespace campuswalk::config {
namespace {

using namespace engine;
using support::says;
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

TEST_F(UnrolledSteps, AreRepeatedRoundByRound) {
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

TEST_F(UnrolledSteps, AreDiagnosedOnceAndNotPerRound) {
    EXPECT_THAT(about("repeat: {times: 3, steps: [{wait: -1}]}"),
                ElementsAre(says("a.walk.yaml:4:39: error bad-value", {"'wait'", "'-1'"})));
    EXPECT_THAT(about("repeat: {times: 0, step: []}"),
                ElementsAre(says("a.walk.yaml:4:13: error missing-key", {"'repeat'", "'steps'"}),
                            says("a.walk.yaml:4:21: error bad-value", {"'times'", "'0'"}),
                            says("a.walk.yaml:4:24: error unknown-key", {"'step'", "'repeat'", "'steps'"})));
    EXPECT_THAT(about("repeat: {times: 2, steps: []}"),
                ElementsAre(says("a.walk.yaml:4:31: error bad-value", {"'steps'"})));
    EXPECT_THAT(about("repeat: {times: 2, steps: [{spawn: gate}]}"),
                ElementsAre(says("a.walk.yaml:4:40: error bad-value", {"'spawn'"})));
    EXPECT_THAT(about("repeat: {times: 2, steps: [{snapshot: a}]}"),
                ElementsAre(says("a.walk.yaml:4:43: error bad-value")));
}

TEST_F(UnrolledSteps, AreLimitedInNumber) {
    const std::string inner = "{repeat: {times: 400, steps: [{wait: 1}]}}";
    EXPECT_THAT(about("repeat: {times: 400, steps: [" + inner + "]}"),
                ElementsAre(says("a.walk.yaml:4:13: error too-many-steps", {"'repeat'"})));
}

TEST_F(UnrolledSteps, AreIncludedFromFiles) {
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

TEST_F(UnrolledSteps, DiagnoseAnIncludedFileOnceAtItsMistakes) {
    folder_.write("lap.steps.yaml", "steps:\n  - wait: long\n  - spawn: gate\nstep: 1\n");
    EXPECT_THAT(about("include: lap.steps.yaml\n  - include: lap.steps.yaml"),
                ElementsAre(says("lap.steps.yaml:2:11: error wrong-type", {"'wait'", "'long'"}),
                            says("lap.steps.yaml:3:12: error bad-value", {"'spawn'"}),
                            says("lap.steps.yaml:4:1: error unknown-key", {"'step'", "'steps'"})));
}

TEST_F(UnrolledSteps, DiagnoseMissingAndMisnamedFiles) {
    EXPECT_THAT(about("include: lap.steps.yaml"),
                ElementsAre(says("a.walk.yaml:4:14: error missing-file", {"'lap.steps.yaml'"})));
    EXPECT_THAT(about("include: a.campus.yaml"),
                ElementsAre(says("a.walk.yaml:4:14: error file-name", {"'a.campus.yaml'"})));
    EXPECT_THAT(about("include: [lap]"),
                ElementsAre(says("a.walk.yaml:4:14: error wrong-type", {"'include'"})));
}

TEST_F(UnrolledSteps, RefuseIncludeCycles) {
    folder_.write("a.steps.yaml", "steps: [{include: b.steps.yaml}]\n");
    folder_.write("b.steps.yaml", "steps:\n  - wait: 1\n  - include: ./a.steps.yaml\n");
    EXPECT_THAT(about("include: a.steps.yaml"), ElementsAre(says("b.steps.yaml:3:14: error include-cycle")));
}

TEST_F(UnrolledSteps, RefuseDeepIncludes) {
    for (int i = 1; i <= 20; ++i) {
        folder_.write("s" + std::to_string(i) + ".steps.yaml",
                      "steps: [{include: s" + std::to_string(i + 1) + ".steps.yaml}]\n");
    }
    EXPECT_THAT(about("include: s1.steps.yaml"),
                ElementsAre(says("s16.steps.yaml:1:19: error include-depth")));
}

TEST_F(UnrolledSteps, TakeOneSnapshotPerName) {
    folder_.write("lap.steps.yaml", "steps: [{snapshot: view}]\n");
    EXPECT_EQ(read("  - spawn: gate\n  - include: lap.steps.yaml\n").size(), 2U);
    EXPECT_THAT(about("snapshot: view\n  - include: lap.steps.yaml"),
                ElementsAre(says("lap.steps.yaml:1:20: error duplicate-name",
                                 {"'view'", " line 4 of ", "a.walk.yaml"})));
}

}  // namespace
}  // namespace campuswalk::config

#include "config/loader/read_walk.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/config/config_folder.h"

namespace campuswalk::config {
namespace {

using engine::SimSettings;
using testing::ElementsAre;
using testing::HasSubstr;

class ReadWalk : public testing::Test {
protected:
    test::Lines about_sim(const std::string& sim) {
        return folder_.about_walk("campus: a.campus.yaml\nsim: " + sim + "\nsteps: [{spawn: gate}]\n");
    }

    SimSettings sim(const std::string& text) {
        EXPECT_THAT(about_sim(text), ElementsAre());
        return folder_.run().walk.sim;
    }

    test::ConfigFolder folder_;
};

TEST_F(ReadWalk, ReadsTheSimulation) {
    const SimSettings settings = sim("{ticks_per_second: 120, stay_every: 0}");
    EXPECT_EQ(settings.ticks_per_second, 120);
    EXPECT_EQ(settings.stay_every, 0.0);
    EXPECT_EQ(sim("{}").ticks_per_second, 60);
    EXPECT_EQ(sim("{stay_every: 2.5}").stay_every, 2.5);
}

TEST_F(ReadWalk, WarnsOfASeed) {
    EXPECT_THAT(about_sim("{seed: 7}"), ElementsAre());
    const SharedRun run = RunLoader({}).load(folder_.path("a.walk.yaml"));
    ASSERT_EQ(run.warnings.size(), 1U);
    EXPECT_EQ(run.warnings.front().code, "deprecated");
    EXPECT_EQ(run.warnings.front().mark.line, 2);
    EXPECT_THAT(run.warnings.front().message, HasSubstr("'seed'"));
}

TEST_F(ReadWalk, DiagnosesTheSimulation) {
    EXPECT_THAT(
        about_sim("{ticks_per_second: 0, stay_every: -1, dt: 1}"),
        ElementsAre("a.walk.yaml:2:25: error bad-value: 'ticks_per_second' must be from 1 to 10000, not '0'",
                    "a.walk.yaml:2:40: error bad-value: 'stay_every' must be from 0 to 86400 s, not '-1'",
                    "a.walk.yaml:2:44: error unknown-key: unknown key 'dt' in 'sim'; known here: "
                    "ticks_per_second, stay_every, gaze_hold, seed"));
    EXPECT_THAT(
        about_sim("{ticks_per_second: 59.5, stay_every: .inf}"),
        ElementsAre(
            "a.walk.yaml:2:25: error bad-value: 'ticks_per_second' must be a whole number, not '59.5'",
            "a.walk.yaml:2:43: error bad-value: 'stay_every' must be finite, not '.inf'"));
    EXPECT_THAT(
        about_sim("60"),
        ElementsAre("a.walk.yaml:2:6: error wrong-type: 'sim' must be a map of keys, as in {key: value}"));
}

TEST_F(ReadWalk, DiagnosesTheFileAsAWhole) {
    EXPECT_THAT(folder_.about_walk("steps:\n"),
                ElementsAre("a.walk.yaml:1:1: error missing-key: a walk needs the key 'campus'",
                            "a.walk.yaml:1:1: error bad-value: 'steps' needs at least a spawn"));
    EXPECT_THAT(folder_.about_walk("campus: a.campus.yaml\n"),
                ElementsAre("a.walk.yaml:1:1: error missing-key: a walk needs the key 'steps'"));
    EXPECT_THAT(
        folder_.about_walk("campus: a.campus.yaml\nsteps: [{spawn: gate}]\nxpect: []\nfps: 60\n"),
        ElementsAre(
            "a.walk.yaml:3:1: error unknown-key: unknown key 'xpect' in a walk (did you mean 'expect'?)",
            "a.walk.yaml:4:1: error unknown-key: unknown key 'fps' in a walk; known here: campus, avatar, "
            "light, "
            "sim, status, tags, timeout, camera, steps, expect"));
}

}  // namespace
}  // namespace campuswalk::config

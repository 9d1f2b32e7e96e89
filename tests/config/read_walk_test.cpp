#include "config/loader/walk/read_walk.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/config/config_folder.h"
#include "tests/support/says.h"

namespace campuswalk::config {
namespace {

using engine::SimSettings;
using support::says;
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
    EXPECT_EQ(sim("{}").tree, collision::TreeKind::bvh8);
    EXPECT_EQ(sim("{tree: hybrid}").tree, collision::TreeKind::hybrid);
    EXPECT_EQ(sim("{tree: bvh8}").tree, collision::TreeKind::bvh8);
    EXPECT_THAT(about_sim("{tree: oak}"), ElementsAre(::testing::AllOf(::testing::HasSubstr("bad-value"),
                                                                       ::testing::HasSubstr("'tree'"))));
}

TEST_F(ReadWalk, DiagnosesTheSimulation) {
    EXPECT_THAT(about_sim("{ticks_per_second: 0, stay_every: -1, dt: 1}"),
                ElementsAre(says("a.walk.yaml:2:25: error bad-value", {"'ticks_per_second'", "'0'"}),
                            says("a.walk.yaml:2:40: error bad-value", {"'stay_every'", "'-1'"}),
                            says("a.walk.yaml:2:44: error unknown-key", {"'dt'"})));
    EXPECT_THAT(about_sim("{ticks_per_second: 59.5, stay_every: .inf}"),
                ElementsAre(says("a.walk.yaml:2:25: error bad-value", {"'ticks_per_second'", "'59.5'"}),
                            says("a.walk.yaml:2:43: error bad-value", {"'stay_every'", "'.inf'"})));
    EXPECT_THAT(about_sim("60"), ElementsAre(says("a.walk.yaml:2:6: error wrong-type", {"'sim'"})));
}

TEST_F(ReadWalk, DiagnosesMissingAndUnknownTopLevelKeys) {
    EXPECT_THAT(folder_.about_walk("steps:\n"),
                ElementsAre(says("a.walk.yaml:1:1: error missing-key", {"'campus'"}),
                            says("a.walk.yaml:1:1: error bad-value", {"'steps'"})));
    EXPECT_THAT(folder_.about_walk("campus: a.campus.yaml\n"),
                ElementsAre(says("a.walk.yaml:1:1: error missing-key", {"'steps'"})));
    EXPECT_THAT(folder_.about_walk("campus: a.campus.yaml\nsteps: [{spawn: gate}]\nxpect: []\nfps: 60\n"),
                ElementsAre(says("a.walk.yaml:3:1: error unknown-key", {"'xpect'", "'expect'"}),
                            says("a.walk.yaml:4:1: error unknown-key", {"'fps'"})));
}

}  // namespace
}  // namespace campuswalk::config

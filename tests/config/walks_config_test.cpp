#include "config/loader/walks_config.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/config/config_folder.h"
#include "tests/support/says.h"

namespace campuswalk::config {
namespace {

using support::says;
using testing::ElementsAre;

class ReadWalksConfig : public testing::Test {
protected:
    WalksConfig config(std::string_view text) {
        folder_.write("walks.config.yaml", text);
        return load_walks_config(folder_.path("walks.config.yaml"));
    }

    test::Lines about(std::string_view text) {
        test::Lines lines;
        for (scene::Diagnostic& diagnostic : test::diagnostics_of([&] { config(text); })) {
            EXPECT_EQ(std::filesystem::path(diagnostic.mark.file).filename(), "walks.config.yaml");
            diagnostic.mark.file.clear();
            lines.push_back(scene::to_string(diagnostic));
        }
        return lines;
    }

    engine::Walk walk_in(const WalksConfig& config, std::size_t project) {
        RunLoader loader({});
        return loader.load(folder_.path("a.walk.yaml"), config.projects.at(project).overrides).walk;
    }

    test::ConfigFolder folder_;
};

TEST_F(ReadWalksConfig, ReadsEveryKey) {
    const WalksConfig read = config(R"(
walks: [walks, more/one.walk.yaml]
output: results
reporters: [list, {junit: results/junit.xml}]
workers: 3
max_failures: 5
timeout: 120
kill_after: 30.5
forbid_only: true
strict: true
min_cases: 7
projects:
  young: {avatar: child, tags: [smoke, stairs], timeout: 10}
  grown-up: {campus: b.campus.yaml, spawn: gate, grep: "stairs|ramp", grep_invert: slow}
  as-is:
)");
    ASSERT_EQ(read.walks.size(), 2U);
    EXPECT_EQ(read.walks[0].path, folder_.path("walks"));
    EXPECT_EQ(read.walks[1].path, folder_.path("more/one.walk.yaml"));
    EXPECT_EQ(std::pair(read.walks[1].mark.line, read.walks[1].mark.column), std::pair(2, 16));
    EXPECT_EQ(read.output.value().path, folder_.path("results"));
    ASSERT_EQ(read.reporters.size(), 2U);
    EXPECT_EQ(read.reporters[0].name, "list");
    EXPECT_EQ(read.reporters[0].file, std::nullopt);
    EXPECT_EQ(read.reporters[1].name, "junit");
    EXPECT_EQ(read.reporters[1].file, folder_.path("results/junit.xml"));
    EXPECT_EQ(read.workers, 3);
    EXPECT_EQ(read.max_failures, 5);
    EXPECT_EQ(read.timeout, 120.0);
    EXPECT_EQ(read.kill_after, 30.5);
    EXPECT_TRUE(read.forbid_only);
    EXPECT_TRUE(read.strict);
    EXPECT_EQ(read.min_cases, 7);
}

TEST_F(ReadWalksConfig, ReadsProjectsInTheOrderOfTheirNames) {
    const WalksConfig read = config(
        "projects:\n  young: {avatar: child, tags: [smoke, stairs], timeout: 10}\n"
        "  grown-up: {spawn: gate, grep: \"stairs|ramp\", grep_invert: slow}\n  as-is:\n");
    ASSERT_EQ(read.projects.size(), 3U);
    EXPECT_EQ(read.projects[0].name, "as-is");
    EXPECT_FALSE(read.projects[0].overrides.avatar);
    EXPECT_EQ(read.projects[1].name, "grown-up");
    EXPECT_TRUE(read.projects[1].overrides.spawn);
    EXPECT_EQ(read.projects[1].grep.value().text, "stairs|ramp");
    EXPECT_EQ(read.projects[1].grep.value().mark.line, 3);
    EXPECT_EQ(read.projects[1].grep_invert.value().text, "slow");
    EXPECT_EQ(read.projects[2].name, "young");
    EXPECT_TRUE(read.projects[2].overrides.avatar);
    EXPECT_THAT(read.projects[2].tags, ElementsAre("smoke", "stairs"));
    EXPECT_EQ(read.projects[2].timeout, 10.0);
}

TEST_F(ReadWalksConfig, DiagnosesMistakesAtTheirPlaces) {
    EXPECT_THAT(about("workers: 0\nproject: {}\n"),
                ElementsAre(says(":1:10: error bad-value", {"'workers'", "'0'"}),
                            says(":2:1: error unknown-key", {"'project'", "'projects'"})));
    EXPECT_THAT(about("reporters: [{junit: a, tap: b}]\n"),
                ElementsAre(says(":1:13: error wrong-type", {"{NAME: FILE}"})));
    EXPECT_THAT(about("projects: {Big One: {avatr: adult}}\n").size(), 2U);
    EXPECT_THAT(about("timeout: 0\n"), ElementsAre(says(":1:10: error bad-value", {"'timeout'", "'0'"})));
}

TEST_F(ReadWalksConfig, ReplacesAWalksAvatarAndSpawn) {
    folder_.write("avatars/child.avatar.yaml", "height: 1.2\nradius: 0.2\neye_height: 1.1\n");
    const WalksConfig read = config(
        "projects:\n  a: {avatar: child}\n  b: {avatar: {profile: child, speed: 0.7}}\n"
        "  c: {spawn: {at: [1, 0, 2], yaw_deg: 180}}\n");
    EXPECT_EQ(walk_in(read, 0).avatar.height, 1.2);
    EXPECT_EQ(walk_in(read, 1).avatar.height, 1.2);
    EXPECT_EQ(walk_in(read, 1).avatar.speed, 0.7);
    const engine::Walk moved = walk_in(read, 2);
    const auto& spawn = std::get<engine::SpawnStep>(moved.steps.front());
    EXPECT_EQ(spawn.position, Eigen::Vector3d(1.0, 0.0, 2.0));
    EXPECT_EQ(moved.avatar.height, folder_.run().walk.avatar.height);
}

TEST_F(ReadWalksConfig, DiagnosesAProjectsValuesAtTheirPlaces) {
    const WalksConfig read =
        config("projects:\n  a: {avatar: chidl}\n  b: {spawn: gaet}\n  c: {campus: none.campus.yaml}\n");
    const std::vector<std::pair<int, int>> places = {{2, 15}, {3, 14}, {4, 15}};
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto found = test::diagnostics_of([&] { walk_in(read, i); });
        ASSERT_EQ(found.size(), 1U) << i;
        EXPECT_EQ(std::pair(found[0].mark.line, found[0].mark.column), places[i]);
        EXPECT_EQ(std::filesystem::path(found[0].mark.file).filename(), "walks.config.yaml");
    }
}

TEST_F(ReadWalksConfig, ReadsAWalkOnAnotherCampus) {
    // Everything of the other campus lies 100 m to the east.
    folder_.write("b.campus.yaml",
                  "scenes: [{file: a.obj}]\ncolliders: [{id: g, nodes: f, shape: mesh, mode: "
                  "solid}]\nspawns: {gate: {at: [100, 0, 0]}}\nplaces: {hall: [101, 0, 0]}\n");
    const WalksConfig read = config("projects: {east: {campus: b.campus.yaml}}\n");
    RunLoader loader({});
    folder_.write("a.walk.yaml", "campus: a.campus.yaml\nsteps: [{spawn: gate}]\n");
    const config::Run run = loader.load(folder_.path("a.walk.yaml"), read.projects[0].overrides);
    EXPECT_EQ(run.walk.campus_name, "b");
    EXPECT_EQ(std::get<engine::SpawnStep>(run.walk.steps.front()).position.x(), 100.0);
    EXPECT_EQ(loader.load(folder_.path("a.walk.yaml")).walk.campus_name, "a");
}

TEST_F(ReadWalksConfig, SharesACampusBetweenWalks) {
    RunLoader loader({});
    const config::Run first = loader.load(folder_.path("a.walk.yaml"));
    EXPECT_EQ(loader.load(folder_.path("a.walk.yaml")).campus, first.campus);
}

TEST_F(ReadWalksConfig, ReportsABrokenCampusForEveryWalk) {
    folder_.write("a.campus.yaml", "scenes: 3\n");
    RunLoader loader({});
    const auto load = [&] { loader.load(folder_.path("a.walk.yaml")); };
    const std::size_t once = test::diagnostics_of(load).size();
    EXPECT_GT(once, 0U);
    EXPECT_EQ(test::diagnostics_of(load).size(), once);
}

TEST_F(ReadWalksConfig, FindsTheFileInAParentFolder) {
    config("workers: 1\n");
    folder_.write("deep/er/a.txt", "");
    const auto found = find_walks_config(folder_.path("deep/er"));
    ASSERT_TRUE(found);
    EXPECT_TRUE(std::filesystem::equivalent(*found, folder_.path("walks.config.yaml")));
    EXPECT_EQ(find_walks_config("/proc"), std::nullopt);
}

}  // namespace
}  // namespace campuswalk::config

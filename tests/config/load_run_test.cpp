#include "config/loader/load_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/config/config_folder.h"
#include "tests/support/says.h"

namespace campuswalk::config {
namespace {

using support::says;
using testing::ElementsAre;

class LoadRun : public testing::Test {
protected:
    test::ConfigFolder folder_;
};

TEST_F(LoadRun, ResolvesTheFilesThatTheWalkNames) {
    folder_.write("walks/night_2.walk.yaml",
                  "campus: ../a.campus.yaml\n"
                  "avatar: {profile: adult, speed: 2, max_slope_deg: 45, ignore_layers: [trees]}\n"
                  "steps: [{spawn: gate}]\n");
    const config::Run run = load_run(folder_.path("walks/night_2.walk.yaml"),
                                     {.avatars = {}, .lights = {}, .roots = {folder_.path("")}});
    EXPECT_EQ(run.walk.name, "night_2");
    EXPECT_EQ(run.walk.campus_name, "a");
    EXPECT_EQ(run.campus->name, "a");
    EXPECT_TRUE(std::filesystem::equivalent(run.walk.campus, folder_.path("a.campus.yaml")));
    EXPECT_EQ(run.walk.avatar.height, 1.8);
    EXPECT_EQ(run.walk.avatar.speed, 2.0);
    EXPECT_THAT(run.walk.avatar.ignore_layers, ElementsAre("trees"));
    EXPECT_TRUE(run.walk.expectations.empty());
}

TEST_F(LoadRun, SearchesForAvatarsNearTheWalkFirst) {
    folder_.write("deep/er/a.walk.yaml",
                  "campus: ../../a.campus.yaml\navatar: robot\nsteps: [{spawn: gate}]\n");
    folder_.write("config/avatars/robot.avatar.yaml", "speed: 1\n");
    folder_.write("elsewhere/robot.avatar.yaml", "speed: 3\n");
    const auto speed = [&] {
        return load_run(folder_.path("deep/er/a.walk.yaml"),
                        {.avatars = {folder_.path("elsewhere")}, .lights = {}, .roots = {folder_.path("")}})
            .walk.avatar.speed;
    };
    EXPECT_EQ(speed(), 1.0);
    folder_.write("deep/avatars/robot.avatar.yaml", "speed: 2\n");
    EXPECT_EQ(speed(), 2.0);
    std::filesystem::remove(folder_.path("deep/avatars/robot.avatar.yaml"));
    std::filesystem::remove(folder_.path("config/avatars/robot.avatar.yaml"));
    EXPECT_EQ(speed(), 3.0);
}

TEST_F(LoadRun, ReportsAllMistakesInAllFilesAtOnceInOrder) {
    folder_.write("a.campus.yaml",
                  "scenes: [{file: a.obj, unit: inch}]\n"
                  "colliders:\n"
                  "  - {id: Groun., nodes: floor, shape: mesh, mode: solid, layer: grond}\n"
                  "spawns: {gate: {at: [0, 0, 0], yaw: 90}}\n"
                  "places: {square: [0, 0]}\n"
                  "layers: [ground]\n"
                  "colour: red\n");
    folder_.write("avatars/adult.avatar.yaml", "hight: 1.8\nspeed: fast\n");
    EXPECT_THAT(
        folder_.about_walk("steps:\n"
                           "  - spawn: gaet\n"
                           "  - walk_to: square\n"
                           "  - wait: long\n"
                           "expect: [{never: popup.opne}]\n"
                           "avatar: adult\n"
                           "campus: a.campus.yaml\n"
                           "simulation: {}\n"),
        ElementsAre(says("a.walk.yaml:2:12: error unknown-name", {"'gaet'", "'gate'"}),
                    says("a.walk.yaml:4:11: error wrong-type", {"'wait'", "'long'"}),
                    says("a.walk.yaml:5:18: error unknown-name", {"'popup.opne'", "'popup.open'"}),
                    says("a.walk.yaml:8:1: error unknown-key", {"'simulation'"}),
                    says("a.campus.yaml:1:30: error bad-value", {"'unit'", "'inch'"}),
                    says("a.campus.yaml:3:10: error bad-value", {"'id'", "'/'", "'Groun.'"}),
                    says("a.campus.yaml:3:65: error unknown-name", {"'grond'", "'layers'", "'ground'"}),
                    says("a.campus.yaml:4:32: error unknown-key", {"'yaw'"}),
                    says("a.campus.yaml:5:18: error wrong-type", {"'square'"}),
                    says("a.campus.yaml:7:1: error unknown-key", {"'colour'"}),
                    says("avatars/adult.avatar.yaml:1:1: error unknown-key", {"'hight'", "'height'"}),
                    says("avatars/adult.avatar.yaml:2:8: error wrong-type", {"'speed'", "'fast'"})));
}

TEST_F(LoadRun, FindsNamesOfAnyScriptHoweverTheyAreSpelled) {
    folder_.write(
        "a.campus.yaml",
        "scenes: [{file: a.obj}]\n"
        "buildings: [{id: 图文信息中心, title: Library}, {id: building_A, title: A}]\n"
        "colliders:\n"
        "  - {id: 图文信息中心/门, building: 图文信息中心, nodes: floor, shape: mesh, mode: trigger}\n"
        "spawns: {Bu\u0308ro: {at: [0, 0, 0]}}\n"
        "places: {p_1: [0, 0, 1]}\n");
    EXPECT_THAT(folder_.about_walk("steps:\n"
                                   "  - spawn: B\u00fcro\n"
                                   "  - walk_to: p_1\n"
                                   "expect: [{sequence: [trigger.enter 图文信息中心/门]}]\n"
                                   "avatar: adult\n"
                                   "campus: a.campus.yaml\n"),
                ElementsAre());
    folder_.write("a.campus.yaml",
                  "scenes: [{file: a.obj}]\n"
                  "colliders: [{id: a, nodes: floor, shape: mesh, mode: solid}]\n"
                  "spawns: {Bu\u0308ro: {at: [0, 0, 0]}, B\u00fcro: {at: [0, 0, 1]}}\n");
    EXPECT_THAT(folder_.about_walk("steps: [{spawn: B\u00fcro}]\navatar: adult\ncampus: a.campus.yaml\n"),
                ElementsAre(says("a.campus.yaml:3:40: error duplicate-name", {"spawn"})));
}

TEST_F(LoadRun, DoesNotCheckNamesWhenTheCampusCannotBeRead) {
    EXPECT_THAT(
        folder_.about_walk(
            "campus: none.campus.yaml\navatar: adult\nsteps: [{spawn: x}, {walk_to: y}, {wait: z}]\n"),
        ElementsAre(says("a.walk.yaml:1:9: error missing-file", {"'none.campus.yaml'"}),
                    says("a.walk.yaml:3:42: error wrong-type", {"'wait'", "'z'"})));
    folder_.write("a.campus.yaml", "scenes: [\n");
    EXPECT_THAT(folder_.about_walk("campus: a.campus.yaml\nsteps: [{spawn: x}]\n"),
                ElementsAre(says("a.campus.yaml:1:9: error yaml-syntax")));
}

TEST_F(LoadRun, DiagnosesTheCampusItNames) {
    const auto about = [&](const std::string& campus) {
        return folder_.about_walk("campus: " + campus + "\nsteps: [{spawn: gate}]\n");
    };
    EXPECT_THAT(about("avatars"), ElementsAre(says("a.walk.yaml:1:9: error missing-file", {"'avatars'"})));
    EXPECT_THAT(about("a.walk.yaml"),
                ElementsAre(says("a.walk.yaml:1:9: error file-name", {"'a.walk.yaml'"})));
    EXPECT_THAT(about("[a]"), ElementsAre(says("a.walk.yaml:1:9: error wrong-type", {"'campus'"})));
    EXPECT_THAT(about("''"), ElementsAre(says("a.walk.yaml:1:9: error bad-value", {"'campus'"})));
    folder_.write("empty.campus.yaml", "# nothing yet\n");
    EXPECT_THAT(about("empty.campus.yaml"), ElementsAre(says("empty.campus.yaml: error empty-file")));
    // NOLINTNEXTLINE(bugprone-string-constructor): so large
    folder_.write("big.campus.yaml", std::string(9'000'000, '\n'));
    EXPECT_THAT(about("big.campus.yaml"), ElementsAre(says("big.campus.yaml: error too-large")));
}

TEST_F(LoadRun, DiagnosesTheAvatarItNames) {
    const auto about = [&](const std::string& avatar) {
        return folder_.about_walk("campus: a.campus.yaml\navatar: " + avatar + "\nsteps: [{spawn: gate}]\n");
    };
    EXPECT_THAT(about("adlut"), ElementsAre(says("a.walk.yaml:2:9: error unknown-name", {"'adult'"})));
    EXPECT_THAT(about("../x"), ElementsAre(says("a.walk.yaml:2:9: error bad-value", {"'avatar'", "'../x'"})));
    EXPECT_THAT(about("[adult]"), ElementsAre(says("a.walk.yaml:2:9: error wrong-type", {"'avatar'"})));
    EXPECT_THAT(about(""), ElementsAre(says("a.walk.yaml:2:1: error wrong-type", {"'avatar'"})));
    EXPECT_THAT(
        about("{profil: adult}"),
        ElementsAre(says("a.walk.yaml:2:9: error missing-key", {"'avatar'", "'profile'"}),
                    says("a.walk.yaml:2:10: error unknown-key", {"'profil'", "'avatar'", "'profile'"})));
    EXPECT_THAT(about("{profile: adult, speed: 0, radius: 1, ignore_layers: [tres, Fo.]}"),
                ElementsAre(says("a.walk.yaml:2:33: error bad-value", {"'speed'", "'0'"}),
                            says("a.walk.yaml:2:44: error bad-value"),
                            says("a.walk.yaml:2:63: error unknown-name", {"'tres'", "'trees'"}),
                            says("a.walk.yaml:2:69: error bad-value", {"'Fo.'"})));
}

TEST_F(LoadRun, DiagnosesTheWalkFileItself) {
    const auto about = [&](const std::string& name) {
        const auto found = test::diagnostics_of([&] { load_run(folder_.path(name), {}); });
        return found.size() == 1 ? scene::to_string(found[0]) : "";
    };
    const auto start_of = [&](const std::string& name, const std::string& code) {
        return folder_.path(name).string() + ": error " + code;
    };
    EXPECT_THAT(about("none.walk.yaml"), says(start_of("none.walk.yaml", "missing-file")));
    EXPECT_THAT(about("none.txt"), says(start_of("none.txt", "missing-file")));
    EXPECT_THAT(about("avatars"), says(start_of("avatars", "missing-file")));
    EXPECT_THAT(about("a.campus.yaml"),
                says(start_of("a.campus.yaml", "file-name"), {"'a.campus.yaml'", "NAME.walk.yaml"}));
    for (const char* name : {".walk.yaml", "my tour.walk.yaml", "...walk.yaml"}) {
        folder_.write(name, "campus: a.campus.yaml\nsteps: [{spawn: gate}]\n");
        EXPECT_THAT(about(name),
                    says(start_of(name, "file-name"), {"'" + std::string(name) + "'", "NAME.walk.yaml"}));
    }
}

TEST_F(LoadRun, AcceptsByteOrderMarksAndWindowsLineEnds) {
    EXPECT_THAT(folder_.about_walk("\xEF\xBB\xBF"
                                   "campus: a.campus.yaml\r\nsteps:\r\n  - spawn: gate\r\n  - wait: x\r\n"),
                ElementsAre(says("a.walk.yaml:4:11: error wrong-type", {"'wait'", "'x'"})));
}

}  // namespace
}  // namespace campuswalk::config

#include "config/loader/load_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/config/config_folder.h"

namespace campuswalk::config {
namespace {

using testing::ElementsAre;

class LoadRun : public testing::Test {
protected:
    test::ConfigFolder folder_;
};

TEST_F(LoadRun, ResolvesWhatTheWalkNames) {
    folder_.write("walks/night_2.walk.yaml",
                  "campus: ../a.campus.yaml\n"
                  "avatar: {profile: adult, speed: 2, max_slope_deg: 45, ignore_layers: [trees]}\n"
                  "steps: [{spawn: gate}]\n");
    const config::Run run = load_run(folder_.path("walks/night_2.walk.yaml"), {});
    EXPECT_EQ(run.walk.name, "night_2");
    EXPECT_EQ(run.walk.campus_name, "a");
    EXPECT_EQ(run.campus.name, "a");
    EXPECT_TRUE(std::filesystem::equivalent(run.walk.campus, folder_.path("a.campus.yaml")));
    EXPECT_EQ(run.walk.avatar.height, 1.8);
    EXPECT_EQ(run.walk.avatar.speed, 2.0);
    EXPECT_THAT(run.walk.avatar.ignore_layers, ElementsAre("trees"));
    EXPECT_TRUE(run.walk.expectations.empty());
}

TEST_F(LoadRun, LooksForAvatarsNearTheWalkFirst) {
    folder_.write("deep/er/a.walk.yaml",
                  "campus: ../../a.campus.yaml\navatar: robot\nsteps: [{spawn: gate}]\n");
    folder_.write("config/avatars/robot.avatar.yaml", "speed: 1\n");
    folder_.write("elsewhere/robot.avatar.yaml", "speed: 3\n");
    const auto speed = [&] {
        return load_run(folder_.path("deep/er/a.walk.yaml"),
                        {.avatars = {folder_.path("elsewhere")}, .lights = {}})
            .walk.avatar.speed;
    };
    EXPECT_EQ(speed(), 1.0);
    folder_.write("deep/avatars/robot.avatar.yaml", "speed: 2\n");
    EXPECT_EQ(speed(), 2.0);
    std::filesystem::remove(folder_.path("deep/avatars/robot.avatar.yaml"));
    std::filesystem::remove(folder_.path("config/avatars/robot.avatar.yaml"));
    EXPECT_EQ(speed(), 3.0);
}

TEST_F(LoadRun, TellsAllMistakesOfAllFilesAtOnceAndInOrder) {
    folder_.write("a.campus.yaml",
                  "scenes: [{file: a.obj, unit: inch}]\n"
                  "colliders:\n"
                  "  - {id: Ground, nodes: floor, shape: mesh, mode: solid, layer: grond}\n"
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
        ElementsAre(
            "a.walk.yaml:2:12: error unknown-name: the campus has no spawn 'gaet' (did you mean 'gate'?)",
            "a.walk.yaml:4:11: error wrong-type: 'wait' must be a number, not 'long'",
            "a.walk.yaml:5:18: error unknown-name: no event is called 'popup.opne' (did you mean "
            "'popup.open'?)",
            "a.walk.yaml:8:1: error unknown-key: unknown key 'simulation' in a walk; known here: campus, "
            "avatar, light, sim, status, tags, timeout, camera, steps, expect",
            "a.campus.yaml:1:30: error bad-value: 'unit' must be one of m, cm, mm, in, ft, not 'inch'",
            "a.campus.yaml:3:10: error bad-value: 'id' must be small letters, digits and single hyphens, "
            "with '/' between words, as in library/door, not 'Ground'",
            "a.campus.yaml:3:65: error unknown-name: 'grond' is not in 'layers' (did you mean 'ground'?)",
            "a.campus.yaml:4:32: error unknown-key: unknown key 'yaw' in a spawn; known here: at, yaw_deg",
            "a.campus.yaml:5:18: error wrong-type: 'square' must be three numbers, as in [0, 1.5, -2]",
            "a.campus.yaml:7:1: error unknown-key: unknown key 'colour' in a campus; known here: scenes, "
            "origin, layers, buildings, colliders, spawns, places",
            "avatars/adult.avatar.yaml:1:1: error unknown-key: unknown key 'hight' in an avatar (did you "
            "mean 'height'?)",
            "avatars/adult.avatar.yaml:2:8: error wrong-type: 'speed' must be a number, not 'fast'"));
}

TEST_F(LoadRun, LeavesNamesAloneWhenTheCampusCannotBeRead) {
    EXPECT_THAT(
        folder_.about_walk(
            "campus: none.campus.yaml\navatar: adult\nsteps: [{spawn: x}, {walk_to: y}, {wait: z}]\n"),
        ElementsAre("a.walk.yaml:1:9: error missing-file: 'none.campus.yaml': no such file; check the path",
                    "a.walk.yaml:3:42: error wrong-type: 'wait' must be a number, not 'z'"));
    folder_.write("a.campus.yaml", "scenes: [\n");
    EXPECT_THAT(
        folder_.about_walk("campus: a.campus.yaml\nsteps: [{spawn: x}]\n"),
        ElementsAre(
            "a.campus.yaml:1:9: error yaml-syntax: this '[' has no ']', or a ',' is missing after it"));
}

TEST_F(LoadRun, DiagnosesTheCampusItNames) {
    const auto about = [&](const std::string& campus) {
        return folder_.about_walk("campus: " + campus + "\nsteps: [{spawn: gate}]\n");
    };
    EXPECT_THAT(
        about("avatars"),
        ElementsAre("a.walk.yaml:1:9: error missing-file: 'avatars': is a folder; name a file in it"));
    EXPECT_THAT(about("a.walk.yaml"),
                ElementsAre("a.walk.yaml:1:9: error file-name: 'a.walk.yaml' is not called NAME.campus.yaml; "
                            "name another file or rename this one"));
    EXPECT_THAT(about("[a]"),
                ElementsAre("a.walk.yaml:1:9: error wrong-type: 'campus' must be a text, not a list"));
    EXPECT_THAT(
        about("''"),
        ElementsAre("a.walk.yaml:1:9: error bad-value: 'campus' must be one line of text and not empty"));
    folder_.write("empty.campus.yaml", "# nothing yet\n");
    EXPECT_THAT(
        about("empty.campus.yaml"),
        ElementsAre(
            "empty.campus.yaml: error empty-file: there is nothing in this file but comments or spaces"));
    folder_.write("big.campus.yaml", std::string(5'000'000, '\n'));
    EXPECT_THAT(
        about("big.campus.yaml"),
        ElementsAre(
            "big.campus.yaml: error too-large: the file has 5000000 bytes; at most 2000000 are read"));
}

TEST_F(LoadRun, DiagnosesTheAvatarItNames) {
    const auto about = [&](const std::string& avatar) {
        return folder_.about_walk("campus: a.campus.yaml\navatar: " + avatar + "\nsteps: [{spawn: gate}]\n");
    };
    EXPECT_THAT(
        about("adlut"),
        ElementsAre(
            "a.walk.yaml:2:9: error unknown-name: there is no adlut.avatar.yaml in 'avatars' "
            "or 'config/avatars' beside the walk, above it or with the program (did you mean 'adult'?)"));
    EXPECT_THAT(about("../x"),
                ElementsAre("a.walk.yaml:2:9: error bad-value: 'avatar' must be small letters, digits and "
                            "single hyphens, as in main-gate, not '../x'"));
    EXPECT_THAT(
        about("[adult]"),
        ElementsAre(
            "a.walk.yaml:2:9: error wrong-type: 'avatar' must be a profile's name or {profile: NAME, …}"));
    EXPECT_THAT(
        about(""),
        ElementsAre(
            "a.walk.yaml:2:1: error wrong-type: 'avatar' must be a profile's name or {profile: NAME, …}"));
    EXPECT_THAT(about("{profil: adult}"),
                ElementsAre("a.walk.yaml:2:9: error missing-key: 'avatar' needs the key 'profile'",
                            "a.walk.yaml:2:10: error unknown-key: unknown key 'profil' in 'avatar' (did you "
                            "mean 'profile'?)"));
    EXPECT_THAT(
        about("{profile: adult, speed: 0, radius: 1, ignore_layers: [tres, Foo]}"),
        ElementsAre(
            "a.walk.yaml:2:33: error bad-value: 'speed' must be more than 0 and at most 100 m/s, not '0'",
            "a.walk.yaml:2:44: error bad-value: the body is a capsule: its height of 1.8 m must be at least "
            "twice its radius of 1 m",
            "a.walk.yaml:2:63: error unknown-name: the campus has no layer 'tres' (did you mean 'trees'?)",
            "a.walk.yaml:2:69: error bad-value: a layer must be small letters, digits and single hyphens, as "
            "in main-gate, not 'Foo'"));
}

TEST_F(LoadRun, DiagnosesTheWalkFileItself) {
    const auto about = [&](const std::string& name) {
        const auto found = test::diagnostics_of([&] { load_run(folder_.path(name), {}); });
        return found.size() == 1 ? found[0].code + ": " + found[0].message : "";
    };
    EXPECT_EQ(about("none.walk.yaml"), "missing-file: no such file; check the path");
    EXPECT_EQ(about("none.txt"), "missing-file: no such file; check the path");
    EXPECT_EQ(about("avatars"), "missing-file: is a folder; name a file in it");
    EXPECT_EQ(
        about("a.campus.yaml"),
        "file-name: 'a.campus.yaml' is not called NAME.walk.yaml; name another file or rename this one");
    folder_.write(".walk.yaml", "");
    EXPECT_EQ(about(".walk.yaml"),
              "file-name: '.walk.yaml' is not called NAME.walk.yaml; name another file or rename this one");
    folder_.write("my tour.walk.yaml", "campus: a.campus.yaml\nsteps: [{spawn: gate}]\n");
    EXPECT_EQ(about("my tour.walk.yaml"),
              "file-name: 'my tour.walk.yaml': rename the file; NAME.walk.yaml takes letters, digits, '-', "
              "'_' and, but for its start, '.'");
    folder_.write("...walk.yaml", "campus: a.campus.yaml\nsteps: [{spawn: gate}]\n");
    EXPECT_EQ(
        about("...walk.yaml"),
        "file-name: '...walk.yaml': rename the file; NAME.walk.yaml takes letters, digits, '-', '_' and, "
        "but for its start, '.'");
}

TEST_F(LoadRun, ReadsWindowsFiles) {
    EXPECT_THAT(folder_.about_walk("\xEF\xBB\xBF"
                                   "campus: a.campus.yaml\r\nsteps:\r\n  - spawn: gate\r\n  - wait: x\r\n"),
                ElementsAre("a.walk.yaml:4:11: error wrong-type: 'wait' must be a number, not 'x'"));
}

}  // namespace
}  // namespace campuswalk::config

#include "config/loader/read_avatar.h"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/config/config_folder.h"

namespace campuswalk::config {
namespace {

using engine::AvatarProfile;
using testing::ElementsAre;

constexpr double kDegree = std::numbers::pi / 180.0;

class ReadAvatar : public testing::Test {
protected:
    AvatarProfile read(std::string_view text) {
        folder_.write("an.avatar.yaml", text);
        return load_avatar(folder_.path("an.avatar.yaml"));
    }

    test::ConfigFolder folder_;
};

TEST_F(ReadAvatar, PutsEveryKeyWhereItBelongs) {
    const AvatarProfile avatar = read(R"(
height: 1.2
radius: 0.25
eye_height: 1.1
speed: 0.9
step_height: 0.2
max_slope_deg: 30
skin_width: 0.01
turn_speed_deg: 90
look_distance: 7
ignore_layers: [trees, glass-walls]
)");
    EXPECT_EQ(avatar.height, 1.2);
    EXPECT_EQ(avatar.radius, 0.25);
    EXPECT_EQ(avatar.eye_height, 1.1);
    EXPECT_EQ(avatar.speed, 0.9);
    EXPECT_EQ(avatar.step_height, 0.2);
    EXPECT_NEAR(avatar.max_slope, 30 * kDegree, 1e-15);
    EXPECT_EQ(avatar.skin_width, 0.01);
    EXPECT_NEAR(avatar.turn_speed, 90 * kDegree, 1e-15);
    EXPECT_EQ(avatar.look_distance, 7.0);
    EXPECT_THAT(avatar.ignore_layers, ElementsAre("trees", "glass-walls"));
}

TEST_F(ReadAvatar, LeavesTheRestAtItsDefault) {
    const AvatarProfile usual;
    const AvatarProfile avatar = read("speed: 2\nignore_layers: trees\n");
    EXPECT_EQ(avatar.speed, 2.0);
    EXPECT_EQ(avatar.height, usual.height);
    EXPECT_EQ(avatar.max_slope, usual.max_slope);
    EXPECT_THAT(avatar.ignore_layers, ElementsAre("trees"));
}

TEST_F(ReadAvatar, DiagnosesKeysAndNumbers) {
    EXPECT_THAT(folder_.about_avatar("heigth: 1\n"),
                ElementsAre("an.avatar.yaml:1:1: error unknown-key: unknown key 'heigth' in an avatar (did "
                            "you mean 'height'?)"));
    EXPECT_THAT(
        folder_.about_avatar("height: tall\nspeed: 101\nmax_slope_deg: 90\nskin_width: 0\n"
                             "turn_speed_deg: 0\nlook_distance: -1\neye_height: 0\nstep_height: -1\n"
                             "radius: 1e-9\n"),
        ElementsAre(
            "an.avatar.yaml:1:9: error wrong-type: 'height' must be a number, not 'tall'",
            "an.avatar.yaml:2:8: error bad-value: 'speed' must be more than 0 and at most 100 m/s, not '101'",
            "an.avatar.yaml:3:16: error bad-value: 'max_slope_deg' must be from 0 to 89 degrees, not '90'",
            "an.avatar.yaml:4:13: error bad-value: 'skin_width' must be from 0.001 to 0.5 m, not '0'",
            "an.avatar.yaml:5:17: error bad-value: 'turn_speed_deg' must be more than 0 and at most 36000 "
            "degrees per second, not '0'",
            "an.avatar.yaml:6:16: error bad-value: 'look_distance' must be from 0 to 10000 m, not '-1'",
            "an.avatar.yaml:7:13: error bad-value: 'eye_height' must be from 0.05 to 100 m, not '0'",
            "an.avatar.yaml:8:14: error bad-value: 'step_height' must be from 0 to 50 m, not '-1'",
            "an.avatar.yaml:9:9: error bad-value: 'radius' must be from 0.01 to 50 m, not '1e-9'"));
    EXPECT_THAT(
        folder_.about_avatar("ignore_layers: [Foo, {}]\n"),
        ElementsAre("an.avatar.yaml:1:17: error bad-value: a layer must be small letters, digits and single "
                    "hyphens, as in main-gate, not 'Foo'",
                    "an.avatar.yaml:1:22: error wrong-type: a layer must be a text, not a map of keys"));
}

TEST_F(ReadAvatar, DiagnosesBodiesThatCannotBe) {
    EXPECT_THAT(folder_.about_avatar("radius: 1\n"),
                ElementsAre("an.avatar.yaml:1:9: error bad-value: the body is a capsule: its height of 1.8 m "
                            "must be at least twice its radius of 1 m"));
    EXPECT_THAT(folder_.about_avatar("height: 1\n"),
                ElementsAre("an.avatar.yaml:1:9: error bad-value: 'eye_height' of 1.65 m must not be above "
                            "the height of 1 m"));
    EXPECT_THAT(folder_.about_avatar("step_height: 1\n"),
                ElementsAre("an.avatar.yaml:1:14: error bad-value: 'step_height' of 1 m must be at most half "
                            "the height of 1.8 m"));
}

}  // namespace
}  // namespace campuswalk::config

#include "config/loader/profile/read_avatar.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "config/loader/load_profile.h"
#include "tests/config/config_folder.h"
#include "tests/support/angles.h"
#include "tests/support/says.h"

namespace campuswalk::config {
namespace {

using engine::AvatarProfile;
using support::radians;
using support::says;
using testing::ElementsAre;

class ReadAvatar : public testing::Test {
protected:
    AvatarProfile read(std::string_view text) {
        folder_.write("an.avatar.yaml", text);
        return load_avatar(folder_.path("an.avatar.yaml"));
    }

    test::ConfigFolder folder_;
};

TEST_F(ReadAvatar, ReadsEveryKey) {
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
    EXPECT_NEAR(avatar.max_slope, radians(30), 1e-15);
    EXPECT_EQ(avatar.skin_width, 0.01);
    EXPECT_NEAR(avatar.turn_speed, radians(90), 1e-15);
    EXPECT_EQ(avatar.look_distance, 7.0);
    EXPECT_THAT(avatar.ignore_layers, ElementsAre("trees", "glass-walls"));
}

TEST_F(ReadAvatar, LeavesOtherKeysAtTheirDefaults) {
    const AvatarProfile defaults;
    const AvatarProfile avatar = read("speed: 2\nignore_layers: trees\n");
    EXPECT_EQ(avatar.speed, 2.0);
    EXPECT_EQ(avatar.height, defaults.height);
    EXPECT_EQ(avatar.max_slope, defaults.max_slope);
    EXPECT_THAT(avatar.ignore_layers, ElementsAre("trees"));
}

TEST_F(ReadAvatar, DiagnosesKeysAndNumbers) {
    EXPECT_THAT(folder_.about_avatar("heigth: 1\n"),
                ElementsAre(says("an.avatar.yaml:1:1: error unknown-key", {"'heigth'", "'height'"})));
    EXPECT_THAT(folder_.about_avatar("height: tall\nspeed: 101\nmax_slope_deg: 90\nskin_width: 0\n"
                                     "turn_speed_deg: 0\nlook_distance: -1\neye_height: 0\nstep_height: -1\n"
                                     "radius: 1e-9\n"),
                ElementsAre(says("an.avatar.yaml:1:9: error wrong-type", {"'height'", "'tall'"}),
                            says("an.avatar.yaml:2:8: error bad-value", {"'speed'", "'101'"}),
                            says("an.avatar.yaml:3:16: error bad-value", {"'max_slope_deg'", "'90'"}),
                            says("an.avatar.yaml:4:13: error bad-value", {"'skin_width'", "'0'"}),
                            says("an.avatar.yaml:5:17: error bad-value", {"'turn_speed_deg'", "'0'"}),
                            says("an.avatar.yaml:6:16: error bad-value", {"'look_distance'", "'-1'"}),
                            says("an.avatar.yaml:7:13: error bad-value", {"'eye_height'", "'0'"}),
                            says("an.avatar.yaml:8:14: error bad-value", {"'step_height'", "'-1'"}),
                            says("an.avatar.yaml:9:9: error bad-value", {"'radius'", "'1e-9'"})));
    EXPECT_THAT(folder_.about_avatar("ignore_layers: [Fo., {}]\n"),
                ElementsAre(says("an.avatar.yaml:1:17: error bad-value", {"'Fo.'"}),
                            says("an.avatar.yaml:1:22: error wrong-type")));
}

TEST_F(ReadAvatar, DiagnosesImpossibleBodies) {
    EXPECT_THAT(folder_.about_avatar("radius: 1\n"),
                ElementsAre(says("an.avatar.yaml:1:9: error bad-value")));
    EXPECT_THAT(folder_.about_avatar("height: 1\n"),
                ElementsAre(says("an.avatar.yaml:1:9: error bad-value", {"'eye_height'"})));
    EXPECT_THAT(folder_.about_avatar("step_height: 1\n"),
                ElementsAre(says("an.avatar.yaml:1:14: error bad-value", {"'step_height'"})));
}

}  // namespace
}  // namespace campuswalk::config

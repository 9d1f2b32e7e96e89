#include "config/loader/profile/read_light.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/config/config_folder.h"
#include "tests/support/angles.h"
#include "tests/support/says.h"

namespace campuswalk::config {
namespace {

using engine::AntiAliasing;
using engine::LightSettings;
using support::radians;
using support::says;
using testing::ElementsAre;

class ReadLight : public testing::Test {
protected:
    ReadLight() {
        folder_.write("lights/dusk.light.yaml",
                      "sun: {azimuth_deg: 250, elevation_deg: 5, color: [1, 0.5, 0.2], disc: 2}\n"
                      "sky: {zenith: [0, 0.1, 0.3], horizon: [0.6, 0.3, 0.1], light: [0.1, 0.1, 0.2]}\n"
                      "ground_light: [0.1, 0, 0]\n"
                      "room_light: [0.3, 0.2, 0.1]\n"
                      "glow: 12.5\n"
                      "fog_distance: 300\n"
                      "shadows: false\n"
                      "contact_shading: 0\n"
                      "anti_aliasing: fxaa\n");
    }

    LightSettings light_of(const std::string& value) const {
        EXPECT_THAT(about(value), ElementsAre());
        return folder_.run().walk.light;
    }
    test::Lines about(const std::string& value) const {
        return folder_.about_walk("campus: a.campus.yaml\nlight: " + value + "\nsteps: [{spawn: gate}]\n");
    }

    test::ConfigFolder folder_;
};

TEST_F(ReadLight, ReadsEveryKey) {
    const LightSettings light = light_of("dusk");
    EXPECT_NEAR(*light.sun_azimuth, radians(250), 1e-12);
    EXPECT_NEAR(*light.sun_elevation, radians(5), 1e-12);
    EXPECT_EQ(light.sun_color, Eigen::Vector3d(1, 0.5, 0.2));
    EXPECT_EQ(light.sun_disc, 2.0);
    EXPECT_EQ(light.zenith_color, Eigen::Vector3d(0, 0.1, 0.3));
    EXPECT_EQ(light.horizon_color, Eigen::Vector3d(0.6, 0.3, 0.1));
    EXPECT_EQ(light.sky_light, Eigen::Vector3d(0.1, 0.1, 0.2));
    EXPECT_EQ(light.ground_light, Eigen::Vector3d(0.1, 0, 0));
    EXPECT_EQ(light.room_light, Eigen::Vector3d(0.3, 0.2, 0.1));
    EXPECT_EQ(light.glow, 12.5);
    EXPECT_EQ(light.fog_distance, 300.0);
    EXPECT_EQ(light.shadows, false);
    EXPECT_EQ(light.ambient_occlusion, 0.0);
    EXPECT_EQ(light.anti_aliasing, AntiAliasing::fxaa);
}

TEST_F(ReadLight, LetsAWalkOverrideAProfileOrTheDay) {
    const LightSettings light = light_of("{profile: dusk, shadows: true, sun: {disc: 0}}");
    EXPECT_EQ(light.shadows, true);
    EXPECT_EQ(light.sun_disc, 0.0);
    EXPECT_EQ(light.fog_distance, 300.0);
    const LightSettings day = light_of("{anti_aliasing: none}");
    EXPECT_EQ(day.anti_aliasing, AntiAliasing::none);
    EXPECT_FALSE(day.shadows);
}

TEST_F(ReadLight, DiagnosesBadValues) {
    EXPECT_THAT(about("dsuk"),
                ElementsAre(says("a.walk.yaml:2:8: error unknown-name", {"'lights'", "'dusk'"})));
    EXPECT_THAT(about("[dusk]"), ElementsAre(says("a.walk.yaml:2:8: error wrong-type", {"'light'"})));
    EXPECT_THAT(
        about("{sun: {elevation_deg: 0, color: [1, 1]}, sky: {zenith: [0, -1, 0]}, anti_aliasing: best}"),
        ElementsAre(says("a.walk.yaml:2:30: error bad-value", {"'elevation_deg'", "'0'"}),
                    says("a.walk.yaml:2:40: error wrong-type", {"'color'"}),
                    says("a.walk.yaml:2:67: error bad-value", {"'zenith'", "'-1'"}),
                    says("a.walk.yaml:2:91: error bad-value", {"'anti_aliasing'", "'best'"})));
    folder_.write("lights/dusk.light.yaml", "sun: {colour: [1, 1, 1]}\n");
    EXPECT_THAT(about("dusk"), ElementsAre(says("lights/dusk.light.yaml:1:7: error unknown-key",
                                                {"'colour'", "'sun'", "'color'"})));
}

}  // namespace
}  // namespace campuswalk::config

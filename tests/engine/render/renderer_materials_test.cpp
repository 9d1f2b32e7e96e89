#include <span>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "engine/render/renderer.h"
#include "tests/engine/render/color_names.h"
#include "tests/engine/render/small_scenes.h"

// How surfaces look by their materials: glTF 2.0's conventions.
namespace campuswalk::engine::render::test {
namespace {

Picture drawn(const scene::Model& model) {
    Renderer renderer(std::span(&model, 1), quick_settings());
    return renderer.draw(ahead(), kWidth, kHeight);
}

// At 1.6 m a sheet of 1 m is 48 pixels high; blocks of it are read 12 pixels from its middle.
constexpr double kAway = -1.6;
constexpr int kReach = 12;

TEST(Materials, TextureOriginIsTheUpperLeftCorner) {
    const Picture picture =
        drawn(SceneBuilder().paint({1, 1, 1, 1}, four_blocks()).upright({0, 0, kAway}, 1.0).model());
    EXPECT_EQ(color_name(picture, 80 - kReach, 45 - kReach), "red");
    EXPECT_EQ(color_name(picture, 80 + kReach, 45 - kReach), "green");
    EXPECT_EQ(color_name(picture, 80 - kReach, 45 + kReach), "blue");
    EXPECT_EQ(color_name(picture, 80 + kReach, 45 + kReach), "yellow");
}

TEST(Materials, BaseColorMultipliesTheTexture) {
    // Red paint lets through only the red of the blocks.
    const Picture picture =
        drawn(SceneBuilder().paint({1, 0, 0, 1}, four_blocks()).upright({0, 0, kAway}, 1.0).model());
    EXPECT_EQ(color_name(picture, 80 - kReach, 45 - kReach), "red");
    EXPECT_EQ(color_name(picture, 80 + kReach, 45 + kReach), "red");
    EXPECT_LT(brightness(picture, 80 + kReach, 45 - kReach), 30.0) << "green paint under red";
}

TEST(Materials, TextureColorsAreSrgb) {
    // Half the byte value is a fifth of the light. Lit by nothing but its own texture's share of white light,
    // a sheet of 128 next to one of 255 must come out near 128 / 255, not near its square root.
    scene::Texture half = four_blocks();
    scene::Texture full = half;
    for (std::size_t i = 0; i < half.rgba.size(); ++i) {
        half.rgba[i] = i % 4 == 3 ? 255 : 128;
        full.rgba[i] = 255;
    }
    RenderSettings settings = quick_settings();
    settings.fog_distance = 0.0;
    settings.sun_color.setZero();
    settings.sky_light = settings.ground_light =
        Eigen::Vector3d::Constant(0.6);  // under the tone curve's knee
    settings.side_light = 0.0;
    settings.room_light.setZero();
    const scene::Model model = SceneBuilder()
                                   .paint({1, 1, 1, 1}, half)
                                   .upright({-0.5, 0, kAway}, 1.0)
                                   .paint({1, 1, 1, 1}, full)
                                   .upright({0.5, 0, kAway}, 1.0)
                                   .model();
    Renderer renderer(std::span(&model, 1), settings);
    const Picture picture = renderer.draw(ahead(), kWidth, kHeight);
    const double ratio = brightness(picture, 70, 45) / brightness(picture, 90, 45);
    EXPECT_NEAR(ratio, 128.0 / 255.0, 0.03);
}

TEST(Materials, MaskCutsHolesAndKeepsTheRest) {
    const Picture picture = drawn(SceneBuilder()
                                      .paint(kBlue)
                                      .upright({0, 0, -6}, 8.0)
                                      .paint(kRed, half_clear())
                                      .alpha(scene::AlphaMode::mask)
                                      .upright({0, 0, kAway}, 1.0)
                                      .model());
    EXPECT_EQ(color_name(picture, 80 - kReach, 45), "blue") << "through the hole";
    EXPECT_EQ(color_name(picture, 80 + kReach, 45), "red");
}

TEST(Materials, OpaqueIgnoresAlpha) {
    const Picture picture = drawn(SceneBuilder()
                                      .paint(kBlue)
                                      .upright({0, 0, -6}, 8.0)
                                      .paint(kRed, half_clear())
                                      .upright({0, 0, kAway}, 1.0)
                                      .model());
    EXPECT_EQ(color_name(picture, 80 - kReach, 45), "red");
}

TEST(Materials, BlendShowsWhatIsBehindInEitherOrderOfTheFile) {
    const auto pane = [](SceneBuilder& scene, double z, const Color& color) {
        scene.paint({color[0], color[1], color[2], 0.5F})
            .alpha(scene::AlphaMode::blend)
            .upright({0, 0, z}, 1.0);
    };
    const auto picture_of = [&](bool near_first) {
        SceneBuilder scene;
        scene.paint(kGrey).upright({0, 0, -6}, 8.0);
        pane(scene, near_first ? kAway : kAway - 0.5, near_first ? kRed : kBlue);
        pane(scene, near_first ? kAway - 0.5 : kAway, near_first ? kBlue : kRed);
        return drawn(scene.model());
    };
    const Picture near_first = picture_of(true);
    const Picture far_first = picture_of(false);
    const auto [r, g, b] = near_first.pixel(80, 45);
    EXPECT_GT(r, b) << "the nearer pane counts more";
    EXPECT_GT(b, g) << "but the farther one shows through";
    EXPECT_EQ(near_first.rgba, far_first.rgba) << "sorted by distance, not by file order";
}

TEST(Materials, BackFacesAreDrawnOnlyWhenDoubleSided) {
    const auto picture_from_behind = [](bool both_sides) {
        Eigen::Matrix4d turned = Eigen::Matrix4d::Identity();
        turned.topLeftCorner<3, 3>() =
            Eigen::AngleAxisd(3.141592653589793, Eigen::Vector3d::UnitY()).toRotationMatrix();
        turned(2, 3) = kAway;
        SceneBuilder scene;
        scene.paint(kBlue).upright({0, 0, -6}, 8.0).paint(kRed);
        if (both_sides) {
            scene.double_sided();
        }
        return drawn(scene.placed(turned).upright({0, 0, 0}, 1.0).model());
    };
    EXPECT_EQ(color_name(picture_from_behind(false), 80, 45), "blue");
    EXPECT_EQ(color_name(picture_from_behind(true), 80, 45), "red");
}

TEST(Materials, MirroredNodesKeepTheirOutsideOutside) {
    Eigen::Matrix4d mirrored = Eigen::Matrix4d::Identity();
    mirrored(0, 0) = -1.0;
    const Picture picture = drawn(SceneBuilder()
                                      .paint({1, 1, 1, 1}, four_blocks())
                                      .placed(mirrored)
                                      .upright({0, 0, kAway}, 1.0)
                                      .model());
    EXPECT_EQ(color_name(picture, 80 + kReach, 45 - kReach), "red") << "visible, and left for right";
    EXPECT_EQ(color_name(picture, 80 - kReach, 45 - kReach), "green");
}

TEST(Materials, EmissiveShinesWithoutLight) {
    RenderSettings settings = quick_settings();
    settings.sun_color.setZero();
    settings.sky_light.setZero();
    settings.ground_light.setZero();
    settings.room_light.setZero();
    const scene::Model model =
        SceneBuilder().paint(kBlue).glow({0.6F, 0, 0}).upright({0, 0, kAway}, 1.0).model();
    Renderer renderer(std::span(&model, 1), settings);
    EXPECT_EQ(color_name(renderer.draw(ahead(), kWidth, kHeight), 80, 45), "red");
}

}  // namespace
}  // namespace campuswalk::engine::render::test

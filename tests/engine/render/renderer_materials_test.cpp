#include <cmath>
#include <cstdlib>
#include <span>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "engine/render/renderer.h"
#include "tests/engine/render/color_names.h"
#include "tests/engine/render/small_scenes.h"

// Materials by the conventions of glTF 2.0.
namespace campuswalk::engine::render::test {
namespace {

Image drawn(const scene::Model& model) {
    Renderer renderer(std::span(&model, 1), quick_settings());
    return renderer.draw(ahead(), kWidth, kHeight);
}

// At 1.6 m a sheet of 1 m is 48 pixels high; its blocks are read 12 pixels from its middle.
constexpr double kAway = -1.6;
constexpr int kReach = 12;

TEST(Materials, TextureOriginIsAtTheUpperLeft) {
    const Image image =
        drawn(SceneBuilder().colored({1, 1, 1, 1}, four_blocks()).upright({0, 0, kAway}, 1.0).model());
    EXPECT_EQ(color_name(image, 80 - kReach, 45 - kReach), "red");
    EXPECT_EQ(color_name(image, 80 + kReach, 45 - kReach), "green");
    EXPECT_EQ(color_name(image, 80 - kReach, 45 + kReach), "blue");
    EXPECT_EQ(color_name(image, 80 + kReach, 45 + kReach), "yellow");
}

TEST(Materials, BaseColorMultipliesTheTexture) {
    // A red base colour keeps only the red of the texture.
    const Image image =
        drawn(SceneBuilder().colored({1, 0, 0, 1}, four_blocks()).upright({0, 0, kAway}, 1.0).model());
    EXPECT_EQ(color_name(image, 80 - kReach, 45 - kReach), "red");
    EXPECT_EQ(color_name(image, 80 + kReach, 45 + kReach), "red");
    EXPECT_LT(brightness(image, 80 + kReach, 45 - kReach), 30.0) << "a green texel with a red base colour";
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
                                   .colored({1, 1, 1, 1}, half)
                                   .upright({-0.5, 0, kAway}, 1.0)
                                   .colored({1, 1, 1, 1}, full)
                                   .upright({0.5, 0, kAway}, 1.0)
                                   .model();
    Renderer renderer(std::span(&model, 1), settings);
    const Image image = renderer.draw(ahead(), kWidth, kHeight);
    const double ratio = brightness(image, 70, 45) / brightness(image, 90, 45);
    EXPECT_NEAR(ratio, 128.0 / 255.0, 0.03);
}

TEST(Materials, MinifiedTexturesKeepTheirLinearBrightness) {
    // 64 columns of black and white on some ten pixels: half of the light, 188 of 255 in sRGB, and not 128.
    scene::Texture stripes;
    stripes.width = stripes.height = 64;
    for (int i = 0; i < 64 * 64; ++i) {
        const std::uint8_t value = i % 2 == 0 ? 0 : 255;
        for (const std::uint8_t channel : {value, value, value, std::uint8_t{255}}) {
            stripes.rgba.push_back(channel);
        }
    }
    SceneBuilder scene;
    scene.colored({1, 1, 1, 1}, stripes).upright({0, 0, -8.0}, 1.0);
    scene.material().unlit = true;
    RenderSettings settings = quick_settings();
    settings.fog_distance = 0.0;
    const scene::Model model = scene.model();
    Renderer renderer(std::span(&model, 1), settings);
    EXPECT_NEAR(renderer.draw(ahead(), kWidth, kHeight).pixel(80, 45)[0], 188, 4);
}

TEST(Materials, MaskCutsHolesAndKeepsTheRest) {
    const Image image = drawn(SceneBuilder()
                                  .colored(kBlue)
                                  .upright({0, 0, -6}, 8.0)
                                  .colored(kRed, half_clear())
                                  .alpha(scene::AlphaMode::mask)
                                  .upright({0, 0, kAway}, 1.0)
                                  .model());
    EXPECT_EQ(color_name(image, 80 - kReach, 45), "blue") << "through the hole";
    EXPECT_EQ(color_name(image, 80 + kReach, 45), "red");
}

TEST(Materials, OpaqueIgnoresAlpha) {
    const Image image = drawn(SceneBuilder()
                                  .colored(kBlue)
                                  .upright({0, 0, -6}, 8.0)
                                  .colored(kRed, half_clear())
                                  .upright({0, 0, kAway}, 1.0)
                                  .model());
    EXPECT_EQ(color_name(image, 80 - kReach, 45), "red");
}

TEST(Materials, BlendIsIndependentOfFileOrder) {
    const auto pane = [](SceneBuilder& scene, double z, const Color& color) {
        scene.colored({color[0], color[1], color[2], 0.5F})
            .alpha(scene::AlphaMode::blend)
            .upright({0, 0, z}, 1.0);
    };
    const auto image_of = [&](bool near_first) {
        SceneBuilder scene;
        scene.colored(kGrey).upright({0, 0, -6}, 8.0);
        pane(scene, near_first ? kAway : kAway - 0.5, near_first ? kRed : kBlue);
        pane(scene, near_first ? kAway - 0.5 : kAway, near_first ? kBlue : kRed);
        return drawn(scene.model());
    };
    const Image near_first = image_of(true);
    const Image far_first = image_of(false);
    const auto [r, g, b] = near_first.pixel(80, 45);
    EXPECT_GT(r, b) << "the nearer pane counts more";
    EXPECT_GT(b, g) << "but the farther one shows through";
    EXPECT_EQ(near_first.rgba, far_first.rgba) << "sorted by distance, not by file order";
}

TEST(Materials, BackFacesAreDrawnOnlyWhenDoubleSided) {
    const auto image_from_behind = [](bool both_sides) {
        Eigen::Matrix4d turned = Eigen::Matrix4d::Identity();
        turned.topLeftCorner<3, 3>() =
            Eigen::AngleAxisd(3.141592653589793, Eigen::Vector3d::UnitY()).toRotationMatrix();
        turned(2, 3) = kAway;
        SceneBuilder scene;
        scene.colored(kBlue).upright({0, 0, -6}, 8.0).colored(kRed);
        if (both_sides) {
            scene.double_sided();
        }
        return drawn(scene.placed(turned).upright({0, 0, 0}, 1.0).model());
    };
    EXPECT_EQ(color_name(image_from_behind(false), 80, 45), "blue");
    EXPECT_EQ(color_name(image_from_behind(true), 80, 45), "red");
}

TEST(Materials, MirroredNodesKeepTheirFrontFaces) {
    Eigen::Matrix4d mirrored = Eigen::Matrix4d::Identity();
    mirrored(0, 0) = -1.0;
    const Image image = drawn(SceneBuilder()
                                  .colored({1, 1, 1, 1}, four_blocks())
                                  .placed(mirrored)
                                  .upright({0, 0, kAway}, 1.0)
                                  .model());
    EXPECT_EQ(color_name(image, 80 + kReach, 45 - kReach), "red") << "visible, with left and right swapped";
    EXPECT_EQ(color_name(image, 80 - kReach, 45 - kReach), "green");
}

TEST(Materials, EmissiveIsVisibleWithoutLight) {
    RenderSettings settings = quick_settings();
    settings.sun_color.setZero();
    settings.sky_light.setZero();
    settings.ground_light.setZero();
    settings.room_light.setZero();
    const scene::Model model =
        SceneBuilder().colored(kBlue).glow({0.6F, 0, 0}).upright({0, 0, kAway}, 1.0).model();
    Renderer renderer(std::span(&model, 1), settings);
    EXPECT_EQ(color_name(renderer.draw(ahead(), kWidth, kHeight), 80, 45), "red");
}

RenderSettings in_the_dark() {
    RenderSettings settings = quick_settings();
    settings.sun_color.setZero();
    settings.sky_light.setZero();
    settings.ground_light.setZero();
    settings.room_light.setZero();
    settings.fog_distance = 0.0;
    return settings;
}

TEST(Materials, EmissiveTextureModulatesEmission) {
    const scene::Model model = SceneBuilder()
                                   .colored(kGrey)
                                   .glow({0.6F, 0.6F, 0.6F})
                                   .image(&scene::Material::emissive_texture, four_blocks())
                                   .upright({0, 0, kAway}, 1.0)
                                   .model();
    Renderer renderer(std::span(&model, 1), in_the_dark());
    const Image image = renderer.draw(ahead(), kWidth, kHeight);
    EXPECT_EQ(color_name(image, 80 - kReach, 45 - kReach), "red");
    EXPECT_EQ(color_name(image, 80 + kReach, 45 - kReach), "green");
    EXPECT_EQ(color_name(image, 80 - kReach, 45 + kReach), "blue");
}

TEST(Materials, UnlitKeepsItsColorInShadowAndWithoutLight) {
    const std::array<std::uint8_t, 4> texel = {240, 90, 30, 255};
    SceneBuilder scene;
    scene.colored({1, 1, 1, 1}, plain_texture(texel)).material().unlit = true;
    const scene::Model model = scene.upright({0, 0, kAway}, 1.0).model();
    RenderSettings sunny = quick_settings();
    sunny.fog_distance = 0.0;
    for (const RenderSettings& settings : {sunny, in_the_dark()}) {
        Renderer renderer(std::span(&model, 1), settings);
        const auto rgb = renderer.draw(ahead(), kWidth, kHeight).pixel(80, 45);
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_NEAR(rgb[i], texel[i], 1);
        }
    }
}

// A sheet with a constant normal map looks like one with tilted vertex normals.
TEST(Materials, NormalMapsEqualTiltedNormals) {
    RenderSettings settings = quick_settings();
    settings.to_sun = Eigen::Vector3d(0.5, 0.4, 0.77).normalized();
    settings.fog_distance = 0.0;
    const auto brightness_of = [&](const scene::Model& model) {
        Renderer renderer(std::span(&model, 1), settings);
        return brightness(renderer.draw(ahead(), kWidth, kHeight), 80, 45);
    };
    std::vector<double> seen;
    for (const Eigen::Vector3d& lean : {Eigen::Vector3d(0.5, 0, 1), Eigen::Vector3d(-0.5, 0, 1),
                                        Eigen::Vector3d(0, 0.5, 1), Eigen::Vector3d(0, -0.5, 1)}) {
        const Eigen::Vector3d n = lean.normalized();
        const auto byte = [](double x) { return static_cast<std::uint8_t>(std::lround(128.0 + 127.0 * x)); };
        const scene::Model mapped = SceneBuilder()
                                        .colored(kGrey)
                                        .image(&scene::Material::normal_texture,
                                               plain_texture({byte(n.x()), byte(n.y()), byte(n.z()), 255}))
                                        .upright({0, 0, kAway}, 1.0)
                                        .model();
        scene::Model leaning = SceneBuilder().colored(kGrey).upright({0, 0, kAway}, 1.0).model();
        for (Eigen::Vector3f& normal : leaning.meshes[0].normals) {
            normal = n.cast<float>();
        }
        seen.push_back(brightness_of(mapped));
        EXPECT_NEAR(seen.back(), brightness_of(leaning), 1.0) << lean.transpose();
    }
    EXPECT_GT(seen[0], seen[1] + 20.0) << "leaning towards the sun";
    EXPECT_GT(seen[2], seen[3] + 20.0);
}

TEST(Materials, NormalScaleZeroIsFlat) {
    const auto sheet = [](float scale) {
        SceneBuilder scene;
        scene.colored(kGrey).image(&scene::Material::normal_texture, plain_texture({220, 160, 180, 255}));
        scene.material().normal_scale = scale;
        return drawn(scene.upright({0, 0, kAway}, 1.0).model());
    };
    const Image plain = drawn(SceneBuilder().colored(kGrey).upright({0, 0, kAway}, 1.0).model());
    EXPECT_NEAR(brightness(sheet(0.0F), 80, 45), brightness(plain, 80, 45), 1.0);
    EXPECT_GT(std::abs(brightness(sheet(1.0F), 80, 45) - brightness(plain, 80, 45)), 10.0);
}

// A row of a polished floor below the horizon shows the sky as far above it.
TEST(Materials, PolishedMetalReflectsTheSky) {
    SceneBuilder scene;
    scene.colored({1, 1, 1, 1}).material().metallic = 1.0F;
    scene.material().roughness = 0.0F;
    const scene::Model model = scene.ground(4000.0).model();
    RenderSettings settings = quick_settings();
    settings.to_sun = Eigen::Vector3d(0, 0.3, 1).normalized();  // behind the camera
    settings.fog_distance = 0.0;
    settings.shadows = false;
    settings.ambient_occlusion_radius = 0.0;
    Renderer renderer(std::span(&model, 1), settings);
    Viewpoint view = ahead();
    view.position.y() = 1.6;
    const Image image = renderer.draw(view, kWidth, kHeight);
    for (const int away : {6, 15, 25, 40}) {
        const auto floor = image.pixel(80, 45 + away);
        const auto sky = image.pixel(80, 44 - away);
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_NEAR(floor[i], sky[i], 3) << away << " rows from the horizon";
        }
    }
}

TEST(Materials, SmootherMetalHasBrighterHighlights) {
    // The sun straight behind the camera: its reflection is in the middle of the image.
    const auto middle = [](float metallic, float roughness) {
        SceneBuilder scene;
        scene.colored({0.2F, 0.2F, 0.2F, 1.0F}).material().metallic = metallic;
        scene.material().roughness = roughness;
        const scene::Model model = scene.upright({0, 0, kAway}, 1.0).model();
        RenderSettings settings = quick_settings();
        settings.to_sun = Eigen::Vector3d::UnitZ();
        settings.shadows = false;
        Renderer renderer(std::span(&model, 1), settings);
        return brightness(renderer.draw(ahead(), kWidth, kHeight), 80, 45);
    };
    const double stone = middle(0.0F, 1.0F);
    EXPECT_GT(middle(1.0F, 0.3F), stone + 30.0);
    EXPECT_GT(middle(1.0F, 0.3F), middle(1.0F, 0.6F) + 20.0);
    EXPECT_NEAR(middle(1.0F, 1.0F), stone, 25.0) << "the default material of glTF is rough metal";
}

}  // namespace
}  // namespace campuswalk::engine::render::test

#include "engine/render/passes/light.h"

#include <cmath>
#include <span>
#include <tuple>

#include <gtest/gtest.h>

#include "engine/render/gl/render_error.h"
#include "engine/render/image/fxaa.h"
#include "engine/render/renderer.h"
#include "tests/engine/render/color_names.h"
#include "tests/engine/render/small_scenes.h"
#include "tests/support/angles.h"

namespace campuswalk::engine::render::test {
namespace {

using support::radians;

Image drawn(const LightSettings& light, int width = kWidth, int height = kHeight) {
    const scene::Model model = tower_scene();
    Renderer renderer(std::span(&model, 1), apply_light(quick_settings(), light));
    return renderer.draw(tower_view(), width, height);
}

TEST(Light, DefaultsToDaylight) {
    EXPECT_EQ(apply_light({}, {}).to_sun, RenderSettings{}.to_sun);
    EXPECT_EQ(drawn({}).rgba, drawn({.anti_aliasing = AntiAliasing::msaa}).rgba);
}

TEST(Light, AzimuthRunsFromNorthToEast) {
    const auto towards = [](double azimuth, double elevation) {
        return apply_light({}, {.sun_azimuth = radians(azimuth), .sun_elevation = radians(elevation)}).to_sun;
    };
    EXPECT_TRUE(towards(0, 1e-9).isApprox(Eigen::Vector3d(0, 0, -1), 1e-9));
    EXPECT_TRUE(towards(90, 1e-9).isApprox(Eigen::Vector3d(1, 0, 0), 1e-9));
    EXPECT_TRUE(towards(17, 90).isApprox(Eigen::Vector3d(0, 1, 0), 1e-9));
}

TEST(Light, SettingOneAngleKeepsTheOther) {
    const Eigen::Vector3d day = RenderSettings{}.to_sun;
    const Eigen::Vector3d turned = apply_light({}, {.sun_azimuth = 1.0}).to_sun;
    EXPECT_NEAR(turned.y(), day.y(), 1e-12);
    const Eigen::Vector3d lower = apply_light({}, {.sun_elevation = 0.2}).to_sun;
    EXPECT_NEAR(lower.x() / lower.z(), day.x() / day.z(), 1e-12);
}

TEST(Light, GlowAffectsEmissiveSurfacesOnly) {
    const scene::Model model = SceneBuilder()
                                   .colored({0, 0, 0, 1})
                                   .glow({0.05F, 0.05F, 0.05F})
                                   .upright({-0.5, 0, -1.6}, 1.0)
                                   .colored(kGrey)
                                   .upright({0.5, 0, -1.6}, 1.0)
                                   .model();
    const auto image = [&](double glow) {
        RenderSettings settings = quick_settings();
        settings.fog_distance = 0.0;
        Renderer renderer(std::span(&model, 1), apply_light(settings, {.glow = glow}));
        return renderer.draw(ahead(), kWidth, kHeight);
    };
    const Image bright = image(10.0);
    // 0.5 of the light is this sRGB value (IEC 61966-2-1).
    EXPECT_NEAR(bright.pixel(66, 45)[0], 255.0 * (1.055 * std::pow(0.5, 1 / 2.4) - 0.055), 1.5);
    EXPECT_EQ(image(0.0).pixel(66, 45)[0], 0);
    EXPECT_EQ(image(0.0).pixel(94, 45), bright.pixel(94, 45));
}

TEST(Light, ShadowsFallAwayFromTheSun) {
    const scene::Model model = SceneBuilder()
                                   .colored(kGrey)
                                   .double_sided()
                                   .ground(60.0)
                                   .colored(kGrey)
                                   .box({-2, 0, -2}, {2, 6, 2})
                                   .model();
    for (const auto& [azimuth, dark, bright] :
         {std::tuple(90.0, Eigen::Vector3d(-4, 0, 0), Eigen::Vector3d(4, 0, 0)),
          std::tuple(0.0, Eigen::Vector3d(0, 0, 4), Eigen::Vector3d(0, 0, -4))}) {
        const LightSettings light{.sun_azimuth = radians(azimuth), .sun_elevation = radians(45)};
        Renderer renderer(std::span(&model, 1), apply_light(quick_settings(), light));
        const Viewpoint view = plan(renderer.bounds(), 1.0);
        const Image image = renderer.draw(view, 120, 120);
        const auto at = [&](const Eigen::Vector3d& point) {
            const auto pixel = pixel_of(view, 120, 120, point);
            return brightness(image, static_cast<int>(pixel->x()), static_cast<int>(pixel->y()));
        };
        EXPECT_LT(at(dark), 0.8 * at(bright));
    }
}

// An image large enough that walls are more than a few pixels wide.
constexpr int kImageWidth = 480;
constexpr int kImageHeight = 270;

TEST(Light, EveryAntiAliasingIsCloserToSupersampling) {
    const scene::Model model = tower_scene();
    Renderer renderer(std::span(&model, 1),
                      apply_light(quick_settings(), {.anti_aliasing = AntiAliasing::none}));
    const Image fine = downsampled_by_two(
        downsampled_by_two(renderer.draw(tower_view(), 4 * kImageWidth, 4 * kImageHeight)));
    const auto error = [&](AntiAliasing mode) {
        const Image image = drawn({.anti_aliasing = mode}, kImageWidth, kImageHeight);
        double sum = 0.0;
        for (std::size_t i = 0; i < fine.rgba.size(); ++i) {
            sum += std::pow(fine.rgba[i] - image.rgba[i], 2);
        }
        return sum;
    };
    const double none = error(AntiAliasing::none);
    EXPECT_LT(error(AntiAliasing::msaa), 0.2 * none);
    EXPECT_LT(error(AntiAliasing::fxaa), 0.75 * none);
    EXPECT_LT(error(AntiAliasing::supersampling), 0.4 * none);
}

TEST(Light, SupersamplingHalvesTheMaximumSize) {
    const scene::Model model = tower_scene();
    Renderer renderer(std::span(&model, 1),
                      apply_light(quick_settings(), {.anti_aliasing = AntiAliasing::supersampling}));
    EXPECT_THROW(renderer.draw(tower_view(), 10'000, 16), RenderError);
    EXPECT_EQ(renderer.draw(tower_view(), 33, 17).width, 33);
}

}  // namespace
}  // namespace campuswalk::engine::render::test

#include "engine/render/passes/shadow_maps.h"

#include <span>

#include <gtest/gtest.h>

#include "engine/render/renderer.h"
#include "tests/engine/render/color_names.h"
#include "tests/engine/render/small_scenes.h"

namespace campuswalk::engine::render::test {
namespace {

using Eigen::Vector3d;

// A box 4 m high on level ground. The sun is over (-x, +z): the ray towards it from (2, 0, -2) passes through
// the box 1.4 m over the ground, that from (-2, 0, 2) doesn't.
const Vector3d kShaded(2.0, 0.0, -2.0);
const Vector3d kSunny(-2.0, 0.0, 2.0);

scene::Model box_on_ground(scene::AlphaMode mode = scene::AlphaMode::opaque, bool box = true) {
    SceneBuilder scene;
    scene.colored(kGrey).ground(40.0);
    if (box) {
        scene.colored({0.4F, 0.4F, 0.4F, 0.5F}).alpha(mode).box({-1, 0, -1}, {1, 4, 1});
    }
    return scene.model();
}

RenderSettings settings_with(bool shadows) {
    RenderSettings settings = quick_settings();
    settings.shadows = shadows;
    settings.shadow_size = 1024;
    settings.ambient_occlusion_radius = 0.0;
    return settings;
}

double brightness_at(const Image& image, const Viewpoint& view, const Vector3d& point) {
    const auto pixel = pixel_of(view, image.width, image.height, point);
    return brightness(image, static_cast<int>(pixel->x()), static_cast<int>(pixel->y()));
}

Viewpoint map_of_the_box() {
    scene::Bounds bounds;
    bounds.extend({-20, 0, -20});
    bounds.extend({20, 4, 20});
    return top(Vector3d::Zero(), 8.0, 1.0471975511965976, bounds);
}

// The near map is used in perspective views, the far one on plans.
TEST(Shadows, FallAwayFromTheSunInBothMaps) {
    const scene::Model model = box_on_ground();
    Renderer renderer(std::span(&model, 1), settings_with(true));
    for (const Viewpoint& view : {from_above(0, 14, 0), map_of_the_box()}) {
        const Image image = renderer.draw(view, kWidth, kHeight);
        EXPECT_LT(brightness_at(image, view, kShaded), 0.75 * brightness_at(image, view, kSunny));
        EXPECT_NEAR(brightness_at(image, view, {6, 0, 3}), brightness_at(image, view, kSunny), 3.0)
            << "beyond the shadow";
    }
}

TEST(Shadows, AreAbsentWhenDisabledOrWithoutACaster) {
    const Viewpoint view = from_above(0, 14, 0);
    const scene::Model with_box = box_on_ground();
    const scene::Model bare = box_on_ground(scene::AlphaMode::opaque, false);
    Renderer no_shadows(std::span(&with_box, 1), settings_with(false));
    Renderer no_box(std::span(&bare, 1), settings_with(true));
    for (Renderer* renderer : {&no_shadows, &no_box}) {
        const Image image = renderer->draw(view, kWidth, kHeight);
        EXPECT_NEAR(brightness_at(image, view, kShaded), brightness_at(image, view, kSunny), 3.0);
    }
}

TEST(Shadows, AreNotCastByGlass) {
    const Viewpoint view = from_above(0, 14, 0);
    const scene::Model model = box_on_ground(scene::AlphaMode::blend);
    Renderer renderer(std::span(&model, 1), settings_with(true));
    const Image image = renderer.draw(view, kWidth, kHeight);
    EXPECT_NEAR(brightness_at(image, view, kShaded), brightness_at(image, view, kSunny), 3.0);
}

TEST(Shadows, ReachTheFootOfTheWall) {
    const scene::Model model = box_on_ground();
    Renderer renderer(std::span(&model, 1), settings_with(true));
    const Viewpoint view = from_above(3, 6, 0);
    const Image image = renderer.draw(view, 320, 180);
    // 12 cm from the wall: a bias that is too large lets light through there.
    EXPECT_LT(brightness_at(image, view, {1.12, 0, -0.5}), 0.75 * brightness_at(image, view, {5, 0, 2}));
}

TEST(Shadows, DoNotSpeckleSunlitSurfaces) {
    const scene::Model model = box_on_ground();
    Renderer renderer(std::span(&model, 1), settings_with(true));
    // Level ground, seen from near and from far.
    for (const Viewpoint& view : {from_above(-10, 4, 10), from_above(-10, 60, 10)}) {
        const Image image = renderer.draw(view, kWidth, kHeight);
        const int middle_x = kWidth / 2;
        const int middle_y = kHeight / 2;
        double darkest = 255.0;
        double brightest = 0.0;
        for (int y = middle_y - 8; y < middle_y + 8; ++y) {
            for (int x = middle_x - 8; x < middle_x + 8; ++x) {
                darkest = std::min(darkest, brightness(image, x, y));
                brightest = std::max(brightest, brightness(image, x, y));
            }
        }
        EXPECT_LT(brightest - darkest, 4.0);
    }
}

TEST(Shadows, FollowTheAvatar) {
    const scene::Model bare = box_on_ground(scene::AlphaMode::opaque, false);
    Renderer renderer(std::span(&bare, 1), settings_with(true));
    const Viewpoint view = from_above(0, 6, 0);
    const Image without = renderer.draw(view, kWidth, kHeight);
    const Image with = renderer.draw(view, kWidth, kHeight, Figure{});
    const Vector3d shaded(0.5 * 0.48 / 0.68, 0.0, -0.5 * 0.55 / 0.68);  // of the trunk, half a metre up
    EXPECT_LT(brightness_at(with, view, 1.8 * shaded), 0.8 * brightness_at(without, view, 1.8 * shaded));
}

}  // namespace
}  // namespace campuswalk::engine::render::test

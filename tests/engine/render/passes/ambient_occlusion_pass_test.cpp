#include "engine/render/passes/ambient_occlusion_pass.h"

#include <span>

#include <gtest/gtest.h>

#include "engine/render/renderer.h"
#include "tests/engine/render/color_names.h"
#include "tests/engine/render/small_scenes.h"

namespace campuswalk::engine::render::test {
namespace {

// Ground and a wall 5 m away, in ambient light only.
Image ground_and_wall(double radius, double pitch = -0.32) {
    const scene::Model model =
        SceneBuilder().colored(kGrey).ground(30.0).colored(kGrey).box({-15, 0, -6}, {15, 8, -5}).model();
    RenderSettings settings = quick_settings();
    settings.sun_color.setZero();
    settings.shadows = false;
    settings.ambient_occlusion_radius = radius;
    Renderer renderer(std::span(&model, 1), settings);
    return renderer.draw(looking({0, 1.65, 0}, 0.0, pitch, kFov), 320, 180);
}

TEST(AmbientOcclusion, DarkensTheFootOfAWallButNotOpenGround) {
    const Image with = ground_and_wall(0.9);
    const Image without = ground_and_wall(0.0);
    const auto foot = pixel_of(looking({0, 1.65, 0}, 0.0, -0.32, kFov), 320, 180, {0, 0, -4.9});
    const auto row = static_cast<int>(foot->y());
    const double share_at_the_foot =
        mean_brightness(with, 80, row, 240, row + 4) / mean_brightness(without, 80, row, 240, row + 4);
    EXPECT_LT(share_at_the_foot, 0.96);
    const double share_in_the_open =
        mean_brightness(with, 80, 160, 240, 176) / mean_brightness(without, 80, 160, 240, 176);
    EXPECT_GT(share_in_the_open, 0.98);
}

TEST(AmbientOcclusion, LeavesNoPatternOnAFlatSurface) {
    const Image image = ground_and_wall(0.9);
    // All pixels of a row of ground are at the same distance, and so equally lit.
    double darkest = 255.0;
    double brightest = 0.0;
    for (int x = 20; x < 300; ++x) {
        darkest = std::min(darkest, brightness(image, x, 140));
        brightest = std::max(brightest, brightness(image, x, 140));
    }
    EXPECT_LT(brightest - darkest, 6.0);
}

}  // namespace
}  // namespace campuswalk::engine::render::test

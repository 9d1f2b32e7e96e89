#include "engine/render/overlay/minimap.h"

#include <gtest/gtest.h>

#include "tests/engine/render/color_names.h"

namespace campuswalk::engine::render::test {
namespace {

constexpr int kPlanSide = 400;
const std::array<std::uint8_t, 3> kAsphalt = {60, 60, 60};

// 200 m of campus: west red, east green, but everything south of z = 0 blue.
Minimap two_halves() {
    scene::Bounds bounds;
    bounds.extend({-100, 0, -100});
    bounds.extend({100, 10, 100});
    Minimap minimap;
    minimap.view = plan(bounds, 1.0);
    minimap.plan = plain_image(kPlanSide, kPlanSide, {0, 0, 220});
    minimap.radius = 50.0;
    for (int y = 0; y < kPlanSide / 2; ++y) {
        for (int x = 0; x < kPlanSide; ++x) {
            std::uint8_t* pixel = &minimap.plan.rgba[minimap.plan.offset(x, y)];
            pixel[0] = x < kPlanSide / 2 ? 220 : 0;
            pixel[1] = x < kPlanSide / 2 ? 0 : 220;
            pixel[2] = 0;
        }
    }
    return minimap;
}

// In an image 720 high the circle's middle is 114 pixels from the left and from below, its radius 88.
constexpr int kMiddleX = 114;
constexpr int kMiddleY = 720 - 114;

Image drawn(const Eigen::Vector3d& position, double yaw, int height = 720) {
    const Fonts fonts;
    const Canvas canvas(plain_image(16 * height / 9, height, kAsphalt), fonts);
    AvatarState avatar;
    avatar.position = position;
    avatar.yaw = yaw;
    draw_minimap(canvas, two_halves(), avatar);
    return canvas.image();
}

TEST(Minimap, ShowsTheSurroundingsOfTheAvatarWithNorthUp) {
    const Image image = drawn({0, 0, 0}, 0.0);
    EXPECT_EQ(color_name(image, kMiddleX - 40, kMiddleY - 40), "red") << "north-west";
    EXPECT_EQ(color_name(image, kMiddleX + 40, kMiddleY - 40), "green") << "north-east";
    EXPECT_EQ(color_name(image, kMiddleX, kMiddleY + 50), "blue") << "south";
}

TEST(Minimap, MovesWithTheAvatarAtItsScale) {
    // 20 m east: the border between red and green is 20 / 50 of the radius to the left.
    const Image image = drawn({20, 0, -30}, 0.0);
    const int border = kMiddleX - 88 * 20 / 50;
    EXPECT_EQ(color_name(image, border - 5, kMiddleY - 30), "red");
    EXPECT_EQ(color_name(image, border + 5, kMiddleY - 30), "green");
    const int south = kMiddleY + 88 * 30 / 50;
    EXPECT_EQ(color_name(image, kMiddleX + 30, south - 5), "green");
    EXPECT_EQ(color_name(image, kMiddleX + 30, south + 5), "blue");
}

TEST(Minimap, IsBlankBeyondTheCampus) {
    const Image image = drawn({100, 0, 0}, 0.0);
    EXPECT_EQ(color_name(image, kMiddleX + 50, kMiddleY), "grey");
    EXPECT_EQ(color_name(image, kMiddleX - 40, kMiddleY - 30), "green");
}

TEST(Minimap, ArrowTurnsWhileTheMapStaysNorthUp) {
    const Image north = drawn({0, 0, 0}, 0.0);
    const Image west = drawn({0, 0, 0}, 1.5707963267948966);
    EXPECT_GT(differing_pixels(north, west), 50U);
    EXPECT_EQ(north.pixel(kMiddleX - 40, kMiddleY - 40), west.pixel(kMiddleX - 40, kMiddleY - 40));
}

TEST(Minimap, LeavesTheRestOfTheImageUnchanged) {
    const Image image = drawn({0, 0, 0}, 0.0);
    EXPECT_EQ(image.pixel(kMiddleX + 100, kMiddleY), kAsphalt);
    EXPECT_EQ(image.pixel(640, 360), kAsphalt);
    EXPECT_EQ(image.pixel(kMiddleX - 80, kMiddleY - 80), kAsphalt) << "a circle, not a square";
}

TEST(Minimap, IsOmittedFromSmallImages) {
    const Image image = drawn({0, 0, 0}, 0.0, kSmallestMinimapImage - 1);
    EXPECT_EQ(differing_pixels(image, plain_image(image.width, image.height, kAsphalt)), 0U);
}

}  // namespace
}  // namespace campuswalk::engine::render::test

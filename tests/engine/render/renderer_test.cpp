#include "engine/render/renderer.h"

#include <cstdio>
#include <fstream>
#include <iterator>
#include <limits>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "engine/render/gl/render_error.h"
#include "engine/render/image/png.h"
#include "tests/engine/render/color_names.h"
#include "tests/engine/render/scratch_folder.h"
#include "tests/engine/render/small_scenes.h"

namespace campuswalk::engine::render::test {
namespace {

using Eigen::Vector3d;

Renderer renderer_of(const scene::Model& model, const RenderSettings& settings = quick_settings()) {
    return Renderer(std::span(&model, 1), settings);
}

TEST(Renderer, PlusXIsRightAndPlusYIsUp) {
    const scene::Model model = SceneBuilder()
                                   .colored(kRed)
                                   .box({2, -1, -7}, {4, 1, -6})
                                   .colored(kGreen)
                                   .box({-1, 1.6, -7}, {1, 3, -6})
                                   .colored(kBlue)
                                   .box({-4, -1, -7}, {-2, 1, -6})
                                   .model();
    Renderer renderer = renderer_of(model);
    const Image image = renderer.draw(ahead(), kWidth, kHeight);
    const auto name_at = [&](const Vector3d& point) {
        const auto pixel = pixel_of(ahead(), kWidth, kHeight, point);
        return color_name(image, pixel->x(), pixel->y());
    };
    EXPECT_EQ(name_at({3, 0, -6}), "red");
    EXPECT_EQ(name_at({0, 2, -6}), "green");
    EXPECT_EQ(name_at({-3, 0, -6}), "blue");
    EXPECT_EQ(color_name(image, 120, 45), "red") << "right of the middle";
    EXPECT_EQ(color_name(image, 40, 45), "blue");
    EXPECT_EQ(color_name(image, 80, 18), "green") << "above the middle";
}

TEST(Renderer, PositiveYawTurnsLeft) {
    const scene::Model model = SceneBuilder().colored(kBlue).box({-7, -1, -1}, {-6, 1, 1}).model();
    Renderer renderer = renderer_of(model);
    const Viewpoint left = looking(Vector3d::Zero(), 1.5707963267948966, 0.0, kFov);
    EXPECT_EQ(color_name(renderer.draw(left, kWidth, kHeight), 80, 45), "blue");
}

TEST(Renderer, DrawsAPointAtItsProjectedPixel) {
    const Vector3d point(1.2, 0.7, -9.0);
    const Vector3d half(0.15, 0.15, 0.0001);
    const scene::Model model = SceneBuilder()
                                   .colored({0, 0, 0, 1})
                                   .upright({0, 0, -20}, 60.0)
                                   .colored({0, 0, 0, 1})
                                   .glow({1, 0, 0})
                                   .box(point - half, point + half)
                                   .model();
    RenderSettings settings = quick_settings();
    settings.fog_distance = 0.0;
    Renderer renderer = renderer_of(model, settings);
    const Viewpoint view = looking({0.3, 0.2, 0.5}, -0.1, 0.05, kFov);
    const Image image = renderer.draw(view, 321, 181);
    Eigen::Vector2d sum(0, 0);
    double weight = 0.0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const double red = std::max(0, image.pixel(x, y)[0] - 40);
            sum += red * Eigen::Vector2d(x + 0.5, y + 0.5);
            weight += red;
        }
    }
    ASSERT_GT(weight, 0.0);
    const auto expected = pixel_of(view, 321, 181, point);
    ASSERT_TRUE(expected);
    EXPECT_NEAR(sum.x() / weight, expected->x(), 0.3);
    EXPECT_NEAR(sum.y() / weight, expected->y(), 0.3);
}

TEST(Renderer, DrawsSkyAboveTheHorizonButNotOnAMap) {
    const scene::Model model = SceneBuilder().colored(kGreen).ground(10.0).model();
    Renderer renderer = renderer_of(model);
    const Image eye_level = renderer.draw(looking({0, 1.65, 4}, 0.0, 0.2, kFov), kWidth, kHeight);
    const auto sky = eye_level.pixel(80, 3);
    EXPECT_GT(sky[2], sky[0] + 30) << "blue";
    EXPECT_EQ(color_name(eye_level, 80, 85), "green");
    const Image map = renderer.draw(plan(renderer.bounds(), 2.0), 100, 50);
    EXPECT_EQ(color_name(map, 50, 25), "green");
    EXPECT_EQ(color_name(map, 2, 25), "grey") << "background beside the campus";
}

TEST(Renderer, DrawsTheSameBytesRepeatedlyAndInAnotherContext) {
    const scene::Model model = tower_scene();
    Renderer renderer = renderer_of(model);
    const Image first = renderer.draw(tower_view(), kWidth, kHeight);
    renderer.draw(from_above(0, 30, 0), 77, 41);
    EXPECT_EQ(renderer.draw(tower_view(), kWidth, kHeight).rgba, first.rgba);
    Renderer other = renderer_of(model);
    EXPECT_EQ(other.draw(tower_view(), kWidth, kHeight).rgba, first.rgba);
    // The first context is usable again after another one was current.
    EXPECT_EQ(renderer.draw(tower_view(), kWidth, kHeight).rgba, first.rgba);
}

TEST(Renderer, SurvivesTheDestructionOfAnother) {
    const scene::Model model = tower_scene();
    auto doomed = std::make_unique<Renderer>(renderer_of(model));
    doomed->draw(tower_view(), kWidth, kHeight);
    Renderer survivor = renderer_of(model);
    const Image before = survivor.draw(tower_view(), kWidth, kHeight);
    doomed.reset();  // while the other's context is current
    EXPECT_EQ(survivor.draw(tower_view(), kWidth, kHeight).rgba, before.rgba);
}

TEST(Renderer, DrawsTheSameBytesInAnyProcessBackendAndThreadCount) {
    const scene::Model model = tower_scene();
    Renderer renderer = renderer_of(model);
    const std::vector<std::uint8_t> ours = encode_png(renderer.draw(tower_view(), kWidth, kHeight));
    const ScratchFolder folder;
    for (const char* backend : {"osmesa", "egl"}) {
        for (const char* threads : {"0", "1", "2"}) {
            const std::filesystem::path file = folder.path() / (std::string(backend) + threads + ".png");
            const std::string command = std::string("LP_NUM_THREADS=") + threads + ' ' + DRAW_ONE_IMAGE +
                                        " '" + file.string() + "' " + backend;
            ASSERT_EQ(std::system(command.c_str()), 0) << command;
            std::ifstream stream(file, std::ios::binary);
            const std::vector<std::uint8_t> theirs{std::istreambuf_iterator<char>(stream), {}};
            EXPECT_EQ(theirs, ours) << command;
        }
    }
}

TEST(Renderer, DrawsAnEmptyCampus) {
    Renderer renderer(std::span<const scene::Model>{}, quick_settings());
    EXPECT_TRUE(renderer.bounds().empty());
    EXPECT_EQ(renderer.draw(ahead(), 16, 9).rgba.size(), 4U * 16U * 9U);
}

TEST(Renderer, DrawsImagesOfOddSizes) {
    const scene::Model model = tower_scene();
    Renderer renderer = renderer_of(model);
    for (const auto& [width, height] : {std::pair(1, 1), std::pair(3, 200), std::pair(201, 7)}) {
        const Image image = renderer.draw(tower_view(), width, height);
        EXPECT_EQ(image.width, width);
        EXPECT_EQ(image.height, height);
        EXPECT_EQ(image.rgba.size(), 4U * static_cast<unsigned>(width * height));
    }
}

TEST(Renderer, RejectsUnsupportedSizes) {
    const scene::Model model = tower_scene();
    Renderer renderer = renderer_of(model);
    EXPECT_THROW(renderer.draw(ahead(), 0, 90), RenderError);
    EXPECT_THROW(renderer.draw(ahead(), 160, -1), RenderError);
    EXPECT_THROW(renderer.draw(ahead(), std::numeric_limits<int>::max(), 1), RenderError);
    // And still draws afterwards.
    EXPECT_EQ(renderer.draw(ahead(), 16, 9).width, 16);
}

TEST(Renderer, IsPreciseFarFromTheWorldOrigin) {
    scene::Model near = tower_scene();
    scene::Model far = near;
    const Vector3d offset(450000.0, 300.0, -5200000.0);  // map coordinates
    for (scene::Node& node : far.nodes) {
        node.X_world_node.topRightCorner<3, 1>() += offset;
    }
    Renderer at_origin = renderer_of(near);
    Renderer far_away = renderer_of(far);
    Viewpoint view = tower_view();
    const Image expected = at_origin.draw(view, kWidth, kHeight);
    view.position += offset;
    const Image drawn = far_away.draw(view, kWidth, kHeight);
    EXPECT_LT(differing_pixels(expected, drawn), expected.rgba.size() / 4 / 100);
}

TEST(Renderer, DrawsTheAvatarWhereItStands) {
    const scene::Model model = SceneBuilder().colored(kGrey).ground(20.0).model();
    Renderer renderer = renderer_of(model);
    const Viewpoint view = looking({0, 1.0, 5}, 0.0, 0.0, kFov);
    Figure figure;
    figure.avatar.position = {0.5, 0, 0};
    const Image with = renderer.draw(view, kWidth, kHeight, figure);
    const Image without = renderer.draw(view, kWidth, kHeight);
    const auto chest = pixel_of(view, kWidth, kHeight, {0.5, 1.2, 0});
    const auto x = static_cast<int>(chest->x());
    const auto y = static_cast<int>(chest->y());
    EXPECT_NE(with.pixel(x, y), without.pixel(x, y));
    EXPECT_EQ(with.pixel(20, y), without.pixel(20, y));
}

}  // namespace
}  // namespace campuswalk::engine::render::test

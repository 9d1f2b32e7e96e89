#include "engine/render/image/channels.h"

#include <random>
#include <span>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "engine/render/gl/render_error.h"
#include "engine/render/renderer.h"
#include "tests/engine/render/color_names.h"
#include "tests/engine/render/pixel_rays.h"
#include "tests/engine/render/small_scenes.h"

namespace campuswalk::engine::render::test {
namespace {

using Eigen::Vector3d;

constexpr ChannelChoice kAll = {.nodes = true, .depth = true, .normals = true};

std::size_t pixel_index(const Channels& channels, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(channels.width) +
           static_cast<std::size_t>(x);
}

// Rotated, stretched and mirrored boxes and sheets with all kinds of materials, some behind the camera.
scene::Model random_model(unsigned seed, bool with_textures = true) {
    std::mt19937 dice(seed);
    const auto any = [&dice](double low, double high) {
        return low + (high - low) * static_cast<double>(dice()) / 4294967295.0;
    };
    SceneBuilder scene;
    scene.colored(kGrey).ground(60.0);
    for (int i = 0; i < 40; ++i) {
        const bool textured = with_textures && i % 3 == 1;
        // With the cutoff at half of alpha, a texture's edge lies between two texels, as for the rays.
        scene.colored(
            {1, 1, 1, textured ? 1.0F : std::array{0.3F, 0.3F, 0.8F, 0.4F}[static_cast<std::size_t>(i % 4)]},
            textured ? std::optional(half_clear()) : std::nullopt);
        scene.alpha(std::array{scene::AlphaMode::opaque, scene::AlphaMode::mask, scene::AlphaMode::blend,
                               scene::AlphaMode::blend}[static_cast<std::size_t>(i % 4)],
                    textured ? 0.5F : 0.25F);
        if (i % 5 < 2) {
            scene.double_sided();
        }
        Eigen::Affine3d place =
            Eigen::Translation3d(any(-12, 12), any(0, 5), any(-25, 4)) *
            Eigen::AngleAxisd(any(0, 6), Vector3d(any(-1, 1), any(0.1, 1), any(-1, 1)).normalized()) *
            Eigen::Scaling(Vector3d(i % 7 == 0 ? -1.0 : 1.0, any(0.5, 2), any(0.5, 2)));
        scene.placed(place.matrix());
        if (i % 2 == 0) {
            scene.box({-1, -1, -1}, {1, 1, 1});
        } else {
            scene.upright({0, 0, 0}, 3.0);
        }
    }
    return scene.model();
}

// Expects that all pixels match the rays, except for a few at edges.
void expect_match_with_rays(const scene::Model& model, const Viewpoint& view, int width, int height) {
    Renderer renderer(std::span(&model, 1), quick_settings());
    const Channels drawn = renderer.draw_channels(view, width, height, kAll);
    const PixelRays rays(model, view, width, height);
    int same = 0;
    int interior = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const PixelHit& hit = rays.at(x, y);
            const std::size_t i = pixel_index(drawn, x, y);
            same += drawn.nodes[i] == hit.node ? 1 : 0;
            if (!rays.is_interior(x, y)) {
                continue;
            }
            ++interior;
            ASSERT_EQ(drawn.nodes[i], hit.node) << "at " << x << ", " << y;
            // The driver snaps vertices to 1/256 pixel.
            ASSERT_NEAR(drawn.depth[i], hit.depth, 1e-5 * hit.depth + rays.depth_change(x, y) / 64.0)
                << "at " << x << ", " << y;
        }
    }
    EXPECT_GT(same, 0.99 * width * height);
    EXPECT_GT(interior, width * height / 2);
}

TEST(Channels, MatchRaysThroughPixelCentres) {
    for (const unsigned seed : {1U, 2U, 3U}) {
        const scene::Model model = random_model(seed);
        expect_match_with_rays(model, looking({0, 2, 8}, 0.1, -0.05, kFov), 241, 135);
        expect_match_with_rays(model, looking({3, 9, -6}, 1.2, -0.9, 1.4), 120, 160);
    }
}

TEST(Channels, MatchParallelRaysOnAMap) {
    const scene::Model model =
        random_model(4, false);  // without textures: texels would be smaller than pixels
    expect_match_with_rays(model, plan(scene::world_bounds(model), 1.5), 150, 100);
}

TEST(Channels, NormalsFaceTheCamera) {
    const scene::Model model = random_model(5);
    const Viewpoint view = looking({0, 2, 8}, 0.1, -0.05, kFov);
    Renderer renderer(std::span(&model, 1), quick_settings());
    const Channels drawn = renderer.draw_channels(view, 160, 90, kAll);
    const PixelRays rays(model, view, 160, 90);
    int checked = 0;
    for (int y = 0; y < 90; ++y) {
        for (int x = 0; x < 160; ++x) {
            const std::array<std::uint8_t, 3> rgb = drawn.normals.pixel(x, y);
            if (drawn.nodes[pixel_index(drawn, x, y)] == 0) {
                EXPECT_EQ(rgb, (std::array<std::uint8_t, 3>{0, 0, 0}));
                continue;
            }
            if (drawn.nodes[pixel_index(drawn, x, y)] != rays.at(x, y).node) {
                continue;
            }
            const Vector3d n((rgb[0] - 128) / 127.0, (rgb[1] - 128) / 127.0, (rgb[2] - 128) / 127.0);
            // At an edge between two faces of a box, a pixel may show either.
            if ((n - rays.at(x, y).normal).cwiseAbs().maxCoeff() < 0.01) {
                ++checked;
            } else {
                EXPECT_LT(n.dot(-view.R_world_camera.col(2)), 0.5);
            }
        }
    }
    EXPECT_GT(checked, 160 * 90 / 2);
}

TEST(Channels, NormalsOfFlatGroundPointUp) {
    const scene::Model model = SceneBuilder().colored(kGrey).ground(100.0).model();
    Renderer renderer(std::span(&model, 1), quick_settings());
    const Channels drawn = renderer.draw_channels(looking({0, 2, 0}, 0.7, -0.5, kFov), 16, 9, kAll);
    EXPECT_EQ(drawn.normals.pixel(8, 8), (std::array<std::uint8_t, 3>{128, 255, 128}));
}

TEST(Channels, BlendedSurfacesCountFromHalfOpacity) {
    const auto node_behind = [](float alpha) {
        const scene::Model model = SceneBuilder()
                                       .colored(kGrey)
                                       .upright({0, 0, -6}, 8.0)
                                       .colored({1, 1, 1, alpha})
                                       .alpha(scene::AlphaMode::blend)
                                       .upright({0, 0, -2}, 1.0)
                                       .model();
        Renderer renderer(std::span(&model, 1), quick_settings());
        return renderer.draw_channels(ahead(), 16, 9, kAll).nodes[4 * 16 + 8];
    };
    EXPECT_EQ(node_behind(0.45F), 1U);
    EXPECT_EQ(node_behind(0.55F), 2U);
}

TEST(Channels, TheAvatarOccludesAndHasNoNodeNumber) {
    const scene::Model model = SceneBuilder().colored(kGrey).upright({0, 0, -6}, 30.0).model();
    Renderer renderer(std::span(&model, 1), quick_settings());
    const Viewpoint view = looking({0, 1, 4}, 0.0, 0.0, kFov);
    const Channels alone = renderer.draw_channels(view, 32, 18, kAll);
    const Channels with = renderer.draw_channels(view, 32, 18, kAll, Figure{});
    const std::size_t middle = 9 * 32 + 16;
    EXPECT_EQ(alone.nodes[middle], 1U);
    EXPECT_NEAR(alone.depth[middle], 10.0, 1e-4);
    EXPECT_EQ(with.nodes[middle], 0U);
    EXPECT_NEAR(with.depth[middle], 4.0, 0.3);
}

TEST(Channels, NodeNumbersContinueAcrossModels) {
    const std::array models = {
        SceneBuilder().colored(kRed).upright({-2, 0, -4}, 1.0).model(),
        SceneBuilder().colored(kRed).upright({0, 0, -9}, 1.0).upright({2, 0, -4}, 1.0).model()};
    Renderer renderer(models, quick_settings());
    const Channels drawn = renderer.draw_channels(ahead(), kWidth, kHeight, {.nodes = true});
    constexpr auto kStride = std::ptrdiff_t{kWidth};
    std::vector<std::uint32_t> row(drawn.nodes.begin() + 45 * kStride, drawn.nodes.begin() + 46 * kStride);
    row.erase(std::unique(row.begin(), row.end()), row.end());
    EXPECT_EQ(row, (std::vector<std::uint32_t>{0, 1, 0, 2, 0, 3, 0}));
}

TEST(Channels, ContainOnlyWhatWasRequested) {
    const scene::Model model = tower_scene();
    Renderer renderer(std::span(&model, 1), quick_settings());
    const Channels all = renderer.draw_channels(tower_view(), 40, 30, kAll);
    const Channels depth = renderer.draw_channels(tower_view(), 40, 30, {.depth = true});
    EXPECT_EQ(depth.depth, all.depth);
    EXPECT_TRUE(depth.nodes.empty());
    EXPECT_TRUE(depth.normals.rgba.empty());
}

TEST(Channels, DoNotChangeLaterImages) {
    const scene::Model model = tower_scene();
    Renderer renderer(std::span(&model, 1), quick_settings());
    const Image before = renderer.draw(tower_view(), kWidth, kHeight);
    const Channels first = renderer.draw_channels(tower_view(), 40, 30, kAll);
    EXPECT_EQ(renderer.draw(tower_view(), kWidth, kHeight).rgba, before.rgba);
    EXPECT_EQ(renderer.draw_channels(tower_view(), 40, 30, kAll).nodes, first.nodes);
}

TEST(Channels, RejectUnsupportedSizes) {
    const scene::Model model = tower_scene();
    Renderer renderer(std::span(&model, 1), quick_settings());
    EXPECT_THROW(renderer.draw_channels(ahead(), 0, 9, kAll), RenderError);
    EXPECT_THROW(renderer.draw_channels(ahead(), 16, 100000, kAll), RenderError);
}

}  // namespace
}  // namespace campuswalk::engine::render::test

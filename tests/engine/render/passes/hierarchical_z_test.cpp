#include "engine/render/passes/hierarchical_z.h"

#include <array>
#include <numbers>
#include <span>

#include <gtest/gtest.h>

#include "engine/render/gl/gl_context.h"
#include "engine/render/renderer.h"
#include "tests/engine/render/campus_view.h"
#include "tests/engine/render/small_scenes.h"

namespace campuswalk::engine::render::test {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

constexpr std::size_t kEnough = 1U << 20U;  // indices: enough for a readback

class HierarchicalZOfTarget : public testing::TestWithParam<int> {
protected:
    HierarchicalZOfTarget() {
        context_->make_current();
        gl_ = load_gl_functions(*context_);
        gl_.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    }

    // Sets the depth from column `left` to before `right` to that of `distance` metres.
    void fill(const RenderTarget& target, int left, int right, double distance) {
        target.resume();
        gl_.Enable(GL_SCISSOR_TEST);
        gl_.Scissor(left, 0, right - left, kHeight);
        const Eigen::Vector4d clip = clip_campus() * Eigen::Vector4d(0, 0, -distance, 1);
        gl_.ClearDepth(clip.z() / clip.w());
        gl_.Clear(GL_DEPTH_BUFFER_BIT);
        gl_.Disable(GL_SCISSOR_TEST);
    }

    static Eigen::Matrix4d clip_campus() {
        return clip_from_world(ahead(), static_cast<double>(kWidth) / kHeight);
    }

    std::unique_ptr<GlContext> context_ = make_gl_context(RenderingBackend::automatic);
    GlFunctions gl_;
};

TEST_P(HierarchicalZOfTarget, OccludesAfterAReadback) {
    const RenderTarget target(gl_, kWidth, kHeight, GetParam());
    target.begin(Vector3d::Zero());
    fill(target, 0, kWidth, 10.0);
    HierarchicalZ depth(gl_, GetParam());
    depth.begin(target, clip_campus());
    const AlignedBox3d behind(Vector3d(-1, -1, -14), Vector3d(1, 1, -12));
    EXPECT_FALSE(depth.occludes(behind)) << "no readback yet";
    EXPECT_FALSE(depth.count_drawn(3));
    EXPECT_FALSE(depth.occludes(behind));
    EXPECT_TRUE(depth.count_drawn(kEnough));
    EXPECT_TRUE(depth.occludes(behind));
    EXPECT_FALSE(depth.occludes(AlignedBox3d(Vector3d(-1, -1, -9), Vector3d(1, 1, -7))));

    fill(target, kWidth / 2, kWidth / 2 + 1, 30.0);  // a gap, one pixel wide
    depth.begin(target, clip_campus());
    EXPECT_FALSE(depth.occludes(behind)) << "another image";
    EXPECT_TRUE(depth.count_drawn(kEnough));
    EXPECT_FALSE(depth.occludes(behind));
    EXPECT_TRUE(depth.occludes(AlignedBox3d(Vector3d(-6, -1, -14), Vector3d(-4, 1, -12)))) << "beside it";
}

INSTANTIATE_TEST_SUITE_P(Samples, HierarchicalZOfTarget, testing::Values(1, 4));

std::vector<Viewpoint> views_of_the_demo() {
    std::vector<Viewpoint> views;
    for (const char* name : {"avenue", "square", "lobby"}) {
        for (int turn = 0; turn < 6; ++turn) {
            views.push_back(
                looking(demo_view(name).position, turn * std::numbers::pi / 3.0, 0.04 * (turn - 2), kFov));
        }
    }
    views.push_back(looking({0.0, 60.0, 90.0}, 0.0, -0.6, kFov));
    return views;
}

TEST(HierarchicalZ, ChangesNoPixel) {
    const std::vector<scene::Model> models = demo_models();
    for (const int samples : {1, 4}) {
        RenderSettings settings = quick_settings();
        settings.samples = samples;
        settings.occlusion_culling = false;
        Renderer all(models, settings);
        settings.occlusion_culling = true;
        Renderer seen(models, settings);
        for (const Viewpoint& view : views_of_the_demo()) {
            // Wider than the test images, so that gaps are more than a pixel.
            EXPECT_EQ(seen.draw(view, 640, 360).rgba, all.draw(view, 640, 360).rgba)
                << samples << " samples, " << view.position.transpose();
        }
    }
}

}  // namespace
}  // namespace campuswalk::engine::render::test

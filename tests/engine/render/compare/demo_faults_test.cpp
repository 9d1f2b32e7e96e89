// What the default tolerance accepts and detects on the demo campus at 1280x720.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "engine/render/compare/compare_images.h"
#include "engine/render/image/read_png.h"
#include "engine/render/renderer.h"
#include "tests/engine/render/campus_view.h"
#include "tests/engine/render/compare/synthetic_images.h"
#include "tests/engine/render/scratch_folder.h"
#include "tests/support/angles.h"

namespace campuswalk::engine::render::test {
namespace {

constexpr const char* kViews[] = {"avenue", "square", "lobby"};

/// Models and images, shared by all tests.
class DemoFaults : public testing::Test {
protected:
    static void SetUpTestSuite() {
        models_ = std::make_unique<std::vector<scene::Model>>(demo_models());
        images_ = std::make_unique<std::map<std::string, Image>>();
        renderer_ = std::make_unique<Renderer>(*models_);
        for (const char* view : kViews) {
            images_->emplace(view, draw(demo_view(view)));
        }
    }
    static void TearDownTestSuite() {
        renderer_.reset();
        models_.reset();
        images_.reset();
    }

    static Image draw(const Viewpoint& view) { return renderer_->draw(view, 1280, 720); }

    static const std::vector<scene::Model>& models() { return *models_; }
    static const Image& reference(const std::string& view) { return images_->at(view); }

    /// Whether the default tolerance is violated; prints the values.
    static bool violated(const std::string& view, const Image& image) {
        const ImageTolerance tolerance;
        const ImageComparison comparison = compare_images(reference(view), image, tolerance);
        std::printf("%-8s %8zu pixels beyond the threshold, worst tile %.4f at %d,%d\n", view.c_str(),
                    comparison.pixels.different, comparison.worst.ssim, comparison.worst.box.x,
                    comparison.worst.box.y);
        return !describe_violations(comparison, tolerance).empty();
    }

private:
    static std::unique_ptr<std::vector<scene::Model>> models_;
    static std::unique_ptr<Renderer> renderer_;
    static std::unique_ptr<std::map<std::string, Image>> images_;
};

std::unique_ptr<std::vector<scene::Model>> DemoFaults::models_;
std::unique_ptr<Renderer> DemoFaults::renderer_;
std::unique_ptr<std::map<std::string, Image>> DemoFaults::images_;

/// Draws all views in another process whose driver assumes another processor.
std::map<std::string, Image> drawn_elsewhere(const std::string& environment) {
    const ScratchFolder folder;
    std::string command = environment + " " + DRAW_DEMO_VIEW;
    for (const char* view : kViews) {
        command += std::string(" ") + view + " '" + (folder.path() / view).string() + "'";
    }
    std::map<std::string, Image> images;
    if (std::system(command.c_str()) != 0) {
        ADD_FAILURE() << command;
        return images;
    }
    for (const char* view : kViews) {
        images.emplace(view, read_png(folder.path() / view));
    }
    return images;
}

TEST_F(DemoFaults, AcceptAnotherProcessor) {
    bool any_differs = false;
    // Not with LP_NATIVE_VECTOR_WIDTH=128: on a processor with AVX-512, Mesa 22.3.6 then writes out of
    // bounds.
    for (const std::string features : {"avx", "sse4.1"}) {
        for (const auto& [view, image] : drawn_elsewhere("GALLIUM_OVERRIDE_CPU_CAPS=" + features)) {
            EXPECT_FALSE(violated(view, image)) << features << " " << view;
            any_differs = any_differs || image.rgba != reference(view).rgba;
        }
    }
    EXPECT_TRUE(any_differs) << "no setting changed the image";
}

TEST_F(DemoFaults, AcceptSomePixelsOffByFifteenLevels) {
    std::mt19937 random(11);
    for (const char* view : kViews) {
        for (int draw = 0; draw < 5; ++draw) {
            EXPECT_FALSE(violated(view, disturbed(reference(view), 0.0024, 15, random)));
        }
    }
}

TEST_F(DemoFaults, DetectMissingShadows) {
    RenderSettings settings;
    settings.shadows = false;
    EXPECT_TRUE(violated("avenue", draw_demo(models(), demo_view("avenue"), settings)));
    EXPECT_TRUE(violated("square", draw_demo(models(), demo_view("square"), settings)));
}

TEST_F(DemoFaults, DetectASunOffByThreeDegrees) {
    for (const double turn : {3.0, -3.0}) {
        RenderSettings settings;
        settings.to_sun =
            Eigen::AngleAxisd(support::radians(turn), Eigen::Vector3d::UnitY()) * settings.to_sun;
        EXPECT_TRUE(violated("avenue", draw_demo(models(), demo_view("avenue"), settings)));
        EXPECT_TRUE(violated("square", draw_demo(models(), demo_view("square"), settings)));
    }
}

TEST_F(DemoFaults, DetectMissingTrees) {
    std::vector<scene::Model> without = models();
    int removed = 0;
    for (scene::Model& model : without) {
        for (scene::Node& node : model.nodes) {
            if (node.name.starts_with("tree_cherry")) {
                node.meshes.clear();
                ++removed;
            }
        }
    }
    ASSERT_GT(removed, 5);
    EXPECT_TRUE(violated("square", draw_demo(without, demo_view("square"))));
}

TEST_F(DemoFaults, DetectACameraOffByTwoCentimetres) {
    for (const char* view : kViews) {
        for (const Eigen::Vector3d& offset :
             {Eigen::Vector3d(0.02, 0, 0), Eigen::Vector3d(0, 0.02, 0), Eigen::Vector3d(0, 0, 0.02)}) {
            Viewpoint moved = demo_view(view);
            moved.position += offset;
            EXPECT_TRUE(violated(view, draw(moved))) << view << " by " << offset.transpose();
        }
    }
}

TEST_F(DemoFaults, DetectASwappedTexture) {
    std::vector<scene::Model> swapped = models();
    std::vector<scene::Texture>& textures = swapped.front().textures;
    const auto named = [&](const char* part) {
        return std::ranges::find_if(textures, [&](const scene::Texture& texture) {
            return texture.name.find(part) != std::string::npos;
        });
    };
    ASSERT_NE(named("slabs"), textures.end());
    ASSERT_NE(named("setts"), textures.end());
    *named("slabs") = scene::Texture(*named("setts"));
    EXPECT_TRUE(violated("square", draw_demo(swapped, demo_view("square"))));
}

}  // namespace
}  // namespace campuswalk::engine::render::test

#include "engine/render/geometry/overlay_lines.h"

#include <memory>
#include <span>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "collision/mesh/mesh_collider.h"
#include "collision/world/broad_phase.h"
#include "engine/render/renderer.h"
#include "tests/engine/render/color_names.h"
#include "tests/engine/render/small_scenes.h"
#include "tests/support/mesh_pieces.h"

namespace campuswalk::engine::render::test {
namespace {

using collision::Detection;
using Eigen::Vector3d;

constexpr std::array<float, 3> kPure = {1, 0, 0};

std::vector<OverlayLine> outline(const collision::Shape& shape, const collision::Pose& pose = {}) {
    std::vector<OverlayLine> lines;
    add_outline(shape, pose, kPure, lines);
    return lines;
}

double length(const std::vector<OverlayLine>& lines) {
    double sum = 0.0;
    for (const OverlayLine& line : lines) {
        sum += (line.b - line.a).norm();
    }
    return sum;
}

std::shared_ptr<const collision::MeshCollider> mesh_of(const scene::Model& model) {
    collision::TriangleMesh mesh{model.meshes[0].positions, model.meshes[0].triangles};
    return std::make_shared<collision::MeshCollider>(std::move(mesh));
}

TEST(OverlayLines, ABoxIsDrawnAsTwelveEdges) {
    collision::Pose pose;
    pose.rotation = Eigen::AngleAxisd(0.7, Vector3d::UnitY()).toRotationMatrix();
    pose.translation = {5, 0, 0};
    const auto lines = outline(collision::Box{{1, 2, 3}}, pose);
    EXPECT_EQ(lines.size(), 12U);
    EXPECT_NEAR(length(lines), 4 * (2 + 4 + 6), 1e-9);
    for (const OverlayLine& line : lines) {
        EXPECT_TRUE(pose.inverse_apply(line.a).cwiseAbs().isApprox(Vector3d(1, 2, 3), 1e-9));
    }
}

TEST(OverlayLines, RoundShapesAreDrawnOnTheirSurface) {
    for (const OverlayLine& line : outline(collision::Sphere{2.0})) {
        EXPECT_NEAR(line.a.norm(), 2.0, 1e-9);
    }
    for (const OverlayLine& line : outline(collision::Capsule{0.5, 1.0})) {
        const Vector3d on_axis(0.0, std::clamp(line.a.y(), -1.0, 1.0), 0.0);
        EXPECT_NEAR((line.a - on_axis).norm(), 0.5, 1e-9);
    }
    for (const OverlayLine& line : outline(collision::Wheel{0.7, 0.2})) {
        EXPECT_NEAR(line.a.tail<2>().norm(), 0.7, 1e-9);
        EXPECT_NEAR(std::abs(line.a.x()), 0.2, 1e-9);
    }
}

TEST(OverlayLines, AMeshIsDrawnAsBordersAndCreases) {
    // A box of twelve triangles: its diagonals are flat.
    const auto box = outline(mesh_of(SceneBuilder().colored(kRed).box({0, 0, 0}, {1, 2, 3}).model()));
    EXPECT_EQ(box.size(), 12U);
    EXPECT_NEAR(length(box), 4 * (1 + 2 + 3), 1e-5);
    const auto sheet = outline(mesh_of(SceneBuilder().colored(kRed).upright({0, 0, 0}, 2.0).model()));
    EXPECT_EQ(sheet.size(), 4U);
    EXPECT_NEAR(length(sheet), 8.0, 1e-5);
}

TEST(OverlayLines, FollowTheSelectedOverlays) {
    scene::Campus campus = campus_of(tower_scene());
    campus.world.add({.shape = collision::Box{}, .X_world_shape = {}, .detection = Detection::solid});
    campus.world.add({.shape = collision::Box{}, .X_world_shape = {}, .detection = Detection::trigger});
    const std::vector<Vector3d> path = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    const auto count = [&](const ImageOverlays& overlays) {
        return overlay_lines(campus, overlays, path, std::span(path).first(1)).size();
    };
    EXPECT_EQ(count({}), 0U);
    EXPECT_EQ(count({.colliders = true}), 12U);
    EXPECT_EQ(count({.colliders = true, .triggers = true}), 24U);
    EXPECT_EQ(count({.path = true}), 2U);
    EXPECT_GT(count({.contacts = true}), 24U);
}

TEST(OverlayLines, ShowOfCollidersAndTheirMeshesWhatIsWithinABox) {
    scene::Campus campus = campus_of(tower_scene());
    collision::TriangleMesh mesh;
    campuswalk::support::add_box(mesh, {0, 0, 0}, {1, 1, 1});
    campuswalk::support::add_box(mesh, {8, 0, 0}, {9, 1, 1});
    campus.world.add({.shape = std::make_shared<const collision::MeshCollider>(mesh),
                      .X_world_shape = {.translation = {0, 20, 0}},
                      .detection = Detection::solid});
    campus.world.add({.shape = collision::Box{}, .X_world_shape = {}, .detection = Detection::solid});
    campus.objects.resize(2);
    campus.objects[1].nodes.roots.resize(1);
    const auto count = [&](const collision::Aabb& within) {
        return overlay_lines(campus, {.colliders = true}, {}, {}, within).size();
    };
    EXPECT_EQ(count({{-2, 19, -2}, {2, 22, 2}}), 12U) << "one box of the mesh, which is moved up";
    EXPECT_EQ(count({{-2, -1, -2}, {20, 22, 2}}), 36U);
    EXPECT_EQ(count({{3, 3, 3}, {4, 4, 4}}), 0U);
    campus.objects[1].nodes.roots.clear();  // a box of which there is nothing else to see
    const collision::Aabb about_box{{-2, -1, -2}, {2, 2, 2}};
    EXPECT_GT(count(about_box), 60U);
    for (const OverlayLine& line : overlay_lines(campus, {.colliders = true}, {}, {}, about_box)) {
        EXPECT_NEAR(line.a.cwiseAbs().maxCoeff(), 0.5, 1e-12) << "on its faces";
        EXPECT_NEAR(line.b.cwiseAbs().maxCoeff(), 0.5, 1e-12);
    }
}

TEST(OverlayLines, TreeBoxesShrinkByLevelAndEncloseTheMesh) {
    scene::Campus campus = campus_of(tower_scene());
    collision::TriangleMesh mesh;
    campuswalk::support::add_box(mesh, {0, 0, 0}, {1, 2, 1});
    campuswalk::support::add_box(mesh, {3, 0, 0}, {4, 8, 1});
    campuswalk::support::add_box(mesh, {0, 6, 5}, {4, 8, 6});
    campus.world.add({.shape = std::make_shared<const collision::MeshCollider>(mesh),
                      .X_world_shape = {},
                      .detection = Detection::solid});
    const auto boxes = [&](int level) {
        std::vector<OverlayLine> lines;
        add_tree_boxes(campus, level, lines);
        return lines;
    };
    EXPECT_EQ(boxes(0).size(), 12U);
    EXPECT_GT(length(boxes(0)), 4 * (4 + 8 + 6) - 0.1) << "around all of it";
    EXPECT_LT(length(boxes(0)), 1.4 * 4 * (4 + 8 + 6));
    EXPECT_GT(boxes(1).size(), 12U);
    EXPECT_LT(length(boxes(1)) / static_cast<double>(boxes(1).size()), length(boxes(0)) / 12);
    EXPECT_EQ(boxes(40).size(), boxes(30).size()) << "no deeper than the leaves";
}

TEST(OverlayLines, AreFaintWhereOccluded) {
    const scene::Model model =
        SceneBuilder().colored({0.05F, 0.05F, 0.05F, 1}).upright({0, 0, -6}, 4.0).model();
    Renderer renderer(std::span(&model, 1), quick_settings());
    const auto redness = [&](double z) {
        const std::vector<OverlayLine> lines = {{{-1, 0.01, z}, {1, 0.01, z}, kPure}};
        const Image image = renderer.draw(ahead(), kWidth, kHeight, {}, lines);
        const auto [r, g, b] = image.pixel(80, 44);
        return r - g;
    };
    const int before = redness(-5.0);
    const int on = redness(-6.0);
    const int behind = redness(-7.0);
    EXPECT_GT(before, 120);
    EXPECT_GT(on, 120) << "a line on a surface is in front of it";
    EXPECT_GT(behind, 10);
    EXPECT_LT(behind, before / 2 + 30);
}

}  // namespace
}  // namespace campuswalk::engine::render::test

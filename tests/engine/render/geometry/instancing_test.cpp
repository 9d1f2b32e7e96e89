#include "engine/render/geometry/instancing.h"

#include <cmath>
#include <numbers>
#include <set>
#include <span>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "engine/render/geometry/sky_view.h"
#include "engine/render/renderer.h"
#include "scene/import/source/mirror_meshes.h"
#include "tests/engine/render/small_scenes.h"

namespace campuswalk::engine::render::test {
namespace {

using Eigen::Vector3d;

constexpr int kSides = 30;
constexpr std::size_t kBallTriangles = std::size_t{2} * kSides * kSides;

// A sphere of radius 1 on the ground with kBallTriangles triangles.
scene::Mesh ball(std::uint32_t material) {
    scene::Mesh mesh;
    mesh.material = scene::MaterialIndex{material};
    for (int ring = 0; ring <= kSides; ++ring) {
        for (int side = 0; side <= kSides; ++side) {
            const double down = std::numbers::pi * ring / kSides;
            const double round = 2.0 * std::numbers::pi * side / kSides;
            const Vector3d n(std::sin(down) * std::cos(round), std::cos(down),
                             -std::sin(down) * std::sin(round));
            mesh.positions.push_back((n + Vector3d::UnitY()).cast<float>());
            mesh.normals.push_back(n.cast<float>());
            mesh.uvs.emplace_back(static_cast<float>(side) / kSides, static_cast<float>(ring) / kSides);
        }
    }
    for (std::uint32_t ring = 0; ring < kSides; ++ring) {
        for (std::uint32_t side = 0; side < kSides; ++side) {
            const std::uint32_t a = ring * (kSides + 1) + side;
            const std::uint32_t b = a + kSides + 1;
            mesh.triangles.push_back({a, b, b + 1});
            mesh.triangles.push_back({a, b + 1, a + 1});
        }
    }
    return mesh;
}

// Rows of balls on a square, turned and scaled, some mirrored, some stretched; every second one has a texture
// with holes.
scene::Model balls() {
    scene::Model model = SceneBuilder()
                             .colored(kGrey)
                             .ground(80.0)
                             .colored(kRed, four_blocks())
                             .box({-40, 0, -41}, {40, 3, -40})
                             .colored({1, 1, 1, 1}, half_clear())
                             .alpha(scene::AlphaMode::mask)
                             .double_sided()
                             .upright({0, -1, 0}, 0.5)
                             .model();
    const auto first = static_cast<std::uint32_t>(model.meshes.size());
    model.meshes.push_back(ball(1));
    model.meshes.push_back(ball(2));
    for (int i = 0; i < 120; ++i) {
        scene::Node node;
        node.name = "ball";
        node.meshes.push_back(scene::MeshIndex{first + static_cast<std::uint32_t>(i % 2)});
        const int row = i / 12;
        const double height = i % 11 == 5 ? 1.7 : 1.0;
        const double mirrored = i % 7 < 2 ? -1.0 : 1.0;
        node.X_world_node =
            (Eigen::Translation3d(4.0 * (i % 12) - 22.0, 0, 4.0 * row - 20.0) *
             Eigen::AngleAxisd(0.7 * i, Vector3d::UnitY()) * Eigen::Scaling(0.5 + 0.1 * (i % 9)) *
             Eigen::Scaling(Vector3d(mirrored, height, 1.0)))
                .matrix();
        model.nodes.push_back(node);
    }
    scene::mirror_meshes(model);
    return model;
}

const std::array<Viewpoint, 3> kViews = {looking({0.5, 1.7, 24}, 0.1, -0.05, kFov),
                                         looking({-6, 2.5, 2}, 1.9, -0.2, kFov),
                                         looking({3, 30, 20}, 0.0, -0.9, kFov)};

RenderSettings settings_with(bool instancing, int samples = 1) {
    RenderSettings settings = quick_settings();
    settings.instancing = instancing;
    settings.samples = samples;
    return settings;
}

TEST(Instancing, StoresAMeshOnceAndDrawsEveryPlacement) {
    const scene::Model model = balls();
    const CampusGeometry baked = bake(std::span(&model, 1), 20.0, false);
    const CampusGeometry shared = bake(std::span(&model, 1), 20.0);
    EXPECT_EQ(baked.instances.size(), 1U);
    EXPECT_LT(shared.vertices.size(), baked.vertices.size() / 5);
    std::size_t drawn = 0;
    std::multiset<std::uint32_t> nodes;
    for (const Batch& batch : shared.batches) {
        drawn += batch.count * batch.instances;
        for (std::size_t i = 0; batch.count == 3 * kBallTriangles && i < batch.instances; ++i) {
            nodes.insert(shared.instances[batch.first_instance + i].node);
        }
    }
    EXPECT_EQ(drawn, baked.indices.size());
    EXPECT_GT(nodes.size(), 80U);
    EXPECT_EQ(std::set(nodes.begin(), nodes.end()).size(), nodes.size()) << "each node once";
}

TEST(Instancing, BatchBoundsEncloseAllInstances) {
    const scene::Model model = balls();
    const CampusGeometry shared = bake(std::span(&model, 1), 20.0);
    for (const Batch& batch : shared.batches) {
        for (std::size_t i = 0; i < batch.instances; ++i) {
            const Eigen::Affine3d X = placement_of(shared.instances[batch.first_instance + i]);
            for (std::size_t k = batch.first; k < batch.first + batch.count; ++k) {
                const Vector3d p =
                    X * Eigen::Vector3f(shared.vertices[shared.indices[k]].position.data()).cast<double>();
                EXPECT_LT(batch.bounds.exteriorDistance(p), 1e-4);
            }
        }
        EXPECT_TRUE(batch.instances == 1 || batch.bounds.sizes().x() < 26.0)
            << "larger than a cell and a ball";
    }
}

TEST(Instancing, DrawsTheSameImageAsBaking) {
    const scene::Model model = balls();
    for (const int samples : {1, 4}) {
        Renderer baked(std::span(&model, 1), settings_with(false, samples));
        Renderer shared(std::span(&model, 1), settings_with(true, samples));
        for (const Viewpoint& view : kViews) {
            const Image a = baked.draw(view, 2 * kWidth, 2 * kHeight);
            const Image b = shared.draw(view, 2 * kWidth, 2 * kHeight);
            std::size_t differing = 0;  // values that differ by more than one level
            for (std::size_t i = 0; i < a.rgba.size(); ++i) {
                differing += std::abs(int{a.rgba[i]} - int{b.rgba[i]}) > 1 ? 1U : 0U;
            }
            // An edge may move across a pixel centre.
            EXPECT_LT(differing, a.rgba.size() / 2000) << samples << " samples";
        }
    }
}

TEST(Instancing, KeepsNodeNumbersOfPixels) {
    const scene::Model model = balls();
    Renderer baked(std::span(&model, 1), settings_with(false));
    Renderer shared(std::span(&model, 1), settings_with(true));
    const ChannelChoice all = {.nodes = true, .depth = true, .normals = true};
    for (const Viewpoint& view : kViews) {
        const Channels a = baked.draw_channels(view, kWidth, kHeight, all);
        const Channels b = shared.draw_channels(view, kWidth, kHeight, all);
        std::size_t edges = 0;
        for (std::size_t i = 0; i < a.nodes.size(); ++i) {
            if (a.nodes[i] != b.nodes[i]) {
                ++edges;
                continue;
            }
            EXPECT_NEAR(a.depth[i], b.depth[i], 1e-3 * a.depth[i]) << "pixel " << i;
        }
        EXPECT_LE(edges, a.nodes.size() / 2000);
        EXPECT_GT(std::set(b.nodes.begin(), b.nodes.end()).size(), 20U);
    }
}

TEST(Instancing, KeepsTheSkyViewFactor) {
    const scene::Model model = balls();
    const CampusGeometry baked = bake(std::span(&model, 1), 20.0, false);
    const CampusGeometry shared = bake(std::span(&model, 1), 20.0);
    for (const Vector3d& eye : {Vector3d(0, 0.2, 0), Vector3d(-3.5, 0.1, 2.2), Vector3d(5, 0.2, -7)}) {
        const double open = sky_view_factor(baked, eye - baked.origin);
        EXPECT_EQ(sky_view_factor(shared, eye - shared.origin), open);
        EXPECT_LT(open, 1.0);
    }
}

TEST(Instancing, AppliesToFrequentMeshesOnly) {
    scene::Model model;
    model.materials.resize(2);
    model.materials[1].alpha_mode = scene::AlphaMode::blend;
    model.meshes = {ball(0), ball(0), ball(1)};
    const auto place = [&](std::uint32_t mesh, int times) {
        for (int i = 0; i < times; ++i) {
            model.nodes.emplace_back().meshes.push_back(scene::MeshIndex{mesh});
        }
    };
    place(0, 5);
    place(1, 60);
    place(2, 60);
    EXPECT_EQ(meshes_to_instance(model), (std::vector{false, true, false}));
}

TEST(Instancing, BakesStretchedOrFlattenedPlacements) {
    Eigen::Matrix4d first = Eigen::Matrix4d::Identity();
    first(0, 3) = 7.0;
    InstancedMesh mesh(first, 1);
    Eigen::Matrix4d stretched = first;
    stretched(1, 1) = 1.01;
    EXPECT_FALSE(mesh.add(stretched, 2));
    Eigen::Matrix4d larger = first;
    larger.topLeftCorner<3, 3>() *= 3.0;
    EXPECT_TRUE(mesh.add(larger, 3));
    ASSERT_EQ(mesh.instances().size(), 2U);
    EXPECT_EQ(mesh.instances()[1].node, 3U);
    Eigen::Matrix4d flat = first;
    flat(2, 2) = 0.0;
    EXPECT_FALSE(InstancedMesh(flat, 1).add(flat, 2));
    EXPECT_FALSE(mesh.add(flat, 4));
}

}  // namespace
}  // namespace campuswalk::engine::render::test

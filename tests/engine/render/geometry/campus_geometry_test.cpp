#include "engine/render/geometry/campus_geometry.h"

#include <span>

#include <gtest/gtest.h>

#include "tests/engine/render/small_scenes.h"

namespace campuswalk::engine::render::test {
namespace {

using Eigen::Vector3d;

CampusGeometry baked(const scene::Model& model, double cell_size = 20.0) {
    return bake(std::span(&model, 1), cell_size);
}

Vector3d vertex(const CampusGeometry& geometry, std::uint32_t index) {
    const auto& p = geometry.vertices[index].position;
    return geometry.origin + Vector3d(p[0], p[1], p[2]);
}

// Six times the volume of a closed body whose faces point outwards.
double flux(const CampusGeometry& geometry, const Vector3d& centre) {
    double sum = 0.0;
    for (std::size_t i = 0; i < geometry.indices.size(); i += 3) {
        const Vector3d a = vertex(geometry, geometry.indices[i]);
        const Vector3d b = vertex(geometry, geometry.indices[i + 1]);
        const Vector3d c = vertex(geometry, geometry.indices[i + 2]);
        sum += (b - a).cross(c - a).dot(a - centre);
    }
    return sum;
}

TEST(CampusGeometry, PlacesEveryTriangleInTheWorld) {
    Eigen::Matrix4d moved = Eigen::Matrix4d::Identity();
    moved.topRightCorner<3, 1>() = Vector3d(100, 2, -30);
    const auto geometry =
        baked(SceneBuilder().colored(kRed).placed(moved).box({-1, 0, -1}, {1, 4, 1}).model());
    EXPECT_EQ(geometry.indices.size(), 36U);
    EXPECT_TRUE(geometry.bounds.min.isApprox(Vector3d(99, 2, -31)));
    EXPECT_TRUE(geometry.bounds.max.isApprox(Vector3d(101, 6, -29)));
    EXPECT_TRUE(geometry.origin.isApprox(Vector3d(100, 4, -30)));
    for (const std::uint32_t index : geometry.indices) {
        const Vector3d p = vertex(geometry, index);
        EXPECT_NEAR(std::abs(p.x() - 100.0), 1.0, 1e-5);
    }
}

TEST(CampusGeometry, FlipsTheWindingOfMirroredNodes) {
    for (const double sign : {1.0, -1.0}) {
        Eigen::Matrix4d placed = Eigen::Matrix4d::Identity();
        placed(0, 0) = 2.0 * sign;
        const auto geometry =
            baked(SceneBuilder().colored(kRed).placed(placed).box({-1, -1, -1}, {1, 1, 1}).model());
        EXPECT_NEAR(flux(geometry, Vector3d::Zero()), 6.0 * 16.0, 1e-4) << "six times the volume, outwards";
        for (const Vertex& v : geometry.vertices) {
            const Vector3d p(v.position[0], v.position[1], v.position[2]);
            EXPECT_GT(p.dot(Vector3d(v.normal[0], v.normal[1], v.normal[2])), 0.0);
        }
    }
}

TEST(CampusGeometry, SortsAllTrianglesIntoCells) {
    SceneBuilder scene;
    scene.colored(kRed).colored(kBlue);
    for (int i = 0; i < 10; ++i) {
        scene.box({10.0 * i, 0, 0}, {10.0 * i + 1, 1, 1});
    }
    const auto geometry = baked(scene.model(), 20.0);
    EXPECT_GT(geometry.batches.size(), 3U);
    std::size_t next = 0;
    for (const Batch& batch : geometry.batches) {
        EXPECT_EQ(batch.first, next) << "batches follow each other";
        next += batch.count;
        EXPECT_LT(batch.bounds.sizes().x(), 22.0);
        for (std::size_t i = batch.first; i < next; ++i) {
            const auto& p = geometry.vertices[geometry.indices[i]].position;
            EXPECT_TRUE(batch.bounds.contains(Vector3d(p[0], p[1], p[2])));
        }
    }
    EXPECT_EQ(next, geometry.indices.size());
    EXPECT_EQ(next, 10U * 36U);
}

TEST(CampusGeometry, SeparatesBlendedTriangles) {
    const auto geometry = baked(SceneBuilder()
                                    .colored(kRed)
                                    .box({0, 0, 0}, {1, 1, 1})
                                    .colored({1, 1, 1, 0.3F})
                                    .alpha(scene::AlphaMode::blend)
                                    .upright({0, 0, 3}, 1.0)
                                    .model());
    EXPECT_EQ(geometry.blend.size(), 2U);
    EXPECT_EQ(geometry.indices.size(), 36U);
}

TEST(CampusGeometry, IsEmptyWithoutModels) {
    const auto geometry = bake({}, 20.0);
    EXPECT_TRUE(geometry.bounds.empty());
    EXPECT_TRUE(geometry.batches.empty());
    EXPECT_TRUE(geometry.origin.isZero());
}

TEST(CampusGeometry, DrawsMeshesWithoutNormalsUvsOrAKnownMaterial) {
    scene::Model model = SceneBuilder().colored(kRed).box({0, 0, 0}, {1, 1, 1}).model();
    model.meshes[0].normals.clear();
    model.meshes[0].uvs.clear();
    model.meshes[0].material = scene::MaterialIndex{99};
    const auto geometry = baked(model);
    EXPECT_EQ(geometry.indices.size(), 36U);
    ASSERT_LT(geometry.batches.at(0).material, geometry.materials.size());
    EXPECT_EQ(geometry.materials[geometry.batches[0].material].material.base_color, (Color{1, 1, 1, 1}));
}

}  // namespace
}  // namespace campuswalk::engine::render::test

#include "scene/suggest/first_view.h"

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "collision/mesh/mesh_collider.h"
#include "scene/model/world_triangles.h"
#include "tests/scene/box_model.h"

namespace campuswalk::scene {
namespace {

using Eigen::Vector3d;

/// The model's triangles as one solid mesh, whose own origin is at `origin`.
collision::World world_of(const Model& model, const Vector3d& origin = Vector3d::Zero()) {
    collision::TriangleMesh mesh;
    for (const Node& node : model.nodes) {
        for_each_triangle(model, node, [&](const auto& a, const auto& b, const auto& c) {
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            for (const Vector3d& p : {a, b, c}) {
                mesh.positions.push_back(p.template cast<float>());
            }
            mesh.triangles.push_back({first, first + 1, first + 2});
        });
    }
    collision::World world(std::make_unique<collision::LinearBroadPhase>());
    collision::Object object;
    object.shape = std::make_shared<const collision::MeshCollider>(std::move(mesh));
    object.X_world_shape.translation = origin;
    world.add(object);
    return world;
}

double degrees_of(const Model& model, const Vector3d& foot, const Vector3d& target) {
    return first_view(world_of(model), foot, target) * 180.0 / std::numbers::pi;
}

TEST(FirstView, FacesTheTargetInTheOpen) {
    Model model;
    test::add_box(model, "lawn", {-50, -0.2, -50}, {50, 0, 50});
    EXPECT_NEAR(degrees_of(model, {0, 0, 0}, {0, 5, -30}), 0.0, 1e-9);
    EXPECT_NEAR(degrees_of(model, {0, 0, 0}, {-30, 5, 0}), 90.0, 1e-9);  // grows to the left
    EXPECT_NEAR(degrees_of(model, {0, 0, 0}, {30, 5, 0}), -90.0, 1e-9);
    EXPECT_NEAR(std::abs(degrees_of(model, {0, 0, 0}, {0, 5, 30})), 180.0, 1e-9);
}

TEST(FirstView, AvoidsFacingANearbyWall) {
    Model model;
    test::add_box(model, "wall", {-50, 0, -2}, {50, 5, -1.5});
    const double yaw = degrees_of(model, {0, 0, 0}, {0, 2, -30});
    EXPECT_GE(std::abs(yaw), 80.0);  // the target is behind the wall: looks along it, not away
    EXPECT_LE(std::abs(yaw), 120.0);
}

TEST(FirstView, FacesTheOpenEndOfACorridor) {
    Model model;  // 2 m wide, closed but towards +x
    test::add_box(model, "north", {-10, 0, -1.2}, {10, 3, -1});
    test::add_box(model, "south", {-10, 0, 1}, {10, 3, 1.2});
    test::add_box(model, "west", {-10.2, 0, -1.2}, {-10, 3, 1.2});
    EXPECT_NEAR(degrees_of(model, {-5, 0, 0}, {-5, 0, 0}), -90.0, 1e-9);
}

TEST(FirstView, IsIndependentOfTheMeshOrigin) {
    Model model;
    test::add_box(model, "wall", {-50, 0, -2}, {50, 5, -1.5});
    const Vector3d origin(84000, 3, 447000);
    const double here = first_view(world_of(model), {0, 0, 0}, {9, 0, -9});
    const double there = first_view(world_of(model, origin), origin, origin + Vector3d(9, 0, -9));
    EXPECT_EQ(here, there);
}

}  // namespace
}  // namespace campuswalk::scene

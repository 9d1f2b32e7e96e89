#include "scene/campus/collider_shapes.h"

#include <cmath>

#include <gtest/gtest.h>

#include "collision/mesh/mesh_collider.h"
#include "scene/model/node_frame.h"

namespace campuswalk::scene {
namespace {

using collision::Vec3;

/// The vertices of a box of edge lengths `size` about the frame's point `centre`, with arbitrary triangles.
ShapeSource box_source(const collision::Pose& frame, const Vec3& centre, const Vec3& size) {
    ShapeSource source;
    source.frame = frame;
    source.has_nodes = true;
    for (int vertex = 0; vertex < 8; ++vertex) {
        Vec3 p = centre;
        for (int axis = 0; axis < 3; ++axis) {
            p[axis] += size[axis] * ((vertex >> axis & 1) != 0 ? 0.5 : -0.5);
        }
        source.geometry.positions.push_back(frame * p);
    }
    for (std::uint32_t i = 0; i + 2 < 8; ++i) {
        source.geometry.triangles.push_back({i, i + 1, i + 2});
    }
    return source;
}

collision::Pose turned(double yaw, const Vec3& at) {
    collision::Pose pose;
    pose.rotation = rotation_about_y(yaw);
    pose.translation = at;
    return pose;
}

void expect_at(const PlacedShape& placed, const Vec3& point) {
    EXPECT_LT((placed.X_world_shape.translation - point).norm(), 1e-9)
        << placed.X_world_shape.translation.transpose();
}

TEST(PlaceShape, BoxIsFittedInTheNodesFrame) {
    const auto frame = turned(0.4, {10, 0, -5});
    const auto placed = place_shape(BoxShape{}, box_source(frame, {0, 0.5, 0}, {2, 1, 0.5}));
    ASSERT_TRUE(placed);
    const auto& box = std::get<collision::Box>(placed->shape);
    EXPECT_LT((box.half_extents - Vec3(1, 0.5, 0.25)).norm(), 1e-9);
    expect_at(*placed, frame * Vec3(0, 0.5, 0));
    EXPECT_LT((placed->X_world_shape.rotation - frame.rotation).norm(), 1e-12);
}

TEST(PlaceShape, BoxByNumbersIsInTheWorld) {
    BoxShape shape;
    shape.center = Vec3(11, 1.2, -7);
    shape.size = Vec3(2, 2.4, 4);
    shape.yaw = 0.3;
    EXPECT_TRUE(is_placed_by_numbers(shape));
    const auto placed = place_shape(shape, ShapeSource{});
    ASSERT_TRUE(placed);
    EXPECT_EQ(std::get<collision::Box>(placed->shape).half_extents, Vec3(1, 1.2, 2));
    expect_at(*placed, {11, 1.2, -7});
    EXPECT_LT((placed->X_world_shape.rotation - rotation_about_y(0.3)).norm(), 1e-12);
}

TEST(PlaceShape, NumbersWithNodesAreInTheNodesFrame) {
    const auto frame = turned(0.4, {10, 0, -5});
    BoxShape shape;
    shape.center = Vec3(0, 1, 2);
    shape.size = Vec3(1, 1, 1);
    const auto placed = place_shape(shape, box_source(frame, Vec3::Zero(), {2, 1, 0.5}));
    ASSERT_TRUE(placed);
    expect_at(*placed, frame * Vec3(0, 1, 2));
}

TEST(PlaceShape, AFlatBoxKeepsSomeThickness) {
    const auto placed = place_shape(BoxShape{}, box_source({}, Vec3::Zero(), {1, 2, 0}));
    ASSERT_TRUE(placed);
    EXPECT_EQ(std::get<collision::Box>(placed->shape).half_extents, Vec3(0.5, 1, 0.0005));
}

TEST(PlaceShape, SphereReachesTheFarthestVertex) {
    const auto placed = place_shape(SphereShape{}, box_source(turned(0.4, {1, 2, 3}), {0, 1, 0}, {2, 2, 2}));
    ASSERT_TRUE(placed);
    EXPECT_NEAR(std::get<collision::Sphere>(placed->shape).radius, std::sqrt(3.0), 1e-9);
    expect_at(*placed, {1, 3, 3});
}

TEST(PlaceShape, CapsuleStandsOnTheNodesOrigin) {
    // A tree whose roots reach 0.2 m below the ground that its origin lies on.
    const auto source = box_source(turned(0, {5, 1, 5}), {0, 1.9, 0}, {1, 4.2, 1});
    CapsuleShape shape;
    shape.radius = 0.25;
    shape.height = 3.0;
    const auto placed = place_shape(shape, source);
    ASSERT_TRUE(placed);
    const auto& capsule = std::get<collision::Capsule>(placed->shape);
    EXPECT_EQ(capsule.radius, 0.25);
    EXPECT_EQ(capsule.half_length, 1.25);
    expect_at(*placed, {5, 2.5, 5});

    const auto fitted = place_shape(CapsuleShape{}, source);
    ASSERT_TRUE(fitted);
    EXPECT_NEAR(std::get<collision::Capsule>(fitted->shape).radius, 0.5, 1e-9);
    EXPECT_NEAR(std::get<collision::Capsule>(fitted->shape).half_length, 1.5,
                1e-9);  // 4 m from origin to top
    expect_at(*fitted, {5, 3, 5});
}

TEST(PlaceShape, CapsuleStandsUnderGeometryThatIsFarFromItsOrigin) {
    // Transforms applied before export leave every origin at the world's.
    const auto placed = place_shape(CapsuleShape{}, box_source({}, {30, 2, -40}, {1, 4, 1}));
    ASSERT_TRUE(placed);
    expect_at(*placed, {30, 2, -40});
}

TEST(PlaceShape, CapsuleOnAnEmptyNodeNeedsRadiusAndHeight) {
    ShapeSource source;
    source.frame.translation = Vec3(1, 0, 1);
    source.has_nodes = true;
    EXPECT_FALSE(place_shape(CapsuleShape{}, source));
    CapsuleShape shape;
    shape.radius = 0.25;
    shape.height = 3.0;
    const auto placed = place_shape(shape, source);
    ASSERT_TRUE(placed);
    expect_at(*placed, {1, 1.5, 1});
}

TEST(PlaceShape, WheelIsFittedAlongItsAxis) {
    WheelShape shape;
    shape.axis = Vec3::UnitY();
    const auto placed = place_shape(shape, box_source(turned(0.7, {2, 0, 2}), {0, 0.3, 0}, {3, 0.6, 4}));
    ASSERT_TRUE(placed);
    const auto& wheel = std::get<collision::Wheel>(placed->shape);
    EXPECT_NEAR(wheel.radius, 2.5, 1e-9);  // half the diagonal of 3 x 4
    EXPECT_NEAR(wheel.half_width, 0.3, 1e-9);
    EXPECT_LT((placed->X_world_shape.rotation.col(0) - Vec3::UnitY()).norm(), 1e-12);
    expect_at(*placed, {2, 0.3, 2});
}

TEST(PlaceShape, MeshIsBakedAboutItsOwnOrigin) {
    const auto placed =
        place_shape(MeshShape{}, box_source(turned(0.4, {100, 0, 0}), Vec3::Zero(), {2, 2, 2}));
    ASSERT_TRUE(placed);
    const auto& mesh = std::get<std::shared_ptr<const collision::MeshCollider>>(placed->shape);
    EXPECT_EQ(mesh->mesh().triangles.size(), 6U);
    EXPECT_EQ(mesh->mesh().positions.size(), 8U);
    expect_at(*placed, {100, 0, 0});
}

TEST(PlaceShape, FittingNeedsTriangles) {
    ShapeSource empty;
    empty.has_nodes = true;
    EXPECT_FALSE(place_shape(MeshShape{}, empty));
    EXPECT_FALSE(place_shape(BoxShape{}, empty));
    EXPECT_FALSE(place_shape(SphereShape{}, empty));
    EXPECT_FALSE(place_shape(WheelShape{}, empty));
}

}  // namespace
}  // namespace campuswalk::scene

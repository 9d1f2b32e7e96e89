#include "scene/suggest/first_view.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/scene/box_model.h"
#include "tests/scene/suggest/solid_model.h"

namespace campuswalk::scene {
namespace {

using Eigen::Vector3d;

double degrees_of(const Model& model, const Vector3d& foot, const Vector3d& target) {
    return first_view(*test::solid(model), Vector3d::Zero(), foot, target) * 180.0 / std::numbers::pi;
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
    const double here = first_view(*test::solid(model), Vector3d::Zero(), {0, 0, 0}, {9, 0, -9});
    const double there = first_view(*test::solid(model), origin, origin, origin + Vector3d(9, 0, -9));
    EXPECT_EQ(here, there);
}

}  // namespace
}  // namespace campuswalk::scene

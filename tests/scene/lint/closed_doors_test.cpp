#include "scene/lint/closed_doors.h"

#include <string>

#include <gtest/gtest.h>

#include "tests/scene/box_model.h"

namespace campuswalk::scene {
namespace {

using Eigen::Vector3d;

/// A floor, and a wall along x, 0.2 m thick, with a doorway of 1 m by 2.1 m in its middle.
struct Wall {
    bool left = true;
    bool right = true;
    bool lintel = true;
    bool floor = true;
};

Model with_wall(const Wall& wall) {
    Model model;
    test::add_group(model, "house");
    if (wall.floor) {
        test::add_box(model, "floor", {-5, -0.2, -5}, {5, 0, 5}, 0);
    }
    if (wall.left) {
        test::add_box(model, "wall_left", {-5, 0, -0.1}, {-0.5, 3, 0.1}, 0);
    }
    if (wall.right) {
        test::add_box(model, "wall_right", {0.5, 0, -0.1}, {5, 3, 0.1}, 0);
    }
    if (wall.lintel) {
        test::add_box(model, "lintel", {-0.5, 2.1, -0.1}, {0.5, 3, 0.1}, 0);
    }
    return model;
}

std::size_t count_closed(const Model& model) {
    return find_closed_doors(model).size();
}

/// A door leaf, 6 cm thick, that fills the doorway.
std::size_t add_leaf(Model& model, const std::string& name) {
    return test::add_box(model, name, {-0.48, 0.01, -0.03}, {0.48, 2.08, 0.03}, 0);
}

TEST(ClosedDoors, HavePlaceAndSize) {
    Model model = with_wall({});
    const std::size_t leaf = add_leaf(model, "door_01");
    const auto doors = find_closed_doors(model);
    ASSERT_EQ(doors.size(), 1U);
    EXPECT_EQ(doors[0].node, leaf);
    EXPECT_TRUE(doors[0].foot.isApprox(Vector3d(0, 0.01, 0), 1e-6)) << doors[0].foot;
    EXPECT_NEAR(doors[0].width, 0.96, 1e-6);
    EXPECT_NEAR(doors[0].height, 2.07, 1e-6);
}

TEST(ClosedDoors, NeedNoNameInADoorway) {
    Model model = with_wall({});
    add_leaf(model, "Cube.017");
    EXPECT_EQ(count_closed(model), 1U);
    EXPECT_EQ(count_closed(with_wall({})), 0U);  // neither lintel nor walls count
}

TEST(ClosedDoors, WithoutANameNeedACompleteDoorway) {
    for (const Wall& wall :
         {Wall{.lintel = false}, Wall{.floor = false}, Wall{.left = false}, Wall{.right = false}}) {
        Model model = with_wall(wall);
        add_leaf(model, "Cube.017");
        EXPECT_EQ(count_closed(model), 0U);
    }
}

TEST(ClosedDoors, WithANameNeedOnlyWalls) {
    Model model = with_wall({.lintel = false, .floor = false});
    add_leaf(model, "FrontDoor");
    EXPECT_EQ(count_closed(model), 1U);
    Model alone = with_wall({.right = false});
    add_leaf(alone, "FrontDoor");
    EXPECT_EQ(count_closed(alone), 0U);
}

TEST(ClosedDoors, IgnoresOpenDoors) {
    Model model = with_wall({});
    test::add_box(model, "door", {-0.5, 0.01, 0.1}, {-0.44, 2.08, 1.06}, 0);
    EXPECT_EQ(count_closed(model), 0U);
}

TEST(ClosedDoors, IgnoresDoorsInFrontOfAWall) {
    Model model = with_wall({});
    add_leaf(model, "door");
    test::add_box(model, "core", {-5, 0, -1}, {5, 3, -0.6}, 0);
    EXPECT_EQ(count_closed(model), 0U);
}

TEST(ClosedDoors, IgnoresFramesWithoutALeaf) {
    Model model = with_wall({});
    const std::size_t door = test::add_group(model, "door", 0);
    const int parent = static_cast<int>(door);
    test::add_box(model, "left", {-0.48, 0, -0.05}, {-0.42, 2.08, 0.05}, parent);
    test::add_box(model, "right", {0.42, 0, -0.05}, {0.48, 2.08, 0.05}, parent);
    test::add_box(model, "top", {-0.48, 2.0, -0.05}, {0.48, 2.08, 0.05}, parent);
    EXPECT_EQ(count_closed(model), 0U);
    test::add_box(model, "leaf", {-0.42, 0, -0.02}, {0.42, 2.0, 0.02}, parent);
    const auto doors = find_closed_doors(model);
    ASSERT_EQ(doors.size(), 1U);  // reported once, as the door
    EXPECT_EQ(doors[0].node, door);
}

TEST(ClosedDoors, AreTheDoorsOfAGroupNotTheGroup) {
    Model model = with_wall({});
    const auto doors = static_cast<int>(test::add_group(model, "Doors", 0));
    const std::size_t leaf = test::add_box(model, "Door_1", {-0.48, 0.01, -0.03}, {0.48, 2.08, 0.03}, doors);
    test::add_box(model, "Door_2", {-0.48, 0.01, 40}, {0.48, 2.08, 40.06}, doors);  // in the open
    const auto closed = find_closed_doors(model);
    ASSERT_EQ(closed.size(), 1U);
    EXPECT_EQ(closed[0].node, leaf);
}

TEST(ClosedDoors, IncludeTheirGlass) {
    Model model = with_wall({});
    const std::size_t leaf = add_leaf(model, "door");
    test::add_box(model, "door_glass", {-0.2, 1.2, -0.01}, {0.2, 1.8, 0.01}, static_cast<int>(leaf));
    ASSERT_EQ(count_closed(model), 1U);
    EXPECT_EQ(find_closed_doors(model)[0].node, leaf);
}

TEST(ClosedDoors, AreAllFoundInALargeModel) {
    Model model;
    test::add_box(model, "floor", {-5, -0.2, -5}, {2005, 0, 5});
    for (int i = 0; i < 300; ++i) {  // a corridor of doors, with piers between them
        const double x = 4.0 * i;
        test::add_box(model, "pier", {x, 0, -0.1}, {x + 3, 3, 0.1});
        test::add_box(model, "Cube", {x + 3.02, 0.01, -0.03}, {x + 3.98, 2.08, 0.03});
        test::add_box(model, "lintel", {x + 3, 2.1, -0.1}, {x + 4, 3, 0.1});
    }
    test::add_box(model, "pier", {1200, 0, -0.1}, {1203, 3, 0.1});
    EXPECT_EQ(count_closed(model), 300U);
}

TEST(ClosedDoors, AreFoundInRotatedWalls) {
    Model model;
    test::add_turned_box(model, "floor", {0, -0.1, 0}, {20, 0.2, 20}, 0);
    const double cos30 = 0.8660254037844386;
    const Vector3d along(cos30, 0, -0.5);  // +X turned by 30 degrees
    test::add_turned_box(model, "wall_a", Vector3d(0, 1.5, 0) - 2.5 * along, {4, 3, 0.2}, 30);
    test::add_turned_box(model, "wall_b", Vector3d(0, 1.5, 0) + 2.5 * along, {4, 3, 0.2}, 30);
    test::add_turned_box(model, "wall_c", Vector3d(0, 2.55, 0), {1, 0.9, 0.2}, 30);
    test::add_turned_box(model, "panel", Vector3d(0, 1.04, 0), {0.96, 2.06, 0.05}, 30);
    const auto doors = find_closed_doors(model);
    ASSERT_EQ(doors.size(), 1U);
    EXPECT_EQ(model.nodes[doors[0].node].name, "panel");
    EXPECT_NEAR(doors[0].width, 0.96, 1e-5);
}

}  // namespace
}  // namespace campuswalk::scene

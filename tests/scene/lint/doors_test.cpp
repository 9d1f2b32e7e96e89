#include "scene/lint/doors.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/scene/box_model.h"

namespace campuswalk::scene {
namespace {

TEST(Doors, AreWhatIsNamedOneAndWhatClosesADoorway) {
    Model model;
    test::add_box(model, "floor", {-5, -0.2, -5}, {5, 0, 5});
    test::add_box(model, "left", {-5, 0, -0.1}, {-0.5, 3, 0.1});
    test::add_box(model, "right", {0.5, 0, -0.1}, {5, 3, 0.1});
    test::add_box(model, "lintel", {-0.5, 2.1, -0.1}, {0.5, 3, 0.1});
    const std::size_t panel = test::add_box(model, "Cube.7", {-0.48, 0.01, -0.03}, {0.48, 2.08, 0.03});
    const std::size_t ajar = test::add_group(model, "door_2");
    test::add_box(model, "leaf", {3, 0, 2}, {3.05, 2, 3}, static_cast<int>(ajar));
    test::add_box(model, "knob", {3.05, 1, 2.1}, {3.15, 1.1, 2.2}, static_cast<int>(ajar));
    const std::vector<Door> doors = find_doors(model);
    ASSERT_EQ(doors.size(), 2U);
    EXPECT_EQ(doors[0].node, panel);
    EXPECT_TRUE(doors[0].is_closed);
    EXPECT_NEAR(doors[0].width, 0.96, 1e-6);
    EXPECT_EQ(doors[1].node, ajar);
    EXPECT_FALSE(doors[1].is_closed);
    EXPECT_NEAR(doors[1].width, 1.0, 1e-6);
    EXPECT_NEAR(doors[1].height, 2.0, 1e-6);
    EXPECT_TRUE(doors[1].foot.isApprox(Eigen::Vector3d(3.075, 0, 2.5), 1e-6)) << doors[1].foot;
}

TEST(Doors, OfOneNodeAreAsManyAsStandApart) {
    Model model;
    const std::size_t node = test::add_boxes(model, "doors",
                                             {{{0, 0, 0}, {1, 2.1, 0.05}},
                                              {{0.1, 1, 0.05}, {0.2, 1.1, 0.12}},  // with its handle
                                              {{10, 0, 0}, {11.5, 2.1, 0.05}},
                                              {{20, 0, 0}, {20.05, 2.2, 0.9}}});
    const std::vector<Door> doors = find_doors(model);
    ASSERT_EQ(doors.size(), 3U);
    std::vector<double> widths;
    for (const Door& door : doors) {
        EXPECT_EQ(door.node, node);
        widths.push_back(door.width);
    }
    std::sort(widths.begin(), widths.end());
    EXPECT_NEAR(widths[0], 0.9, 1e-5);
    EXPECT_NEAR(widths[1], 1.0, 1e-5);
    EXPECT_NEAR(widths[2], 1.5, 1e-5);
}

}  // namespace
}  // namespace campuswalk::scene

#include "scene/suggest/split_nodes.h"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "scene/model/world_triangles.h"
#include "scene/suggest/suggested_buildings.h"
#include "tests/scene/box_model.h"

namespace campuswalk::scene {
namespace {

using Eigen::Vector3d;

using test::add_boxes;
using test::Box;

std::vector<Box> six_houses_on_a_lawn() {
    std::vector<Box> boxes = {{{-80, -0.2, -80}, {80, 0, 80}}};
    for (const double x : {-60.0, -10.0, 40.0}) {
        for (const double z : {-58.0, 12.0}) {
            boxes.push_back({{x, 0, z}, {x + 20, 9, z + 16}});
        }
    }
    return boxes;
}

std::size_t count_triangles_of(const Model& model) {
    std::size_t count = 0;
    for (const Node& node : model.nodes) {
        for_each_triangle(model, node, [&](const auto&, const auto&, const auto&) { ++count; });
    }
    return count;
}

TEST(SplitNodes, KeepsEveryTriangleWhereItIs) {
    Model model;
    add_boxes(model, "Campus", six_houses_on_a_lawn());
    test::add_box(model, "kiosk", {70, 0, 70}, {75, 3, 75});
    const SplitModel split = split_nodes(model);
    EXPECT_EQ(count_triangles_of(split.model), count_triangles_of(model));
    const auto areas = [](const Model& each, const std::vector<std::size_t>* original) {
        std::map<std::size_t, double> area;
        for (std::size_t n = 0; n < each.nodes.size(); ++n) {
            for_each_triangle(each, each.nodes[n], [&](const auto& a, const auto& b, const auto& c) {
                area[original == nullptr ? n : (*original)[n]] += (b - a).cross(c - a).norm();
            });
        }
        return area;
    };
    const auto before = areas(model, nullptr);
    const auto after = areas(split.model, &split.node);
    ASSERT_EQ(before.size(), after.size());
    for (const auto& [node, area] : before) {
        EXPECT_NEAR(after.at(node), area, 1e-6 * area);
    }
    ASSERT_EQ(split.report.size(), split.model.nodes.size());
    EXPECT_EQ(split.model.nodes.size(), 2U + 7U) << "six houses and the lawn";
}

TEST(SplitNodes, LeavesRoomsAndWingsTogether) {
    Model model;
    // Two wings with a court between them.
    add_boxes(model, "Library", {{{0, 0, 0}, {20, 9, 10}}, {{0, 0, 14}, {20, 9, 24}}});
    EXPECT_EQ(split_nodes(model).model.nodes.size(), 1U);
}

TEST(SplitNodes, LeavesRocksTogether) {
    Model model;
    const std::size_t rocks = add_boxes(
        model, "scene", {{{0, 0, 0}, {5, 4, 5}}, {{40, 0, 0}, {45, 4, 5}}, {{0, 0, 60}, {5, 4, 65}}});
    // Leaning, so that no edge is level.
    Eigen::Matrix4d& X = model.nodes[rocks].X_world_node;
    const Eigen::Matrix3d lean =
        (Eigen::AngleAxisd(0.1, Vector3d::UnitZ()) * Eigen::AngleAxisd(0.1, Vector3d::UnitX())).matrix();
    X.topLeftCorner<3, 3>() = lean * X.topLeftCorner<3, 3>();
    EXPECT_EQ(split_nodes(model).model.nodes.size(), 1U);
}

TEST(SplitNodes, LeavesWhatANameCallsSurroundings) {
    Model model;
    add_boxes(model, "hedges", {{{0, 0, 0}, {5, 4, 5}}, {{40, 0, 0}, {45, 4, 5}}, {{0, 0, 60}, {5, 4, 65}}});
    EXPECT_EQ(split_nodes(model).model.nodes.size(), 1U);
}

std::vector<std::string> titles_of(const Model& model) {
    std::vector<std::string> titles;
    for (const SuggestedBuilding& building : suggest_buildings(model, report(model)).list) {
        titles.push_back(building.title);
    }
    return titles;
}

using Titles = std::vector<std::string>;

TEST(SuggestedBuildings, AreFoundInOneMesh) {
    Model model;
    add_boxes(model, "Campus", six_houses_on_a_lawn());
    const auto buildings = suggest_buildings(model, report(model)).list;
    ASSERT_EQ(buildings.size(), 6U);
    EXPECT_TRUE(buildings[0].box.center.isApprox(Vector3d(-50, 4.5, -50), 1e-6));
    EXPECT_TRUE(buildings[0].box.size.isApprox(Vector3d(20, 9, 16), 1e-6));
    for (const SuggestedBuilding& building : buildings) {
        EXPECT_TRUE(building.globs.empty()) << "no name tells " << building.id << " from the others";
    }
}

TEST(SuggestedBuildings, AreFoundWhereMeshesAreSplitByMaterial) {
    Model model;
    test::add_box(model, "grass", {-50, -0.2, -50}, {50, 0, 50});
    std::vector<Box> walls;
    std::vector<Box> roofs;
    for (const double x : {-30.0, 20.0}) {
        for (const double side : {0.0, 9.7}) {
            walls.push_back({{x + side, 0, 0}, {x + side + 0.3, 4, 10}});
            walls.push_back({{x + 0.3, 0, side}, {x + 9.7, 4, side + 0.3}});
        }
        roofs.push_back({{x, 4, 0}, {x + 10, 4.3, 10}});
    }
    add_boxes(model, "bricks", walls);
    add_boxes(model, "tiles", roofs);
    EXPECT_EQ(titles_of(model), (Titles{"Building 1", "Building 2"}));
}

TEST(SuggestedBuildings, AreCalledAsTheirNamedPartAndNeverAsAGenericOne) {
    Model model;
    test::add_box(model, "lawn", {-60, -0.2, -60}, {60, 0, 60});
    test::add_box(model, "part.57", {-20, 0, -10}, {-10, 12, 10});
    test::add_box(model, "Elm_Hall", {-10, 0, -10}, {20, 12, 10});
    EXPECT_EQ(titles_of(model), Titles{"Elm_Hall"});
}

TEST(SuggestedBuildings, AreNotCalledAsWhatIsOnTop) {
    Model model;
    add_boxes(model, "Mesh_0",
              {{{-60, -0.2, -60}, {60, 0, 60}}, {{-5, 0, -5}, {5, 70, 5}}, {{20, 0, -30}, {50, 12, -10}}});
    test::add_box(model, "clock", {-6, 70, -6}, {6, 77, 6});
    const std::vector<std::string> titles = titles_of(model);
    EXPECT_EQ(titles.size(), 2U);
    EXPECT_EQ(std::ranges::find(titles, "clock"), titles.end());
}

}  // namespace
}  // namespace campuswalk::scene

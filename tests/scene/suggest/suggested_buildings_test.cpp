#include "scene/suggest/suggested_buildings.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "scene/base/glob.h"
#include "tests/scene/box_model.h"

namespace campuswalk::scene {
namespace {

using Eigen::Vector3d;

std::vector<SuggestedBuilding> suggest(const Model& model) {
    return suggest_buildings(model, report(model)).list;
}

std::vector<std::string> ids_of(const Model& model) {
    std::vector<std::string> ids;
    for (const SuggestedBuilding& building : suggest(model)) {
        ids.push_back(building.id);
    }
    return ids;
}

using Ids = std::vector<std::string>;

/// 100 m x 100 m of lawn.
Model with_lawn() {
    Model model;
    test::add_box(model, "lawn", {-50, -0.2, -50}, {50, 0, 50});
    return model;
}

TEST(SuggestedBuildings, HaveTheSizeOfHouses) {
    Model model = with_lawn();
    test::add_box(model, "Main Library", {0, 0, 0}, {20, 9, 12});
    test::add_box(model, "kiosk", {30, 0, 0}, {33.5, 2.6, 4});
    test::add_box(model, "bench", {-9, 0, 0}, {-7, 0.8, 0.6});
    test::add_box(model, "sign", {-9, 0, 5}, {-5, 3, 5.2});
    test::add_box(model, "low", {-30, 0, 0}, {-20, 1.2, 8});
    const auto buildings = suggest(model);
    ASSERT_EQ(buildings.size(), 2U);
    EXPECT_EQ(buildings[0].id, "main-library");
    EXPECT_EQ(buildings[0].title, "Main Library");
    EXPECT_TRUE(buildings[0].box.center.isApprox(Vector3d(10, 4.5, 6)));
    EXPECT_TRUE(buildings[0].box.size.isApprox(Vector3d(20, 9, 12)));
    EXPECT_EQ(buildings[1].id, "kiosk");
}

TEST(SuggestedBuildings, AreTheTopmostCandidates) {
    Model model = with_lawn();
    const auto group = static_cast<int>(test::add_group(model, "library"));
    test::add_box(model, "library_walls", {0, 0, 0}, {20, 9, 12}, group);
    test::add_box(model, "library_hall", {2, 0, 2}, {12, 9, 10}, group);
    EXPECT_EQ(ids_of(model), Ids{"library"});
}

TEST(SuggestedBuildings, NeverCoverMostOfTheModel) {
    Model model;
    const auto campus = static_cast<int>(test::add_group(model, "campus"));
    test::add_box(model, "east", {20, 0, 0}, {30, 5, 20}, campus);
    test::add_box(model, "west", {0, 0, 0}, {10, 5, 20}, campus);
    EXPECT_EQ(ids_of(model), (Ids{"east", "west"}));
}

TEST(SuggestedBuildings, HaveWalls) {
    Model model = with_lawn();
    test::add_box(model, "house", {0, 0, 0}, {8, 4, 8});
    // A sloped sheet of the house's size has height and a footprint, but no walls.
    const std::size_t sheet = test::add_turned_box(model, "slope", {30, 2, 0}, {8, 0.1, 8}, 0);
    Eigen::Matrix4d& X = model.nodes[sheet].X_world_node;
    X.topLeftCorner<3, 3>() << 0.8, -0.6, 0, 0.6, 0.8, 0, 0, 0, 1;
    EXPECT_EQ(ids_of(model), Ids{"house"});
}

TEST(SuggestedBuildings, AreNotNamedAsSurroundings) {
    Model model = with_lawn();
    test::add_box(model, "hedge_3", {0, 0, 0}, {20, 3, 4});
    test::add_box(model, "Treehouse", {0, 0, 20}, {8, 4, 28});
    EXPECT_EQ(ids_of(model), Ids{"treehouse"});
}

TEST(SuggestedBuildings, AreToldByTheirBoxesWhereNamesAreShared) {
    Model model = with_lawn();
    test::add_box(model, "hall", {0, 0, 0}, {8, 4, 8});
    test::add_box(model, "hall", {20, 0, 0}, {28, 4, 8});
    test::add_box(model, "nodes[7]", {-20, 0, 0}, {-12, 4, 8});
    const auto buildings = suggest(model);
    EXPECT_EQ(ids_of(model), (Ids{"hall", "hall-2", "building-1"}));
    for (const SuggestedBuilding& building : buildings) {
        EXPECT_TRUE(building.globs.empty()) << building.id;
    }
}

TEST(SuggestedBuildings, AreNumberedIfTheirNamesAreIdentifiers) {
    Model model = with_lawn();
    const std::string guid = "b31bcc29d-00ba-11e6-b420-2bdcc4ab5d7f";
    test::add_box(model, guid, {0, 0, 0}, {8, 4, 8});
    test::add_box(model, "Building 2", {20, 0, 0}, {28, 4, 8});
    test::add_box(model, "4711", {-20, 0, 0}, {-12, 4, 8});
    const auto buildings = suggest(model);
    ASSERT_EQ(buildings.size(), 3U);
    EXPECT_EQ(buildings[0].id, "building-1");
    EXPECT_EQ(buildings[0].title, "Building 1");
    EXPECT_EQ(buildings[0].globs, std::vector<std::string>{guid});
    std::vector<std::string> ids = ids_of(model);
    std::sort(ids.begin(), ids.end());
    EXPECT_EQ(std::unique(ids.begin(), ids.end()), ids.end());
}

TEST(SuggestedBuildings, HaveIdsInTheirNamesScript) {
    Model model = with_lawn();
    test::add_box(model, "Café & Bar", {0, 0, 0}, {8, 4, 8});
    test::add_box(model, "Straßenbahn-Ü", {20, 0, 0}, {28, 4, 8});
    test::add_box(model, "도서관", {-20, 0, 0}, {-12, 4, 8});
    test::add_box(model, "도서관 2", {-40, 0, 0}, {-32, 4, 8});
    EXPECT_EQ(ids_of(model), (Ids{"café-bar", "straßenbahn-ü", "도서관", "도서관-2"}));
}

TEST(SuggestedBuildings, HaveGlobsThatMatchNothingElse) {
    Model model = with_lawn();
    test::add_box(model, "Hall [A]*", {0, 0, 0}, {8, 4, 8});
    test::add_box(model, "Hall A", {20, 0, 0}, {28, 4, 8});
    for (const SuggestedBuilding& building : suggest(model)) {
        ASSERT_EQ(building.globs.size(), 1U);
        const std::vector<std::size_t> matched = match_nodes(model, building.globs[0]);
        ASSERT_EQ(matched.size(), 1U) << building.globs[0];
        EXPECT_EQ(model.nodes[matched[0]].name, building.title);
    }
}

TEST(SuggestedBuildings, WithoutNamesAreTheFortyLargestInFileOrder) {
    Model model;
    for (int i = 0; i < 50; ++i) {
        const double size = 4.0 + 0.1 * ((i * 7) % 50);
        test::add_box(model, "Cube." + std::to_string(100 + i), {20.0 * i, 0, 0}, {20.0 * i + size, 4, size});
    }
    test::add_box(model, "kiosk", {-20, 0, 0}, {-16, 3, 4});
    const auto buildings = suggest(model);
    ASSERT_EQ(buildings.size(), 41U);
    int last = -1;
    for (std::size_t i = 0; i < 40; ++i) {
        ASSERT_EQ(buildings[i].globs.size(), 1U);
        const int number = std::stoi(buildings[i].globs[0].substr(5)) - 100;
        EXPECT_GT(number, last);
        EXPECT_GE((number * 7) % 50, 10);  // the ten smallest are left out
        EXPECT_EQ(buildings[i].title, "Building " + std::to_string(i + 1));
        last = number;
    }
    EXPECT_EQ(buildings[40].title, "kiosk");
}

TEST(SuggestedBuildings, AreAllThatHaveNames) {
    Model model;
    const auto group = static_cast<int>(test::add_group(model, "Buildings"));
    for (int i = 0; i < 453; ++i) {
        const double x = 20.0 * (i % 25);
        const int row = i / 25;
        const double z = 20.0 * row;
        test::add_box(model, "hall " + std::to_string(i), {x, 0, z}, {x + 8, 4, z + 8}, group);
    }
    EXPECT_EQ(suggest(model).size(), 453U);
}

TEST(SuggestedBuildings, HaveRotatedBoxes) {
    Model model = with_lawn();
    test::add_turned_box(model, "terrace", {5, 3, 5}, {30, 6, 8}, 25);
    const auto buildings = suggest(model);
    ASSERT_EQ(buildings.size(), 1U);
    EXPECT_TRUE(buildings[0].box.size.isApprox(Vector3d(30, 6, 8), 1e-4)) << buildings[0].box.size;
}

}  // namespace
}  // namespace campuswalk::scene

#include "scene/suggest/find_buildings.h"

#include <string>

#include <gtest/gtest.h>

#include "scene/suggest/suggested_buildings.h"
#include "tests/scene/box_model.h"

namespace campuswalk::scene {
namespace {

using Eigen::Vector3d;

/// 200 m x 200 m of lawn, and by name what was found on it.
class FoundBuildings : public testing::Test {
protected:
    FoundBuildings() { test::add_box(model_, "lawn", {-100, -0.2, -100}, {100, 0, 100}); }

    int group(const std::string& name, int parent = -1) {
        return static_cast<int>(test::add_group(model_, name, parent));
    }

    /// Walls of a house with this low corner, 12 m x 8 m and 6 m high, of one node each, and its roof.
    void add_panels(const std::string& name, const Vector3d& at, int parent = -1) {
        const auto box = [&](const std::string& part, const Vector3d& low, const Vector3d& high) {
            test::add_box(model_, name + part, at + low, at + high, parent);
        };
        box("_1", {0, 0, 0}, {12, 6, 0.3});
        box("_2", {0, 0, 7.7}, {12, 6, 8});
        box("_3", {0, 0, 0.3}, {0.3, 6, 7.7});
        box("_4", {11.7, 0, 0.3}, {12, 6, 7.7});
        box("_5", {-0.5, 6, -0.5}, {12.5, 6.3, 8.5});
    }

    std::vector<std::string> titles() const {
        std::vector<std::string> all;
        for (const SuggestedBuilding& building : suggest_buildings(model_, report(model_)).list) {
            all.push_back(building.title);
        }
        return all;
    }

    Model model_;
};

using Titles = std::vector<std::string>;

TEST_F(FoundBuildings, AreOpenedOutOfACollection) {
    const int buildings = group("Buildings");
    for (int i = 0; i < 30; ++i) {  // a terrace: each touches the next
        test::add_box(model_, "House " + std::to_string(i), {6.0 * i - 90, 0, 0}, {6.0 * i - 84, 7, 9},
                      buildings);
    }
    EXPECT_EQ(titles().size(), 30U);
    EXPECT_EQ(titles().front(), "House 0");
}

TEST_F(FoundBuildings, AreOneWhateverTheirParts) {
    const int hall = group("Assembly Hall");
    add_panels("Cube.", {0, 0, 0}, hall);
    const int frames = group("frames", hall);
    for (int i = 0; i < 400; ++i) {
        const double x = 0.5 + 0.5 * (i % 20);
        const int row = i / 20;
        const double y = 0.2 + 0.25 * row;
        test::add_box(model_, "Frame." + std::to_string(i), {x, y, -0.05}, {x + 0.3, y + 0.2, 0.0}, frames);
    }
    EXPECT_EQ(titles(), Titles{"Assembly Hall"});
}

TEST_F(FoundBuildings, AreJoinedFromLooseParts) {
    add_panels("Library_wall", {0, 0, 0});
    add_panels("Gym_wall", {30, 0, 0});
    add_panels("Cube.", {60, 0, 0});
    const auto found = suggest_buildings(model_, report(model_)).list;
    ASSERT_EQ(found.size(), 3U);
    EXPECT_EQ(titles(), (Titles{"Library_wall", "Gym_wall", "Building 1"}));
    EXPECT_EQ(found[0].globs, std::vector<std::string>{"Library_wall*"});
    EXPECT_TRUE(found[0].box.size.isApprox(Vector3d(13, 6.3, 9), 1e-6)) << found[0].box.size.transpose();
}

TEST_F(FoundBuildings, AreNotWhatStandsBesideThem) {
    add_panels("Library_wall", {0, 0, 0});
    test::add_box(model_, "Cylinder.001", {-20, 0, -20}, {-19.8, 9, -19.8});  // a mast
    test::add_box(model_, "Cube.900", {-30, 0, 20}, {-20, 0.9, 23});          // a low wall
    test::add_box(model_, "painted lines", {-40, 0, 0}, {-20, 0.01, 10});
    test::add_box(model_, "Flag", {-50, 8, 0}, {-46, 11, 0.05});
    const int trees = group("Trees");
    test::add_box(model_, "Cube.901", {-60, 0, 0}, {-54, 6, 6}, trees);
    test::add_box(model_, "bus", {-80, 0, 0}, {-68, 3.2, 2.6});
    EXPECT_EQ(titles(), Titles{"Library_wall"});
}

TEST_F(FoundBuildings, AreNotTheFenceAroundThem) {
    test::add_box(model_, "Cube.001", {0, 0, 0}, {10, 5, 10});
    test::add_box(model_, "Cube.002", {30, 0, 0}, {40, 5, 10});
    for (const auto& [low, high] : {std::pair(Vector3d(-30, 0, -30), Vector3d(60, 2.6, -29.8)),
                                    std::pair(Vector3d(-30, 0, 40), Vector3d(60, 2.6, 40.2)),
                                    std::pair(Vector3d(-30, 0, -29.8), Vector3d(-29.8, 2.6, 40)),
                                    std::pair(Vector3d(59.8, 0, -29.8), Vector3d(60, 2.6, 40))}) {
        test::add_box(model_, "Cube." + std::to_string(100 + model_.nodes.size()), low, high);
    }
    const auto found = suggest_buildings(model_, report(model_)).list;
    ASSERT_EQ(found.size(), 2U);
    EXPECT_NEAR(found[0].box.size.x(), 10, 1e-6);
}

TEST_F(FoundBuildings, HaveStoreysAndRoomsOfTheirOwn) {
    const int hall = group("hall");
    add_panels("walls", {0, 0, 0}, hall);
    const int rooms = group("rooms", hall);
    for (int i = 0; i < 2; ++i) {
        test::add_box(model_, "room " + std::to_string(i), {0.5 + 5.5 * i, 0, 0.5}, {5.5 + 5.5 * i, 3, 7},
                      rooms);
    }
    test::add_box(model_, "Cube.050", {0, 6, 0}, {12, 12, 8}, hall);  // an upper part, which would be a house
    EXPECT_EQ(titles(), Titles{"hall"});
}

TEST_F(FoundBuildings, StandInGroupsThatAreNamedAfterAStreet) {
    const int campus = group("Main Street Campus");
    test::add_box(model_, "Lake House", {0, 0, 0}, {10, 6, 8}, campus);
    test::add_box(model_, "bus station", {30, 0, 0}, {40, 6, 8}, campus);
    EXPECT_EQ(titles(), (Titles{"Lake House", "bus station"}));
}

}  // namespace
}  // namespace campuswalk::scene

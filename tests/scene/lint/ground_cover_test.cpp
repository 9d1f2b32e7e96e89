#include "scene/lint/ground_cover.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "scene/import/import_model.h"
#include "tests/scene/box_model.h"
#include "tests/scene/model_files.h"

namespace campuswalk::scene {
namespace {

GroundCover cover_of(const Model& model) {
    return measure_ground(model, world_bounds(model));
}

TEST(GroundCover, IsAFloorWithoutItsEdge) {
    Model model;
    test::add_box(model, "floor", {0, -0.2, 0}, {20, 0, 10});
    const GroundCover cover = cover_of(model);
    EXPECT_NEAR(cover.share, (20.0 - 0.8) * (10.0 - 0.8) / 200.0, 0.03);
    EXPECT_NEAR(cover.height, 0.0, 1e-6);
    EXPECT_EQ(cover.share_below, 0.0);
    EXPECT_FALSE(lacks_ground(cover));
}

TEST(GroundCover, IsTheLargestOfSeveralRegions) {
    Model model;
    test::add_box(model, "large", {0, -0.2, 0}, {20, 0, 20});
    test::add_box(model, "small", {30, -0.2, 0}, {40, 0, 20});
    EXPECT_NEAR(cover_of(model).share, 19.2 * 19.2 / 600.0, 0.03);
}

TEST(GroundCover, CrossesLowStepsOnly) {
    for (const double step : {0.25, 0.9}) {
        Model model;
        test::add_box(model, "low", {0, -1, 0}, {10, 0, 10});
        test::add_box(model, "high", {10, -1, 0}, {20, step, 10});
        const bool one = cover_of(model).share > 0.6;
        EXPECT_EQ(one, step < 0.3) << step;
    }
}

TEST(GroundCover, IsLackingOnTopsOfWalls) {
    Model model;
    for (int i = 0; i < 5; ++i) {  // a grid of rooms without a floor
        test::add_box(model, "x", {0, 0, 5.0 * i}, {20.2, 2.8, 5.0 * i + 0.2});
        test::add_box(model, "z", {5.0 * i, 0, 0}, {5.0 * i + 0.2, 2.8, 20.2});
    }
    EXPECT_TRUE(lacks_ground(cover_of(model)));
    test::add_box(model, "floor", {0, -0.1, 0}, {20.2, 0, 20.2});
    EXPECT_FALSE(lacks_ground(cover_of(model)));
}

TEST(GroundCover, IsLackingOnARoof) {
    Model model;
    test::add_box(model, "tower", {0, 0, 0}, {10, 20, 10});
    const GroundCover tower = cover_of(model);
    EXPECT_GT(tower.share, 0.8);
    // 900 of 1,000 m2, all but the roof: the centroids of the walls' triangles are at 1/3 and 2/3.
    EXPECT_NEAR(tower.share_below, 0.9, 1e-6);
    EXPECT_TRUE(lacks_ground(tower));
    test::add_box(model, "lawn", {-20, -0.1, -20}, {30, 0, 30});
    EXPECT_FALSE(lacks_ground(cover_of(model)));
}

TEST(GroundCover, IsLackingOnTheRoofOfAHut) {
    Model model;
    test::add_box(model, "hut", {0, 0, 0}, {4, 3, 4});
    EXPECT_TRUE(lacks_ground(cover_of(model)));
}

TEST(GroundCover, MayBeAboveCellars) {
    Model model;
    test::add_box(model, "lawn", {-50, -0.2, -50}, {50, 0, 50});
    test::add_box(model, "tank", {0, -6, 0}, {20, -2, 20});
    EXPECT_FALSE(lacks_ground(cover_of(model)));
}

TEST(GroundCover, NeedsHeadroom) {
    Model model;
    test::add_box(model, "floor", {0, -0.2, 0}, {10, 0, 10});
    test::add_box(model, "slab", {0, 1.2, 0}, {10, 1.4, 10});
    EXPECT_NEAR(cover_of(model).height, 1.4, 1e-6);
}

TEST(GroundCover, IsFastForManyOverlappingLayers) {
    Model model;
    for (int i = 0; i < 1000; ++i) {  // 4,000 triangles of half a square kilometre
        test::add_box(model, "sheet", {0, 3.0 * i, 0}, {1000, 3.0 * i + 0.1, 1000});
    }
    const GroundCover cover = cover_of(model);  // 160,000 cells each would take half a minute and gigabytes
    EXPECT_GT(cover.share, 0.4);
}

TEST(GroundCover, ClassifiesRealModels) {
    if (test::shared_data().empty()) {
        GTEST_SKIP() << "no shared data";
    }
    const std::vector<std::pair<const char*, bool>> models = {
        {"recast/dungeon.obj", false},
        {"recast/undulating.obj", false},
        {"gazebo/parking_garage/meshes/parking_garage.dae", false},
        {"gazebo/willowgarage/meshes/willowgarage_visual.dae", false},
        {"gazebo/willowgarage/meshes/willowgarage_collision.dae", true},
        {"gazebo/office_building/meshes/office_building.dae", true},
        {"small_house/small_house_collision.glb", false},
        {"ufaz/after153/outdoor_campus.obj", false}};
    for (const auto& [file, none] : models) {
        const Model model = import_model(test::shared_scene(file)).model;
        EXPECT_EQ(lacks_ground(cover_of(model)), none) << file;
    }
}

}  // namespace
}  // namespace campuswalk::scene

#include "scene/campus/place_heights.h"

#include <memory>

#include <gtest/gtest.h>

#include "collision/world/broad_phase.h"

namespace campuswalk::scene {
namespace {

using collision::Vec3;

/// Boxes from corner to corner.
collision::World world_of(const std::vector<std::pair<Vec3, Vec3>>& boxes) {
    collision::World world(std::make_unique<collision::LinearBroadPhase>());
    for (const auto& [min, max] : boxes) {
        collision::Object object;
        object.shape = collision::Box{0.5 * (max - min)};
        object.X_world_shape.translation = 0.5 * (min + max);
        world.add(std::move(object));
    }
    return world;
}

/// The height at which a place at (x, z) is put; NaN if there is none.
double height_at(const collision::World& world, double x, double z) {
    std::vector<Place> places(1);
    places[0].position = {x, std::numeric_limits<double>::quiet_NaN(), z};
    places[0].has_height = false;
    std::vector<Diagnostic> warnings;
    put_places_on_ground(world, places, warnings);
    return places[0].position.y();
}

TEST(PlaceHeights, AreThoseOfTheLowestFloorWithHeadroom) {
    const collision::World world = world_of({
        {{-50, -5, -50}, {50, 0, 50}},      // ground, so thick that one could stand below its top
        {{-10, -0.5, -10}, {10, 0.2, 10}},  // a house's floor, just above the ground
        {{-10, 3.2, -10}, {10, 3.5, 10}},   // its upper floor
        {{-10, 6.5, -10}, {10, 6.8, 10}},   // its roof
        {{20, 0, 20}, {24, 9, 24}},         // a block: only its top is free
        {{30, 2.5, 30}, {34, 6, 34}},       // a tree's crown
        {{40, 1.2, 40}, {44, 1.3, 44}},     // a table, too low to stand under
    });
    EXPECT_NEAR(height_at(world, -30, 0), 0.0, 1e-9);
    EXPECT_NEAR(height_at(world, 0, 0), 0.2, 1e-9);
    EXPECT_NEAR(height_at(world, 22, 22), 9.0, 1e-9);
    EXPECT_NEAR(height_at(world, 32, 32), 0.0, 1e-9);
    EXPECT_NEAR(height_at(world, 42, 42), 1.3, 1e-9);
    EXPECT_TRUE(std::isnan(height_at(world, 60, 0)));
}

TEST(PlaceHeights, StayWhereTheyAreGiven) {
    const collision::World world = world_of({{{-5, -1, -5}, {5, 0, 5}}});
    std::vector<Place> places = {{{"a.yaml", 3, 4}, "shelf", {0, 1.5, 0}},
                                 {{"p.geojson", 2, 1}, "out", {9, 0, 0}, false},
                                 {{"p.geojson", 3, 1}, "in", {1, 7, 1}, false},
                                 {{"p.geojson", 4, 1}, "away", {9, 0, 9}, false}};
    std::vector<Diagnostic> warnings;
    put_places_on_ground(world, places, warnings);
    EXPECT_EQ(places[0].position.y(), 1.5);
    EXPECT_NEAR(places[2].position.y(), 0.0, 1e-9);
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_EQ(warnings[0].code.text(), "no-ground-below");
    EXPECT_EQ(warnings[0].mark.line, 2);
    EXPECT_NE(warnings[0].message.find("'out' and one other"), std::string::npos) << warnings[0].message;
}

TEST(PlaceHeights, AreNoneInAnEmptyWorld) {
    EXPECT_TRUE(std::isnan(height_at(world_of({}), 0, 0)));
}

}  // namespace
}  // namespace campuswalk::scene

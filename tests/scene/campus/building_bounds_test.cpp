#include "scene/campus/building_bounds.h"

#include <memory>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "tests/scene/box_model.h"

namespace campuswalk::scene {
namespace {

using collision::Detection;
using Eigen::Vector3d;

class BuildingBounds : public testing::Test {
protected:
    void add_building(const std::string& id, const std::string& glob = "") {
        Building building;
        building.id = id;
        if (!glob.empty()) {
            building.nodes = {{{}, glob}};
        }
        campus_.description.buildings.push_back(std::move(building));
    }

    /// A box of the building that was added last.
    void add_collider(const Vector3d& min, const Vector3d& max, Detection detection) {
        collision::Object object;
        object.shape = collision::Box{0.5 * (max - min)};
        object.X_world_shape.translation = 0.5 * (min + max);
        object.detection = detection;
        campus_.world.add(std::move(object));
        CampusObject named;
        named.building = campus_.description.buildings.size() - 1;
        campus_.objects.push_back(std::move(named));
    }

    void expect_bounds(const Bounds& bounds, const Vector3d& min, const Vector3d& max) {
        EXPECT_LT((bounds.min - min).norm(), 1e-3) << bounds.min.transpose();
        EXPECT_LT((bounds.max - max).norm(), 1e-3) << bounds.max.transpose();
    }

    Campus campus_{{}, {}, {}, collision::World(std::make_unique<collision::LinearBroadPhase>())};
};

TEST_F(BuildingBounds, AreThoseOfItsNodes) {
    Model model;
    test::add_box(model, "ground", {-50, -1, -50}, {50, 0, 50});
    test::add_box(model, "tower", {9, 0, -2}, {11, 9, 2});
    campus_.models.push_back(std::move(model));
    add_building("tower", "tower");
    add_collider({5, 0, -5}, {15, 12, 5}, Detection::solid);
    add_building("park", "park");
    const auto bounds = building_bounds(campus_);
    ASSERT_EQ(bounds.size(), 2U);
    expect_bounds(bounds[0], {9, 0, -2}, {11, 9, 2});
    EXPECT_TRUE(bounds[1].empty()) << "no node is named park";
}

TEST_F(BuildingBounds, AreOtherwiseThoseOfItsColliders) {
    add_building("nothing");
    add_building("hall");
    add_collider({0, 0, 0}, {4, 3, 4}, Detection::solid);
    add_collider({4, 0, 0}, {6, 5, 4}, Detection::ray);
    add_collider({-20, 0, -20}, {20, 3, 20}, Detection::trigger);
    add_building("gate");
    add_collider({30, 0, 30}, {32, 2, 31}, Detection::trigger);
    const auto bounds = building_bounds(campus_);
    EXPECT_TRUE(bounds[0].empty());
    expect_bounds(bounds[1], {0, 0, 0}, {6, 5, 4});
    expect_bounds(bounds[2], {30, 0, 30}, {32, 2, 31});
}

}  // namespace
}  // namespace campuswalk::scene

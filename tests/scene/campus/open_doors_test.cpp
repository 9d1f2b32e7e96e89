#include "scene/campus/open_doors.h"

#include <memory>

#include <gtest/gtest.h>

#include "tests/scene/box_model.h"

namespace campuswalk::scene {
namespace {

using collision::Detection;

/// A house with a door that has a handle, and a tree: nodes 0 to 3.
class OpenDoors : public testing::Test {
protected:
    void SetUp() override {
        Model model;
        test::add_box(model, "house", {0, 0, 0}, {9, 6, 9});
        test::add_box(model, "front door", {4, 0, 9}, {5, 2.1, 9.1}, 0);
        test::add_box(model, "handle", {4.8, 1, 9.1}, {4.9, 1.1, 9.2}, 1);
        test::add_box(model, "tree", {20, 0, 0}, {21, 6, 1});
        campus_.models.push_back(std::move(model));
    }

    void add(std::size_t root, std::vector<NodeRef> except, Detection detection) {
        campus_.world.add({collision::Sphere{1.0}, {}, detection});
        CampusObject object;
        object.nodes = {{{0, root}}, std::move(except)};
        campus_.objects.push_back(object);
    }

    /// By node: whether it is drawn after the open doors were removed.
    std::vector<bool> drawn() {
        remove_open_doors(campus_);
        std::vector<bool> has_mesh;
        for (const Node& node : campus_.models[0].nodes) {
            has_mesh.push_back(!node.meshes.empty());
        }
        return has_mesh;
    }

    Campus campus_{{}, {}, {}, collision::World(std::make_unique<collision::LinearBroadPhase>())};
};

TEST_F(OpenDoors, ArentDrawnWithWhatIsBelowThem) {
    add(0, {{0, 1}}, Detection::solid);
    EXPECT_EQ(drawn(), std::vector({true, false, false, true}));
}

TEST_F(OpenDoors, AreDoorsByName) {
    add(3, {{0, 3}}, Detection::solid);
    add(0, {{0, 2}}, Detection::solid);
    EXPECT_EQ(drawn(), std::vector({true, true, true, true}));
}

TEST_F(OpenDoors, AreLeftOutOfWhatIsSolid) {
    add(0, {{0, 1}}, Detection::trigger);
    EXPECT_EQ(drawn(), std::vector({true, true, true, true}));
}

TEST_F(OpenDoors, AreNotOpenIfAnotherColliderHasThem) {
    add(0, {{0, 1}}, Detection::solid);
    add(1, {}, Detection::solid);
    EXPECT_EQ(drawn(), std::vector({true, true, true, true}));
}

}  // namespace
}  // namespace campuswalk::scene

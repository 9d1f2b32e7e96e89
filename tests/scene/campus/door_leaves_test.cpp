#include "scene/campus/door_leaves.h"

#include <memory>

#include <gtest/gtest.h>

#include "scene/campus/open_doors.h"
#include "tests/scene/box_model.h"

namespace campuswalk::scene {
namespace {

/// A house with a door that has a handle, a group of two doors of which one is turned, and a frame.
class DoorLeaves : public testing::Test {
protected:
    void SetUp() override {
        Model model;
        test::add_box(model, "house", {0, 0, 0}, {9, 6, 9});
        test::add_box(model, "front door", {4, 0, 9}, {5, 2.1, 9.1}, 0);
        test::add_box(model, "handle", {4.8, 1, 9.1}, {4.9, 1.1, 9.2}, 1);
        const std::size_t group = test::add_group(model, "doors");
        test::add_box(model, "door 1", {20, 0, 0}, {21, 2, 0.1}, static_cast<int>(group));
        test::add_turned_box(model, "door 2", {30, 1, 0}, {1, 2, 0.1}, 30.0);
        test::add_box(model, "door_frame", {3.9, 0, 9}, {4, 2.1, 9.1}, 0);
        campus_.models.push_back(std::move(model));
    }

    Campus campus_{{}, {}, {}, collision::World(std::make_unique<collision::LinearBroadPhase>())};
};

TEST_F(DoorLeaves, AreNamedNodesWithWhatIsBelowThem) {
    const std::vector<DoorLeaf> leaves = find_door_leaves(campus_);
    ASSERT_EQ(leaves.size(), 3);
    EXPECT_EQ(leaves[0].node, (NodeRef{0, 1}));
    EXPECT_TRUE(leaves[0].box.center.isApprox(Eigen::Vector3d(4.5, 1.05, 9.1), 1e-6));
    EXPECT_TRUE(leaves[0].box.size.isApprox(Eigen::Vector3d(1, 2.1, 0.2), 1e-6));
    EXPECT_EQ(leaves[1].node, (NodeRef{0, 4}));
    EXPECT_EQ(leaves[2].node, (NodeRef{0, 5}));
    EXPECT_NEAR(leaves[2].box.size.x(), 1.0, 1e-6);
    EXPECT_NEAR(leaves[2].box.size.z(), 0.1, 1e-6);
}

TEST_F(DoorLeaves, AreFoundWhereTheyStandOpen) {
    const std::vector<DoorLeaf> before = find_door_leaves(campus_);
    campus_.world.add({collision::Sphere{1.0}, {}, collision::Detection::solid});
    CampusObject object;
    object.nodes = {{{0, 0}}, {{0, 1}}};
    campus_.objects.push_back(object);
    remove_open_doors(campus_);
    ASSERT_TRUE(campus_.models[0].nodes[1].meshes.empty());
    const std::vector<DoorLeaf> after = find_door_leaves(campus_);
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t i = 0; i < after.size(); ++i) {
        EXPECT_EQ(after[i].node, before[i].node);
        EXPECT_TRUE(after[i].box.center.isApprox(before[i].box.center, 1e-12));
        EXPECT_TRUE(after[i].box.size.isApprox(before[i].box.size, 1e-12));
    }
}

}  // namespace
}  // namespace campuswalk::scene

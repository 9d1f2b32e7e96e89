#include "engine/render/overlay/node_owners.h"

#include <gtest/gtest.h>

#include "collision/world/broad_phase.h"
#include "tests/engine/render/small_scenes.h"

namespace campuswalk::engine::render::test {
namespace {

// hall, hall_wing below it, door below the wing; beside them a tree and a lamp.
scene::Campus hall_campus() {
    scene::Model model = SceneBuilder()
                             .colored(kRed)
                             .named("hall")
                             .upright({0, 0, -5}, 1.0)
                             .named("hall_wing")
                             .upright({2, 0, -5}, 1.0)
                             .named("door")
                             .upright({2, 0, -4}, 0.5)
                             .named("tree")
                             .upright({-2, 0, -5}, 1.0)
                             .named("lamp")
                             .upright({-4, 0, -5}, 1.0)
                             .model();
    model.nodes[1].parent = 0;
    model.nodes[2].parent = 1;
    scene::Building hall;
    hall.id = "hall";
    return campus_of(std::move(model), {hall});
}

void add_object(scene::Campus& campus, const char* id, std::vector<scene::NodeRef> nodes,
                collision::Detection detection = collision::Detection::solid) {
    campus.world.add({.shape = collision::Sphere{}, .X_world_shape = {}, .detection = detection});
    scene::CampusObject& object = campus.objects.emplace_back();
    object.id = id;
    object.nodes.roots = std::move(nodes);
}

PixelOwner name_of(const NodeOwners& owners, std::size_t node) {
    return owners.owners[owners.owner_of_node[node + 1]];
}

TEST(NodeOwners, ABuildingOwnsTheSubtreesOfItsNodes) {
    const NodeOwners owners = find_node_owners(hall_campus());
    ASSERT_EQ(owners.owner_of_node.size(), 6U);
    for (const std::size_t node : {0U, 1U, 2U}) {
        EXPECT_EQ(name_of(owners, node), (PixelOwner{0, std::nullopt}));
    }
    EXPECT_EQ(name_of(owners, 3), PixelOwner{});
    EXPECT_EQ(owners.owner_of_node[0], 0U);
    EXPECT_EQ(owners.owners.size(), 2U);
    EXPECT_EQ(owners.owners[0], PixelOwner{});
}

TEST(NodeOwners, TheObjectWithFewestNodesOwnsANodeInAnyOrder) {
    for (const bool walls_first : {true, false}) {
        scene::Campus campus = hall_campus();
        add_object(campus, "a", {{0, walls_first ? 0U : 2U}});
        add_object(campus, "b", {{0, walls_first ? 2U : 0U}});
        const std::size_t walls = walls_first ? 0 : 1;
        const NodeOwners owners = find_node_owners(campus);
        EXPECT_EQ(name_of(owners, 0), (PixelOwner{0, walls}));
        EXPECT_EQ(name_of(owners, 1), (PixelOwner{0, walls}));
        EXPECT_EQ(name_of(owners, 2), (PixelOwner{0, 1 - walls}));
    }
}

TEST(NodeOwners, ExcludedNodesAreNotOwned) {
    scene::Campus campus = hall_campus();
    add_object(campus, "world", {{0, 0}});
    campus.objects[0].nodes.except = {{0, 1}};
    const NodeOwners owners = find_node_owners(campus);
    EXPECT_EQ(name_of(owners, 0), (PixelOwner{0, 0}));
    EXPECT_EQ(name_of(owners, 1), (PixelOwner{0, std::nullopt}));
    EXPECT_EQ(name_of(owners, 2), (PixelOwner{0, std::nullopt})) << "below the excluded node";
}

TEST(NodeOwners, TriggersOwnOnlyNodesThatNothingElseClaims) {
    scene::Campus campus = hall_campus();
    add_object(campus, "zone", {{0, 2}, {0, 3}}, collision::Detection::trigger);
    add_object(campus, "walls", {{0, 0}});
    const NodeOwners owners = find_node_owners(campus);
    EXPECT_EQ(name_of(owners, 2), (PixelOwner{0, 1}));
    EXPECT_EQ(name_of(owners, 3), (PixelOwner{std::nullopt, 0}));
}

TEST(NodeOwners, ANodeWithoutABuildingBelongsToItsObjectsBuilding) {
    scene::Campus campus = hall_campus();
    add_object(campus, "tree", {{0, 3}});
    campus.objects[0].building = 0;
    EXPECT_EQ(name_of(find_node_owners(campus), 3), (PixelOwner{0, 0}));
}

TEST(NodeOwners, NodesAreNumberedOverAllModels) {
    scene::Campus campus = hall_campus();
    campus.models.insert(campus.models.begin(), SceneBuilder().colored(kGrey).ground(1.0).model());
    add_object(campus, "lamp", {{1, 4}});
    const NodeOwners owners = find_node_owners(campus);
    EXPECT_EQ(owners.owners[owners.owner_of_node[1]], PixelOwner{});
    EXPECT_EQ(owners.owners[owners.owner_of_node[2]], (PixelOwner{0, std::nullopt})) << "the hall's";
    EXPECT_EQ(owners.owners[owners.owner_of_node[6]], (PixelOwner{std::nullopt, 0}));
}

}  // namespace
}  // namespace campuswalk::engine::render::test

#include "scene/campus/node_triangles.h"

#include <memory>

#include <gtest/gtest.h>

#include "collision/mesh/mesh_collider.h"
#include "tests/scene/model_files.h"

namespace campuswalk::scene {
namespace {

/// A house of walls, a door and a pane without thickness, whose triangles no mesh keeps, and a hedge.
class NodeTrianglesTest : public testing::Test {
protected:
    NodeTrianglesTest() {
        test::write_gltf(
            folder_, "house",
            {{.name = "walls", .size = {10, 3, 8}, .X_parent_node = test::translation(5, 1.5, -3)},
             {.name = "pane", .size = {1, 0, 0}, .X_parent_node = test::translation(2, 1, 1)},
             {.name = "door", .size = {1, 2, 0.1F}, .X_parent_node = test::translation(5, 1, 1)},
             {.name = "hedge", .size = {9, 1, 1}, .X_parent_node = test::translation(0, 1, 30)}});
        CampusDescription description;
        description.name = "house";
        description.scenes = {test::scene_file(folder_, "house.gltf")};
        description.colliders = {collider("house", {"walls", "pane", "door"}), collider("hedge", {"hedge"})};
        std::vector<Diagnostic> warnings;
        campus_ = load_campus(description, std::make_unique<collision::LinearBroadPhase>(), warnings);
    }

    static ColliderDescription collider(const std::string& id, const std::vector<std::string>& nodes) {
        ColliderDescription collider;
        collider.id = id;
        collider.shape = MeshShape{};
        collider.modes.solid = true;
        for (const std::string& node : nodes) {
            collider.nodes.push_back({{}, node});
        }
        return collider;
    }

    test::TemporaryFolder folder_;
    Campus campus_{{}, {}, {}, collision::World(std::make_unique<collision::LinearBroadPhase>())};
};

constexpr collision::ObjectId kHouse{0};
constexpr collision::ObjectId kHedge{1};

TEST_F(NodeTrianglesTest, EachTriangleBelongsToTheNodeThatItsVerticesAreFrom) {
    const NodeTriangles nodes(campus_, campus_.world.bounds());
    const collision::Object& house = campus_.world.object(kHouse);
    const auto& mesh = std::get<std::shared_ptr<const collision::MeshCollider>>(house.shape)->mesh();
    ASSERT_EQ(mesh.triangles.size(), 24U) << "the pane has no area";
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const collision::Triangle triangle = collision::vertices(mesh, t);
        const bool is_door = std::abs(triangle.a.x() + house.X_world_shape.translation.x() - 5.0) < 1.0;
        const auto range = nodes.of_same_node(kHouse, t);
        ASSERT_TRUE(range);
        EXPECT_TRUE(range->contains(t));
        EXPECT_EQ(*range, is_door ? (TriangleRange{12, 24}) : (TriangleRange{0, 12})) << t;
    }
}

TEST_F(NodeTrianglesTest, AnObjectOfOneNodeHasNoParts) {
    EXPECT_EQ(NodeTriangles(campus_, campus_.world.bounds()).of_same_node(kHedge, 0), std::nullopt);
}

TEST_F(NodeTrianglesTest, OnlyObjectsInTheRegionAreLookedAt) {
    const NodeTriangles elsewhere(campus_, {{-5, 0, 25}, {5, 2, 35}});
    EXPECT_EQ(elsewhere.of_same_node(kHouse, 3), std::nullopt);
}

TEST_F(NodeTrianglesTest, WithoutModelsNothingIsKnown) {
    campus_.models.clear();
    EXPECT_EQ(NodeTriangles(campus_, campus_.world.bounds()).of_same_node(kHouse, 3), std::nullopt);
}

}  // namespace
}  // namespace campuswalk::scene

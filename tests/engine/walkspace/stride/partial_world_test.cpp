#include "engine/walkspace/stride/partial_world.h"

#include <gtest/gtest.h>

#include "collision/mesh/mesh_collider.h"
#include "collision/world/obstacle.h"
#include "tests/engine/small_campus.h"
#include "tests/support/mesh_pieces.h"

namespace campuswalk::engine {
namespace {

using collision::Vec3;

/// A floor of 2 triangles and a door of 12 in one mesh, and a bench elsewhere.
class PartialWorld : public testing::Test {
protected:
    PartialWorld() {
        collision::TriangleMesh mesh;
        support::add_floor(mesh, 10.0);
        floor_ = static_cast<std::uint32_t>(mesh.triangles.size());
        support::add_box(mesh, {-0.5, 0, -4.1}, {0.5, 2, -4.0});
        all_ = static_cast<std::uint32_t>(mesh.triangles.size());
        add_object(campus_, "house", std::make_shared<const collision::MeshCollider>(std::move(mesh)),
                   Vec3::Zero());
        bench_ = add_box(campus_, "bench", {6, 0, 6}, {8, 0.5, 7});
    }

    static std::size_t pieces_near(const collision::World& world, const Vec3& point) {
        std::vector<collision::Obstacle> near;
        collision::gather_obstacles(world, {}, {point, point}, 0.3, near);
        return near.size();
    }

    scene::Campus campus_ = empty_campus();
    std::uint32_t floor_ = 0;
    std::uint32_t all_ = 0;
    collision::ObjectId house_{0};
    collision::ObjectId bench_{};
};

TEST_F(PartialWorld, LacksTheTrianglesAndKeepsTheRest) {
    const Vec3 at_door(0, 1, -3.9);
    ASSERT_GT(pieces_near(campus_.world, at_door), 0U);
    const auto without = world_without(campus_.world, house_, {floor_, all_}, {{-10, -2, -10}, {10, 4, 10}});
    ASSERT_NE(without, nullptr);
    EXPECT_EQ(pieces_near(*without, at_door), 0U);
    EXPECT_EQ(pieces_near(*without, {3, 0.1, 3}), pieces_near(campus_.world, {3, 0.1, 3}));
    EXPECT_EQ(pieces_near(*without, {7, 0.6, 6.5}), pieces_near(campus_.world, {7, 0.6, 6.5}));
    EXPECT_EQ(without->size(), campus_.world.size()) << "objects keep their ids";
}

TEST_F(PartialWorld, FindsNothingOutsideOfItsBox) {
    const auto without = world_without(campus_.world, house_, {floor_, all_}, {{-10, -2, -10}, {3, 4, 10}});
    ASSERT_NE(without, nullptr);
    EXPECT_EQ(pieces_near(*without, {7, 0.6, 6.5}), 0U) << "the bench is elsewhere";
}

TEST_F(PartialWorld, IsNoneIfNothingElseOfTheObjectIsThere) {
    EXPECT_EQ(world_without(campus_.world, house_, {0, all_}, {{-10, -2, -10}, {10, 4, 10}}), nullptr);
    EXPECT_EQ(world_without(campus_.world, house_, {floor_, all_}, {{-1, 1, -5}, {1, 2, -3}}), nullptr);
}

}  // namespace
}  // namespace campuswalk::engine

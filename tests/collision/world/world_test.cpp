#include "collision/world/world.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "collision/world/bounds.h"
#include "collision/world/bullet_broad_phase.h"
#include "tests/support/random_scene.h"

namespace campuswalk::collision {
namespace {

using support::Dice;

Object random_object(Dice& dice) {
    Object object;
    object.shape = support::random_solid(dice);
    object.X_world_shape = support::random_pose(dice, 10.0);
    object.detection = static_cast<Detection>(1 + dice.below(7));
    object.layer = static_cast<std::uint32_t>(dice.below(32));
    return object;
}

bool visible(const Object& object, const QueryFilter& filter) {
    const auto bits = static_cast<unsigned>(object.detection) & static_cast<unsigned>(filter.detection);
    return bits != 0 && (filter.ignored_layers & (1U << object.layer)) == 0;
}

TEST(Detection, CombinesAsBits) {
    const Detection both = Detection::solid | Detection::ray;
    EXPECT_TRUE(any_of(both, Detection::solid));
    EXPECT_TRUE(any_of(both, Detection::ray));
    EXPECT_FALSE(any_of(both, Detection::trigger));
    EXPECT_FALSE(any_of(Detection::none, both));
}

TEST(World, NumbersObjectsInTheOrderOfAddition) {
    World world(std::make_unique<LinearBroadPhase>());
    EXPECT_EQ(world.size(), 0U);
    EXPECT_TRUE(world.bounds().empty());
    Object ball;
    ball.shape = Sphere{2.0};
    EXPECT_EQ(world.add(ball), ObjectId{0});
    ball.X_world_shape.translation = {10, 0, 0};
    EXPECT_EQ(world.add(ball), ObjectId{1});
    EXPECT_EQ(world.size(), 2U);
    EXPECT_EQ(world.object(ObjectId{1}).X_world_shape.translation, Vec3(10, 0, 0));
    EXPECT_NEAR(world.bounds(ObjectId{1}).min.x(), 8.0, 1e-9);
    EXPECT_NEAR(world.bounds().min.x(), -2.0, 1e-9);
    EXPECT_NEAR(world.bounds().max.x(), 12.0, 1e-9);
}

/// With either broad phase the candidates are those of a loop that pass the filter, ascending.
class WorldWithABroadPhase : public ::testing::TestWithParam<bool> {
protected:
    std::unique_ptr<BroadPhase> broad_phase() const {
        if (GetParam()) {
            return make_bullet_broad_phase();
        }
        return std::make_unique<LinearBroadPhase>();
    }
};

TEST_P(WorldWithABroadPhase, ReturnsFilteredCandidatesInOrder) {
    Dice dice(80);
    World world(broad_phase());
    for (int i = 0; i < 200; ++i) {
        world.add(random_object(dice));
    }
    std::size_t found = 0;
    for (int i = 0; i < 500; ++i) {
        const Vec3 a = dice.in_cube(10.0);
        const Vec3 b = a + dice.in_cube(6.0);
        const Aabb box{a.cwiseMin(b), a.cwiseMax(b)};
        const QueryFilter filter{static_cast<Detection>(1 + dice.below(7)),
                                 7U << static_cast<std::uint32_t>(dice.below(30))};
        std::vector<ObjectId> needed;
        for (std::uint32_t id = 0; id < world.size(); ++id) {
            if (world.bounds(ObjectId{id}).overlaps(box) && visible(world.object(ObjectId{id}), filter)) {
                needed.push_back(ObjectId{id});
            }
        }
        std::vector<ObjectId> ours{ObjectId{4711}};
        world.candidates(box, filter, ours);
        ASSERT_TRUE(std::is_sorted(ours.begin(), ours.end()));
        ASSERT_TRUE(std::includes(ours.begin(), ours.end(), needed.begin(), needed.end()));
        for (const ObjectId id : ours) {
            ASSERT_LT(index_of(id), world.size());
            ASSERT_TRUE(visible(world.object(id), filter));
            ASSERT_TRUE(world.bounds(id).grown(1e-4).overlaps(box));
        }
        found += ours.size();
        world.candidates(a, b, filter, ours);
        ASSERT_TRUE(std::is_sorted(ours.begin(), ours.end()));
        for (const ObjectId id : ours) {
            ASSERT_TRUE(visible(world.object(id), filter));
        }
    }
    EXPECT_GT(found, 300U);
}

INSTANTIATE_TEST_SUITE_P(Kinds, WorldWithABroadPhase, ::testing::Bool(),
                         [](const auto& test) { return std::string(test.param ? "bullet" : "linear"); });

}  // namespace
}  // namespace campuswalk::collision

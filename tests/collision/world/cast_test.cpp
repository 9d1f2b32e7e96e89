#include "collision/world/cast.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "collision/world/bullet_broad_phase.h"
#include "tests/support/effort.h"
#include "tests/support/mesh_pieces.h"
#include "tests/support/plain_solids.h"
#include "tests/support/random_scene.h"

namespace campuswalk::collision {
namespace {

using support::Dice;
using support::Line;

constexpr QueryFilter kEverything{Detection::solid | Detection::trigger | Detection::ray, 0};

std::optional<WorldRayHit> cast_at(const World& world, const Ray& ray,
                                   const QueryFilter& filter = kEverything,
                                   Detection preferred = Detection::none) {
    return cast(world, filter, ray, preferred);
}

/// The smallest fraction, by a loop over everything with the plain formulas; 2 for none.
double loop_first(const World& world, const Ray& ray) {
    double first = 2.0;
    for (std::uint32_t i = 0; i < world.size(); ++i) {
        const Object& object = world.object(ObjectId{i});
        const Pose& X = object.X_world_shape;
        if (const auto* mesh = std::get_if<std::shared_ptr<const MeshCollider>>(&object.shape)) {
            for (std::size_t t = 0; t < (*mesh)->mesh().triangles.size(); ++t) {
                const Triangle c = vertices((*mesh)->mesh(), t);
                const support::Vertices placed{X * c.a, X * c.b, X * c.c};
                first = std::min(first,
                                 support::first_intersection(Line{ray.from, ray.to}, placed).value_or(2.0));
            }
        } else {
            const Line local{X.rotation.transpose() * (ray.from - X.translation),
                             X.rotation.transpose() * (ray.to - X.translation)};
            first = std::min(first, support::first_intersection(local, object.shape).value_or(2.0));
        }
    }
    return first;
}

TEST(Cast, HitsWhereALoopOverEverythingDoes) {
    Dice dice(110);
    int hits = 0;
    const int worlds = support::repeats(20);
    for (int w = 0; w < worlds; ++w) {
        World world(w % 2 == 0 ? std::make_unique<LinearBroadPhase>() : make_bullet_broad_phase());
        for (int i = 0; i < 25; ++i) {
            Object object;
            object.shape = support::random_solid(dice);
            if (i % 8 == 0) {
                object.shape = std::make_shared<const MeshCollider>(support::random_mesh(dice, 30, 1.5));
            }
            object.X_world_shape = support::random_pose(dice, 5.0);
            world.add(object);
        }
        for (int i = 0; i < 40; ++i) {
            const Ray ray{dice.in_cube(7.0), dice.in_cube(7.0)};
            const auto ours = cast_at(world, ray);
            ASSERT_NEAR(ours ? ours->fraction : 2.0, loop_first(world, ray), 1e-7) << w << ' ' << i;
            hits += ours ? 1 : 0;
        }
    }
    EXPECT_GT(hits, worlds * 4);
}

/// Spheres of radius 1 along the X axis, each with its detection.
class CastAtSpheres : public ::testing::Test {
protected:
    ObjectId add_sphere(double x, Detection detection, std::uint32_t layer = 0) {
        Object sphere;
        sphere.shape = Sphere{1.0};
        sphere.X_world_shape.translation = {x, 0, 0};
        sphere.detection = detection;
        sphere.layer = layer;
        return world_.add(sphere);
    }
    Ray ray_ = {Vec3(0, 0, 0), Vec3(20, 0, 0)};
    World world_{std::make_unique<LinearBroadPhase>()};
};

TEST_F(CastAtSpheres, TheNearestWinsWhateverItsId) {
    add_sphere(9, Detection::ray);
    const ObjectId near = add_sphere(5, Detection::ray);
    const auto found = cast_at(world_, ray_);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->object, near);
    EXPECT_NEAR(found->fraction, 4.0 / 20.0, 1e-12);
}

TEST_F(CastAtSpheres, TheFilterDecidesWhatIsHit) {
    add_sphere(5, Detection::solid);
    add_sphere(8, Detection::ray, 7);
    const ObjectId visible = add_sphere(11, Detection::ray | Detection::solid);
    const auto found = cast_at(world_, ray_, {Detection::ray, 1U << 7U});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->object, visible);
    EXPECT_FALSE(cast_at(world_, ray_, {Detection::trigger, 0}));
}

TEST_F(CastAtSpheres, InTheSamePlaceThePreferredThenTheLowestIdWins) {
    const ObjectId wall = add_sphere(5, Detection::solid);
    const ObjectId sign = add_sphere(5, Detection::ray);
    add_sphere(5, Detection::ray);
    EXPECT_EQ(cast_at(world_, ray_)->object, wall);
    EXPECT_EQ(cast_at(world_, ray_, kEverything, Detection::ray)->object, sign);
}

TEST_F(CastAtSpheres, APreferredObjectBehindAnotherIsHidden) {
    const ObjectId wall = add_sphere(5, Detection::solid);
    add_sphere(5.1, Detection::ray);
    EXPECT_EQ(cast_at(world_, ray_, kEverything, Detection::ray)->object, wall);
}

TEST_F(CastAtSpheres, ARayFromInsideHitsImmediately) {
    const ObjectId around = add_sphere(0.5, Detection::ray);
    const auto found = cast_at(world_, ray_);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->object, around);
    EXPECT_EQ(found->fraction, 0.0);
}

TEST_F(CastAtSpheres, ARayOfNoLengthHitsNothing) {
    add_sphere(0, Detection::ray);
    EXPECT_FALSE(cast_at(world_, {Vec3(0, 0, 0), Vec3(0, 0, 0)}));
}

}  // namespace
}  // namespace campuswalk::collision

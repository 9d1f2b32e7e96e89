#include "collision/world/obstacle.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/angles.h"
#include "tests/support/effort.h"
#include "tests/support/mesh_pieces.h"
#include "tests/support/plain_solids.h"
#include "tests/support/random_scene.h"

namespace campuswalk::collision {
namespace {

using support::add_object;
using support::Dice;
using support::Line;
using support::radians;
using support::repeats;

Obstacle obstacle_of(const Object& solid) {
    Obstacle o;
    o.solid = &solid;
    return o;
}

Obstacle obstacle_of(const Triangle& t, const Vec3& normal) {
    Obstacle o;
    o.vertices = t;
    o.normal = normal;
    return o;
}

/// Meshes and solids in three layers, some solid, some triggers.
class SomeWorld {
public:
    explicit SomeWorld(Dice& dice) {
        for (int i = 0; i < 20; ++i) {
            Object object;
            object.shape = support::random_solid(dice);
            if (i % 7 == 0) {
                object.shape = std::make_shared<const MeshCollider>(support::random_mesh(dice, 40, 2.0));
            }
            object.X_world_shape = support::random_pose(dice, 4.0);
            object.detection = dice.chance(0.7) ? Detection::solid : Detection::trigger;
            object.layer = static_cast<std::uint32_t>(dice.below(3));
            world.add(object);
        }
    }
    World world{std::make_unique<LinearBroadPhase>()};
};

/// The pieces in reach by a loop over all objects and triangles: those certainly in reach, and how many there
/// may be.
struct Expected {
    std::vector<std::pair<std::size_t, std::uint32_t>> inside;
    std::size_t at_most = 0;
};

Expected loop_gather(const World& world, const QueryFilter& filter, const Segment& segment, double radius) {
    constexpr double kBand = 1e-8;
    const Line line{segment.a, segment.b};
    Expected expected;
    const auto consider = [&](std::size_t object, std::uint32_t triangle, double distance) {
        if (distance < radius - kBand) {
            expected.inside.emplace_back(object, triangle);
        }
        expected.at_most += distance < radius + kBand ? 1 : 0;
    };
    for (std::size_t i = 0; i < world.size(); ++i) {
        const Object& object = world.object(static_cast<ObjectId>(i));
        if (object.detection != filter.detection || (filter.ignored_layers >> object.layer & 1U) != 0) {
            continue;
        }
        const auto* mesh = std::get_if<std::shared_ptr<const MeshCollider>>(&object.shape);
        if (mesh == nullptr) {
            consider(i, 0, support::signed_distance(object, line));
            continue;
        }
        for (std::uint32_t t = 0; t < (*mesh)->mesh().triangles.size(); ++t) {
            const Triangle c = vertices((*mesh)->mesh(), t);
            const Pose& X = object.X_world_shape;
            consider(i, t, support::distance(line, {X * c.a, X * c.b, X * c.c}));
        }
    }
    return expected;
}

TEST(GatherObstacles, FindsThePiecesOfALoopInOrder) {
    Dice dice(60);
    int found = 0;
    const int worlds = repeats(30);
    for (int w = 0; w < worlds; ++w) {
        const SomeWorld some(dice);
        for (int i = 0; i < 20; ++i) {
            const Vec3 a = dice.in_cube(4.0);
            const Segment segment{a, a + Vec3(0, 1.2, 0)};
            const double radius = dice.between(0.2, 1.5);
            const QueryFilter filter{dice.chance(0.5) ? Detection::solid : Detection::trigger,
                                     static_cast<std::uint32_t>(dice.below(8))};
            std::vector<Obstacle> obstacles(3);
            gather_obstacles(some.world, filter, segment, radius, obstacles);
            const Expected expected = loop_gather(some.world, filter, segment, radius);
            std::vector<std::pair<std::size_t, std::uint32_t>> ours;
            ours.reserve(obstacles.size());
            for (const Obstacle& o : obstacles) {
                ours.emplace_back(index_of(o.object), o.triangle);
            }
            ASSERT_TRUE(std::is_sorted(ours.begin(), ours.end()));
            ASSERT_TRUE(
                std::includes(ours.begin(), ours.end(), expected.inside.begin(), expected.inside.end()));
            ASSERT_LE(ours.size(), expected.at_most);
            found += static_cast<int>(ours.size());
        }
    }
    EXPECT_GT(found, worlds * 5);
}

TEST(GatherObstacles, ReturnsATrianglesVerticesNormalAndTop) {
    World world(std::make_unique<LinearBroadPhase>());
    TriangleMesh mesh;
    support::add_triangle(mesh, {0, 0, 0}, {0, 0, 2}, {2, 0, 0});
    support::add_triangle(mesh, {5, 0, 0}, {6, 0, 0}, {7, 0, 0});
    const ObjectId id = add_object(world, mesh, Detection::solid, {Mat3::Identity(), {10, 3, 0}});
    std::vector<Obstacle> pieces;
    gather_pieces(world, id, {{10, 4, 0}, {10, 5, 0}}, 20.0, pieces);
    ASSERT_EQ(pieces.size(), 2U);
    EXPECT_EQ(pieces[0].object, id);
    EXPECT_EQ(pieces[0].solid, nullptr);
    EXPECT_EQ(pieces[0].vertices.c, Vec3(12, 3, 0));
    EXPECT_EQ(pieces[0].normal, Vec3(0, 1, 0));
    EXPECT_EQ(pieces[0].top, 3.0);
    EXPECT_EQ(pieces[1].triangle, 1U);
    EXPECT_EQ(pieces[1].normal, Vec3(0, 0, 0)) << "no area, no normal";
}

TEST(GatherPieces, ConsidersOnlyTheGivenObjectWhateverItsDetection) {
    World world(std::make_unique<LinearBroadPhase>());
    add_object(world, Sphere{1.0}, {0, 0, 0});
    Object trigger;
    trigger.shape = Box{{1, 2, 1}};
    trigger.detection = Detection::trigger;
    const ObjectId id = world.add(trigger);
    std::vector<Obstacle> pieces;
    gather_pieces(world, id, {{0, 0, 0}, {0, 1, 0}}, 0.3, pieces);
    ASSERT_EQ(pieces.size(), 1U);
    EXPECT_EQ(pieces[0].object, id);
    EXPECT_NEAR(pieces[0].top, 2.0, 1e-9);
    gather_pieces(world, id, {{9, 0, 0}, {9, 1, 0}}, 0.3, pieces);
    EXPECT_TRUE(pieces.empty());
}

TEST(WalkableAt, TrianglesAreWalkableOnBothSidesUpToTheLimit) {
    const double limit = std::cos(radians(50.0));
    const auto slope = [](double degrees) {
        const double angle = radians(degrees);
        return obstacle_of(Triangle{}, Vec3(std::sin(angle), std::cos(angle), 0));
    };
    EXPECT_TRUE(walkable_at(slope(0), Vec3::Zero(), limit));
    EXPECT_TRUE(walkable_at(slope(49.9), Vec3::Zero(), limit));
    EXPECT_FALSE(walkable_at(slope(50.1), Vec3::Zero(), limit));
    EXPECT_FALSE(walkable_at(slope(90), Vec3::Zero(), limit));
    EXPECT_TRUE(walkable_at(slope(180), Vec3::Zero(), limit)) << "flipped";
    EXPECT_FALSE(walkable_at(obstacle_of(Triangle{}, Vec3::Zero()), Vec3::Zero(), limit)) << "no area";
}

TEST(WalkableAt, SolidsAreWalkableWhereTheirSurfaceFacesUp) {
    constexpr double kLimit = 0.64;
    Object object;
    const auto walkable = [&](const Shape& shape, const Vec3& point) {
        object.shape = shape;
        return walkable_at(obstacle_of(object), point, kLimit);
    };
    EXPECT_TRUE(walkable(Box{{1, 1, 1}}, {0.5, 1, 0}));
    EXPECT_TRUE(walkable(Box{{1, 1, 1}}, {1, 1, 0})) << "the rim of the top";
    EXPECT_FALSE(walkable(Box{{1, 1, 1}}, {1, 0.5, 0}));
    EXPECT_FALSE(walkable(Box{{1, 1, 1}}, {0.5, -1, 0})) << "from below";
    EXPECT_TRUE(walkable(Sphere{1.0}, {0.7, 0.714, 0}));
    EXPECT_FALSE(walkable(Sphere{1.0}, {0.8, 0.6, 0}));
    EXPECT_FALSE(walkable(Sphere{1.0}, {0, -1, 0}));
    EXPECT_TRUE(walkable(Capsule{0.5, 1.0}, {0, 1.5, 0}));
    EXPECT_FALSE(walkable(Capsule{0.5, 1.0}, {0.5, 0.9, 0}));
    EXPECT_TRUE(walkable(Wheel{0.5, 0.2}, {0.1, 0.5, 0})) << "the tread's top";
    EXPECT_FALSE(walkable(Wheel{0.5, 0.2}, {0.2, 0, 0})) << "its side";
    object.X_world_shape.rotation = support::turn(Vec3::UnitZ(), std::numbers::pi / 2);
    EXPECT_TRUE(walkable(Wheel{0.5, 0.2}, {0.1, 0.2, 0.1})) << "a wheel that lies on its side";
    EXPECT_FALSE(walkable(Wheel{0.5, 0.2}, {0.5, 0.1, 0}));
}

/// Against a solid; triangles are in placed_mesh_test.cpp.
TEST(Sweep, StopsAtTheFirstContact) {
    Dice dice(61);
    int contacts = 0;
    const int sweeps = repeats(600);
    for (int i = 0; i < sweeps; ++i) {
        Object object;
        object.shape = support::random_solid(dice);
        object.X_world_shape = support::random_pose(dice, 0.5);
        const Vec3 a = dice.in_cube(2.0);
        const Segment segment{a, a + Vec3(0, 1.2, 0)};
        const double radius = dice.between(0.1, 0.5);
        const Vec3 move = -a + dice.in_cube(2.0);
        const auto gap_at = [&](double f) {
            const Line line{segment.a + f * move, segment.b + f * move};
            return support::signed_distance(object, line) - radius;
        };
        if (gap_at(0.0) <= 1e-6) {
            continue;
        }
        const double exact = support::first_not_above_zero(gap_at).value_or(2.0);
        const double ours = sweep(segment, radius, move, obstacle_of(object)).value_or(2.0);
        // In metres, not fractions: for a grazing contact many fractions are equally good. A box's nearest
        // point is found by a search, to about 1e-9.
        const double travelled = std::min(ours, 1.0);
        ASSERT_GT(support::least_on_unit_interval([&](double f) { return gap_at(f * travelled); }), -1e-8)
            << i;
        if (ours < exact - 1e-6) {
            ASSERT_LT(gap_at(ours), 1e-6) << i << ": it stopped short of a contact";
        }
        contacts += ours <= 1.0 ? 1 : 0;
    }
    EXPECT_GT(contacts, sweeps / 20);
}

TEST(Sweep, MovingAwayFromOrAlongASurfaceIsFree) {
    const Obstacle floor = obstacle_of(Triangle{{-9, 0, -9}, {-9, 0, 9}, {18, 0, 0}}, {0, 1, 0});
    const Segment touching{{0, 0.3, 0}, {0, 1.5, 0}};
    EXPECT_EQ(sweep(touching, 0.3, {0, 1, 0}, floor), std::nullopt);
    EXPECT_EQ(sweep(touching, 0.3, {1, 0, 0}, floor), std::nullopt);
    EXPECT_EQ(sweep(touching, 0.3, {0, -1, 0}, floor), 0.0);
    EXPECT_EQ(sweep(touching, 0.3, {0, 0, 0}, floor), std::nullopt);
    const Segment deep{{0, 0.2, 0}, {0, 1.5, 0}};
    EXPECT_EQ(sweep(deep, 0.3, {0, 1, 0}, floor), std::nullopt) << "moving out";
    EXPECT_EQ(sweep(deep, 0.3, {0, -1, 0}, floor), 0.0) << "moving deeper";
}

TEST(Sweep, FindsTheContactToANanometre) {
    const Obstacle floor = obstacle_of(Triangle{{-9, 0, -9}, {-9, 0, 9}, {18, 0, 0}}, {0, 1, 0});
    const auto f = sweep({{0, 2.3, 0}, {0, 3.5, 0}}, 0.3, {0, -4, 0}, floor);
    ASSERT_TRUE(f);
    EXPECT_NEAR(*f, 0.5, 1e-9);
    EXPECT_EQ(sweep({{0, 2.3, 0}, {0, 3.5, 0}}, 0.3, {0, -1.99, 0}, floor), std::nullopt) << "too short";
}

}  // namespace
}  // namespace campuswalk::collision

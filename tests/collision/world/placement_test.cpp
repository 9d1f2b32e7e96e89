#include "collision/world/placement.h"

#include <gtest/gtest.h>

#include "tests/collision/mesh/solid_angle.h"
#include "tests/support/effort.h"
#include "tests/support/mesh_pieces.h"
#include "tests/support/penetration_oracle.h"
#include "tests/support/plain_solids.h"
#include "tests/support/random_scene.h"
#include "tests/support/village.h"

namespace campuswalk::collision {
namespace {

using support::add_object;
using support::Dice;
using support::Line;

constexpr double kRadius = 0.3;
constexpr double kHeight = 1.8;

std::optional<ObjectId> obstruction_at(const World& world, const Vec3& foot, const QueryFilter& filter = {}) {
    return obstruction(world, filter, foot, kRadius, kHeight);
}

std::optional<Vec3> free_place_at(const World& world, const Vec3& foot, double search) {
    return free_place(world, {}, foot, kRadius, kHeight, search);
}

TEST(Contains, AgreesWithTheSignedDistanceOfSolids) {
    Dice dice(100);
    int inside = 0;
    for (int i = 0; i < 5000; ++i) {
        Object object;
        object.shape = support::random_solid(dice);
        object.X_world_shape = support::random_pose(dice, 0.5);
        const Vec3 p = dice.in_cube(1.0);
        const double distance = support::signed_distance(object, Line{p, p});
        if (std::abs(distance) > 1e-9) {
            ASSERT_EQ(contains(object, p), distance < 0.0) << i;
        }
        inside += distance < 0.0 ? 1 : 0;
    }
    EXPECT_GT(inside, 200);
}

TEST(Contains, AgreesWithTheSolidAngleOfClosedMeshes) {
    Dice dice(101);
    TriangleMesh mesh;
    support::add_box(mesh, {-1, -1, -1}, {1, 2, 1});
    support::add_box(mesh, {0.5, 0, -0.5}, {3, 1, 0.5});
    Object object;
    object.shape = std::make_shared<const MeshCollider>(mesh);
    object.X_world_shape = support::random_pose(dice, 100.0);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 local = dice.in_cube(3.0);
        ASSERT_EQ(contains(object, object.X_world_shape * local), winding_number(mesh, local) > 0.5);
    }
}

TEST(Obstruction, AgreesWithThePenetrationOracle) {
    Dice dice(102);
    int obstructed = 0;
    const int worlds = support::repeats(15);
    for (int w = 0; w < worlds; ++w) {
        const auto world = support::make_soup(dice);
        const support::PenetrationOracle oracle(*world);
        for (int i = 0; i < 60; ++i) {
            const Vec3 foot = dice.in_cube(5.0).cwiseAbs() - Vec3(2, 0.5, 2);
            const auto seen = oracle.worst_penetration(foot, kRadius, kHeight);
            const auto ours = obstruction_at(*world, foot);
            if (seen.depth > 1e-8) {
                ASSERT_TRUE(ours) << w << ' ' << i;
            } else if (seen.depth < -1e-8) {
                ASSERT_FALSE(ours) << w << ' ' << i;
            }
            obstructed += ours ? 1 : 0;
        }
    }
    EXPECT_GT(obstructed, worlds * 10);
    EXPECT_LT(obstructed, worlds * 58);
}

TEST(Obstruction, NamesTheDeepestThenTheFirstObject) {
    World world(std::make_unique<LinearBroadPhase>());
    add_object(world, Box{{1, 1, 1}}, {1.25, 1, 0});
    const ObjectId deeper = add_object(world, Box{{1, 1, 1}}, {-1.2, 1, 0});
    add_object(world, Box{{1, 1, 1}}, {-1.2, 1, 0});
    EXPECT_EQ(obstruction_at(world, {0, 0, 0}), deeper);
    EXPECT_EQ(obstruction_at(world, {0, 5, 0}), std::nullopt);
}

TEST(Obstruction, IncludesTheInteriorOfAClosedMesh) {
    World world(std::make_unique<LinearBroadPhase>());
    TriangleMesh block;
    support::add_box(block, {-5, -5, -5}, {5, 5, 5});
    const ObjectId id = add_object(world, block);
    EXPECT_EQ(obstruction_at(world, {0, -1, 0}), id);
    EXPECT_EQ(obstruction_at(world, {0, 6, 0}), std::nullopt);
    TriangleMesh room = block;
    for (auto& t : room.triangles) {
        std::swap(t[0], t[1]);
    }
    World inside(std::make_unique<LinearBroadPhase>());
    add_object(inside, room);
    EXPECT_EQ(obstruction_at(inside, {0, -1, 0}), std::nullopt) << "a room modelled from within is free";
}

TEST(Obstruction, RespectsTheFilter) {
    World world(std::make_unique<LinearBroadPhase>());
    Object trigger;
    trigger.shape = Box{{1, 1, 1}};
    trigger.detection = Detection::trigger;
    trigger.layer = 4;
    world.add(trigger);
    EXPECT_FALSE(obstruction_at(world, {0, 0, 0}));
    EXPECT_TRUE(obstruction_at(world, {0, 0, 0}, {Detection::trigger, 0}));
    const std::vector<bool> disabled = {true};
    EXPECT_FALSE(obstruction_at(world, {0, 0, 0}, {Detection::trigger, 0, &disabled}));
    EXPECT_FALSE(obstruction_at(world, {0, 0, 0}, {Detection::trigger, 1U << 4U}));
}

TEST(IsPathFree, AgreesWithThePenetrationOracleAllAlong) {
    Dice dice(106);
    int free = 0;
    int blocked = 0;
    const int worlds = support::repeats(15);
    for (int w = 0; w < worlds; ++w) {
        const auto world = support::make_soup(dice);
        const support::PenetrationOracle oracle(*world);
        for (int i = 0; i < 30; ++i) {
            const Vec3 foot = dice.in_cube(5.0).cwiseAbs() - Vec3(2, 0.5, 2);
            const Vec3 move = dice.in_cube(1.0);
            double deepest = oracle.worst_penetration(foot, kRadius, kHeight).depth;
            if (deepest > -1e-3) {
                continue;  // what is touched at the start may be moved away from
            }
            for (int k = 1; k <= 100; ++k) {
                const Vec3 at = foot + k / 100.0 * move;
                deepest = std::max(deepest, oracle.worst_penetration(at, kRadius, kHeight).depth);
            }
            const bool is_free = is_path_free(*world, {}, foot, kRadius, kHeight, move);
            // Between two samples it may come nearer by half of what it moves by.
            if (deepest > 1e-8) {
                ASSERT_FALSE(is_free) << w << ' ' << i;
            } else if (deepest < -0.006 * move.norm()) {
                ASSERT_TRUE(is_free) << w << ' ' << i;
            }
            (is_free ? free : blocked) += 1;
        }
    }
    EXPECT_GT(free, worlds);
    EXPECT_GT(blocked, worlds);
}

TEST(IsPathFree, MayMoveAwayFromWhatItTouches) {
    World world(std::make_unique<LinearBroadPhase>());
    add_object(world, Box{{1, 1, 1}}, {-1.25, 1, 0});  // overlaps the body by 5 cm
    EXPECT_TRUE(is_path_free(world, {}, {0, 0.1, 0}, kRadius, kHeight, {2, 0, 0}));
    EXPECT_TRUE(is_path_free(world, {}, {0, 0.1, 0}, kRadius, kHeight, {0, 0, 2}));
    EXPECT_FALSE(is_path_free(world, {}, {0, 0.1, 0}, kRadius, kHeight, {-0.01, 0, 0}));
    QueryFilter filter;
    filter.ignored_layers = 1;
    EXPECT_TRUE(is_path_free(world, filter, {0, 0.1, 0}, kRadius, kHeight, {-2, 0, 0}));
}

TEST(FreePlace, IsTheRequestedPlaceIfThatIsFree) {
    World world(std::make_unique<LinearBroadPhase>());
    add_object(world, Box{{1, 1, 1}}, {0, -1, 0});
    EXPECT_EQ(free_place_at(world, {0, 0.2, 0}, 0.5), Vec3(0, 0.2, 0));
    EXPECT_EQ(free_place_at(world, {7, -3, 0}, 0.0), Vec3(7, -3, 0));
}

TEST(FreePlace, IsLiftedOutOfSlightlyHigherGround) {
    World world(std::make_unique<LinearBroadPhase>());
    add_object(world, Box{{1, 1, 1}}, {0, -1, 0});
    const auto place = free_place_at(world, {0, -0.32, 0}, 0.5);
    ASSERT_TRUE(place);
    EXPECT_GE(place->y(), -1e-9);
    EXPECT_LT(place->y(), 0.05);
    EXPECT_EQ(place->x(), 0.0);
    EXPECT_FALSE(free_place_at(world, {0, -0.62, 0}, 0.5)) << "too deep";
}

// The nearest free placement.

std::optional<FreePlacement> placement_at(const World& world, const Vec3& foot) {
    return nearest_free_placement(world, {}, foot, kRadius, kHeight, 0.5);
}

TEST(NearestFreePlacement, IsBesideTheOverlappedWall) {
    World world(std::make_unique<LinearBroadPhase>());
    const ObjectId wall = add_object(world, Box{{0.1, 2, 5}}, {1, 2, 0});  // its face at x = 0.9
    for (const double x : {0.61, 0.75, 0.899}) {
        const auto placement = placement_at(world, {x, 0, 0});
        ASSERT_TRUE(placement) << x;
        EXPECT_EQ(placement->pushed_out_of, wall);
        EXPECT_NEAR(placement->foot.x(), 0.9 - kRadius - 1e-3, 1e-4) << x;
        EXPECT_NEAR(placement->foot.z(), 0.0, 1e-9);
        EXPECT_EQ(placement->foot.y(), 0.0);
    }
    EXPECT_EQ(placement_at(world, {0.59, 0, 0})->pushed_out_of, std::nullopt);
    EXPECT_FALSE(placement_at(world, {0.95, 0, 0})) << "its axis is inside";
}

TEST(NearestFreePlacement, IsOnTheSameSideOfAThinWall) {
    // A place beyond the sheet would be as near; in the end a block leaves no room on this side.
    TriangleMesh sheet;
    support::add_quad(sheet, {0.1, 0, -9}, {0.1, 9, -9}, {0.1, 9, 9}, {0.1, 0, 9});
    World world(std::make_unique<LinearBroadPhase>());
    add_object(world, sheet);
    const auto alone = placement_at(world, {0, 0, 0});
    ASSERT_TRUE(alone);
    EXPECT_NEAR(alone->foot.x(), 0.1 - kRadius - 1e-3, 1e-4);
    add_object(world, Box{{0.1, 2, 9}}, {-0.4, 2, 0});  // its face at x = -0.3: no room in between
    EXPECT_FALSE(placement_at(world, {0, 0, 0}));
}

TEST(NearestFreePlacement, IsAtMostTwiceTheRadiusAway) {
    // A niche 0.55 m wide, too narrow for the body: the only way out is its mouth.
    const auto in_niche = [](double depth) {
        World world(std::make_unique<LinearBroadPhase>());
        add_object(world, Box{{0.5, 2, 2}}, {-0.775, 2, 2});
        add_object(world, Box{{0.5, 2, 2}}, {0.775, 2, 2});
        return placement_at(world, {0, 0, depth}).has_value();
    };
    EXPECT_TRUE(in_niche(0.3));
    EXPECT_FALSE(in_niche(0.8));
}

TEST(NearestFreePlacement, IsNearlyTheNearest) {
    const auto village = support::make_village();
    const support::PenetrationOracle oracle(*village);
    Dice dice(104);
    // Few places overlap something, and not too deeply: the oracle finds them.
    const int needed = support::repeats(16);
    int pushed = 0;
    for (int i = 0; i < 50'000 && pushed < needed; ++i) {
        const double x = dice.between(-19, 19);
        const double y = dice.between(0.02, 0.3);
        const Vec3 foot(x, y, dice.between(-19, 19));
        const double depth = oracle.worst_penetration(foot, kRadius, kHeight).depth;
        if (depth < 0.02 || depth > 0.2) {
            continue;
        }
        const auto placement = placement_at(*village, foot);
        if (!placement) {
            continue;
        }
        ASSERT_LE(oracle.worst_penetration(placement->foot, kRadius, kHeight).depth, 1e-9)
            << foot.transpose();
        const double moved = (placement->foot - foot).norm();
        if (!placement->pushed_out_of || placement->foot.y() - foot.y() >= 0.05) {
            continue;
        }
        ++pushed;
        ASSERT_LE(moved, 2.0 * kRadius + 1e-9);
        // Random places that are much nearer aren't free.
        for (int j = 0; j < 50; ++j) {
            Vec3 aside = dice.in_cube(1.0);
            aside.y() = 0.0;
            const Vec3 tried = foot + aside.normalized() * dice.between(0.0, moved - 0.03);
            if (moved > 0.03) {
                ASSERT_GT(oracle.worst_penetration(tried, kRadius, kHeight).depth, -2e-3)
                    << foot.transpose() << " -> " << tried.transpose();
            }
        }
    }
    EXPECT_EQ(pushed, needed);
}

TEST(FreePlace, IsNeverInsideAnything) {
    const auto village = support::make_village();
    const support::PenetrationOracle oracle(*village);
    Dice dice(103);
    int lifted = 0;
    for (int i = 0; i < support::repeats(300); ++i) {
        const Vec3 foot = Vec3(dice.between(-19, 19), 0, dice.between(-19, 19));
        if (const auto place = free_place_at(*village, foot, 1.0)) {
            ASSERT_LE(oracle.worst_penetration(*place, kRadius, kHeight).depth, 1e-9) << foot.transpose();
            lifted += place->y() > foot.y() ? 1 : 0;
        }
    }
    EXPECT_GT(lifted, support::repeats(50));
}

}  // namespace
}  // namespace campuswalk::collision

#include "engine/walkspace/report/start_place.h"
#include "engine/walkspace/explore/campus_settings.h"

#include <algorithm>
#include <memory>

#include <gtest/gtest.h>

#include "collision/mesh/mesh_collider.h"
#include "engine/walkspace/report/walk_report.h"
#include "scene/model/upright_box.h"
#include "tests/engine/small_campus.h"
#include "tests/support/mesh_pieces.h"

namespace campuswalk::engine {
namespace {

using collision::Vec3;

std::optional<Vec3> start_on(const scene::Campus& campus, const StartPreference& preference = {},
                             const collision::Aabb& within = {}) {
    ExploreSettings settings = explore_settings(campus, AvatarProfile(), 60);
    settings.within = within;
    const auto starts = best_starts(WorkerWorlds(campus.world, 1, {}), settings, preference);
    return starts.empty() ? std::nullopt : std::optional(starts.front().foot);
}

scene::Campus lawn() {
    scene::Campus campus = empty_campus();
    add_box(campus, "lawn", {-20, -0.2, -20}, {20, 0, 20});
    return campus;
}

TEST(BestStart, IsNearTheMiddleOfALawn) {
    const auto foot = start_on(lawn(), {.near = {3, 0, 3}});
    ASSERT_TRUE(foot);
    EXPECT_NEAR(foot->y(), 0.0, 0.01);
    EXPECT_LE(foot->cwiseAbs().maxCoeff(), 20.0 - 8.0 + 0.5) << "far from its edges";
    EXPECT_LT((*foot - Vec3(3, 0, 3)).norm(), 1.0);
}

TEST(BestStart, IsUnderTheOpenSky) {
    scene::Campus campus = lawn();
    add_box(campus, "hall", {-8, 3, -8}, {8, 3.3, 8});  // a roof on nothing, with room below
    const auto foot = start_on(campus);
    ASSERT_TRUE(foot);
    EXPECT_NEAR(foot->y(), 0.0, 0.01);
    EXPECT_GT(foot->cwiseAbs().maxCoeff(), 8.0);
}

TEST(BestStart, IsOnABlockOfTerrainAndNotWithin) {
    scene::Campus campus = empty_campus();
    collision::TriangleMesh block;
    support::add_box(block, {-20, -30, -20}, {20, 0, 20});
    add_object(campus, "terrain", std::make_shared<const collision::MeshCollider>(std::move(block)),
               Vec3::Zero());
    const auto foot = start_on(campus);
    ASSERT_TRUE(foot);
    EXPECT_NEAR(foot->y(), 0.0, 0.01);
}

TEST(BestStart, IsNotOnTheEavesOfARoof) {
    scene::Campus campus = empty_campus();
    add_box(campus, "floor", {-8, -0.2, -8}, {8, 0, 8});
    add_box(campus, "roof", {-11, 5, -11}, {11, 5.2, 11});
    const auto foot = start_on(campus);
    ASSERT_TRUE(foot);
    EXPECT_NEAR(foot->y(), 0.0, 0.01);
}

TEST(BestStart, TellsThatItIsAboveRooms) {
    scene::Campus campus = empty_campus();
    add_box(campus, "roof", {-11, 5, -11}, {11, 5.2, 11});
    add_box(campus, "store", {-11, 0, -11}, {11, 2, 11});  // full of what leaves no room to stand
    for (int x = -10; x <= 10; ++x) {
        add_box(campus, "shelf" + std::to_string(x), {x - 0.2, 0, -11}, {x + 0.2, 4, 11});
    }
    const ExploreSettings settings = explore_settings(campus, AvatarProfile(), 60);
    const auto starts = best_starts(WorkerWorlds(campus.world, 1, {}), settings, {});
    ASSERT_FALSE(starts.empty());
    EXPECT_NEAR(starts[0].foot.y(), 5.2, 0.01);
    EXPECT_TRUE(starts[0].is_aside);
}

TEST(BestStart, IsOnEachLargeGroundThatThereIs) {
    scene::Campus campus = empty_campus();
    add_box(campus, "small", {-40, -0.2, -5}, {-34, 0, 5});
    add_box(campus, "half", {-30, -0.2, -10}, {-10, 0, 0});
    add_box(campus, "whole", {0, -0.2, -10}, {20, 0, 10});
    const ExploreSettings settings = explore_settings(campus, AvatarProfile(), 60);
    const auto starts = best_starts(WorkerWorlds(campus.world, 1, {}), settings, {});
    ASSERT_EQ(starts.size(), 2U);
    EXPECT_GT(starts[0].foot.x(), 0.0);
    EXPECT_NEAR(starts[0].area, 400.0, 40.0);
    EXPECT_LT(starts[1].foot.x(), -10.0);
    EXPECT_NEAR(starts[1].area, 200.0, 20.0);
}

TEST(BestStart, IsNotOnAWall) {
    scene::Campus campus = empty_campus();
    add_box(campus, "floor", {-20, -0.2, -20}, {20, 0, 20});
    for (const double x : {-20.0, -10.0, 0.0, 10.0, 19.0}) {  // wide enough to walk on, and more of it
        add_box(campus, "wall-x" + std::to_string(static_cast<int>(x)), {x, 0, -20}, {x + 1.0, 13, 20});
    }
    for (const double z : {-20.0, -10.0, 0.0, 10.0}) {
        add_box(campus, "wall-z" + std::to_string(static_cast<int>(z)), {-20, 0, z}, {20, 13, z + 2.4});
    }
    const auto foot = start_on(campus);
    ASSERT_TRUE(foot);
    EXPECT_NEAR(foot->y(), 0.0, 0.01);
}

TEST(BestStart, IsOnTheLowestFloorWithoutGround) {
    scene::Campus campus = empty_campus();
    for (int storey = 0; storey < 4; ++storey) {
        add_box(campus, "floor-" + std::to_string(storey), {-10, 3.0 * storey - 0.2, -10},
                {10, 3.0 * storey, 10});
    }
    const auto foot = start_on(campus);
    ASSERT_TRUE(foot);
    EXPECT_NEAR(foot->y(), 0.0, 0.01);
}

TEST(BestStart, IsOutsideOfBuildings) {
    scene::UprightBox box;
    box.size = {10, 4, 10};
    const auto foot = start_on(lawn(), {.is_inside = [&](const Vec3& p) { return box.depth_of(p) > -0.5; }});
    ASSERT_TRUE(foot);
    EXPECT_LE(box.depth_of(*foot), -0.5);
    EXPECT_LT(foot->norm(), 13.0);
}

TEST(BestStart, IsAwayFromWalls) {
    scene::Campus campus = lawn();
    add_box(campus, "tower", {-2, 0, -2}, {2, 30, 2});
    const auto foot = start_on(campus);
    ASSERT_TRUE(foot);
    EXPECT_NEAR(foot->y(), 0.0, 0.01);
    const Vec3 outside = (foot->cwiseAbs() - Vec3(2, 0, 2)).cwiseMax(0.0);
    EXPECT_GT(outside.norm(), 5.5);  // eight metres along the axes, less across
}

TEST(BestStart, IsOnTheLargestGround) {
    scene::Campus campus = empty_campus();
    add_box(campus, "small", {-10, -0.2, -10}, {-5, 0, -5});
    add_box(campus, "large", {5, -0.2, -10}, {25, 0, 10});
    const auto foot = start_on(campus, {.near = {-7, 0, -7}});
    ASSERT_TRUE(foot);
    EXPECT_GT(foot->x(), 5.0);
}

TEST(BestStart, IsWithinTheLimits) {
    const auto foot = start_on(lawn(), {.near = {-15, 0, -15}}, {{0, -1, 0}, {10, 3, 10}});
    ASSERT_TRUE(foot);
    EXPECT_TRUE(foot->x() >= 0.0 && foot->z() >= 0.0 && foot->maxCoeff() <= 10.0);
}

TEST(BestStart, IsNowhereOnABareWall) {
    scene::Campus campus = empty_campus();
    add_box(campus, "wall", {-3, 0, -0.025}, {3, 4, 0.025});
    EXPECT_FALSE(start_on(campus));
}

}  // namespace
}  // namespace campuswalk::engine

#include "engine/simulation/spawn_fall.h"

#include <gtest/gtest.h>

#include "collision/geometry/shapes.h"
#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"

namespace campuswalk::engine {
namespace {

SpawnFall fall_from(const scene::Campus& campus, const Eigen::Vector3d& foot) {
    return fall_at_spawn(campus, walk_of({spawn_at(foot)}));
}

TEST(SpawnFall, IsTheHeightAboveWhatCarriesTheBody) {
    const scene::Campus campus = level_campus(10.0);
    for (const double height : {0.0, 0.3, 0.49, 0.51, 2.0, 30.0}) {
        const SpawnFall fall = fall_from(campus, {0, height, 0});
        EXPECT_TRUE(fall.lands);
        EXPECT_NEAR(fall.height, height, 0.01);
    }
}

TEST(SpawnFall, IsStoppedByWhatTheBodyTouchesAndNotOnlyBelowItsMiddle) {
    scene::Campus campus = level_campus(10.0);
    add_box(campus, "beam", {0.15, 0, -5}, {0.2, 2, 5});
    const SpawnFall fall = fall_from(campus, {0, 3, 0});
    EXPECT_TRUE(fall.lands);
    EXPECT_LT(fall.height, 3.0 + 0.01);
    EXPECT_GT(fall.height, 0.9);
}

TEST(SpawnFall, NeverLandsOverNothing) {
    const scene::Campus campus = level_campus(10.0);
    EXPECT_FALSE(fall_from(campus, {50, 0, 0}).lands);
    EXPECT_FALSE(fall_from(campus, {0, -3, 0}).lands) << "below the floor";
    EXPECT_FALSE(fall_from(empty_campus(), {0, 0, 0}).lands);
}

TEST(SpawnFall, GoesThroughLayersThatTheAvatarIgnores) {
    scene::Campus campus = level_campus(10.0);
    ObjectTraits furniture;
    furniture.layer = "furniture";
    add_box(campus, "table", {-1, 0, -1}, {1, 1, 1}, furniture);
    Walk walk = walk_of({spawn_at({0, 1, 0})});
    EXPECT_NEAR(fall_at_spawn(campus, walk).height, 0.0, 0.01);
    walk.avatar.ignore_layers = {"furniture"};
    EXPECT_NEAR(fall_at_spawn(campus, walk).height, 1.0, 0.01);
}

}  // namespace
}  // namespace campuswalk::engine

#include "scene/suggest/walkable_ground.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "tests/scene/box_model.h"
#include "tests/scene/suggest/solid_model.h"

namespace campuswalk::scene {
namespace {

using Eigen::Vector3d;

WalkableGround ground_of(const Model& model, const Vector3d& center = Vector3d::Zero()) {
    return {test::solid(model), Vector3d::Zero(), center};
}

Model lawn() {
    Model model;
    test::add_box(model, "lawn", {-20, -0.2, -20}, {20, 0, 20});
    return model;
}

Vector3d best_foot(const Model& model, const Vector3d& center, const std::vector<UprightBox>& boxes = {}) {
    const WalkableGround ground = ground_of(model, center);
    const auto best = ground.best_spawn_spot(center, boxes);
    return best ? ground.spots()[*best].foot : Vector3d::Constant(-999.0);
}

TEST(WalkableGround, CoversAFlatSquare) {
    const WalkableGround ground = ground_of(lawn());
    EXPECT_EQ(ground.spots().size(), 80U * 80U);
    for (const auto& spot : ground.spots()) {
        ASSERT_NEAR(spot.foot.y(), 0.0, 1e-6);
        ASSERT_TRUE(spot.open_sky);
        ASSERT_FALSE(spot.upstairs);
        ASSERT_EQ(spot.component, 1U);
    }
    EXPECT_EQ(ground.count_reachable(0), 80U * 80U);
}

TEST(WalkableGround, ExcludesPlacesWithoutClearance) {
    Model model = lawn();
    test::add_box(model, "block", {-2, 0, -2}, {2, 3, 2});
    test::add_box(model, "low", {6, 1.5, 6}, {10, 1.7, 10});
    const WalkableGround ground = ground_of(model);
    for (const auto& spot : ground.spots()) {
        const Vector3d& p = spot.foot;
        if (p.y() < 1.0) {  // a body of 0.3 m radius, measured to the walls
            const Vector3d outside = (p.cwiseAbs() - Vector3d(2, 9, 2)).cwiseMax(0.0);
            ASSERT_GE(Vector3d(outside.x(), 0, outside.z()).norm(), 0.3 - 1e-6) << p.transpose();
            ASSERT_FALSE(p.x() > 5.9 && p.x() < 10.1 && p.z() > 5.9 && p.z() < 10.1) << p.transpose();
        }
    }
}

TEST(WalkableGround, ConnectsLowStepsOnly) {
    for (const double step : {0.25, 0.5}) {
        Model model;
        test::add_box(model, "low", {-10, -1, -10}, {0, 0, 10});
        test::add_box(model, "high", {0, -1, -10}, {10, step, 10});
        std::set<std::uint32_t> components;
        const WalkableGround ground = ground_of(model);
        for (const auto& spot : ground.spots()) {
            components.insert(spot.component);
        }
        EXPECT_EQ(components.size(), step < 0.3 ? 1U : 2U) << step;
    }
}

TEST(WalkableGround, SpawnsOnTheGroundUnderTheOpenSky) {
    Model model = lawn();
    test::add_box(model, "hall", {-8, 3, -8}, {8, 3.3, 8});  // a roof on nothing, with room below
    const Vector3d foot = best_foot(model, {0, 0, 0});
    EXPECT_NEAR(foot.y(), 0.0, 1e-6);
    EXPECT_GT(foot.cwiseAbs().maxCoeff(), 8.0);  // and under the open sky
}

TEST(WalkableGround, SpawnsOnTheLowestFloorWithoutGround) {
    Model model;
    for (int storey = 0; storey < 4; ++storey) {
        test::add_box(model, "floor", {-10, 3.0 * storey - 0.2, -10}, {10, 3.0 * storey, 10});
    }
    EXPECT_NEAR(best_foot(model, {0, 0, 0}).y(), 0.0, 1e-6);
}

TEST(WalkableGround, SpawnsOutsideOfTheBoxes) {
    UprightBox box;
    box.size = {10, 4, 10};
    const Vector3d foot = best_foot(lawn(), {0, 0, 0}, {box});
    EXPECT_LE(box.depth_of(foot), -0.5);
    EXPECT_LT(foot.norm(), 13.0);
}

TEST(WalkableGround, SpawnsAwayFromWalls) {
    Model model = lawn();
    test::add_box(model, "tower", {-2, 0, -2}, {2, 30, 2});
    const Vector3d foot = best_foot(model, {0, 0, 0});
    EXPECT_NEAR(foot.y(), 0.0, 1e-6);
    const Vector3d outside = (foot.cwiseAbs() - Vector3d(2, 0, 2)).cwiseMax(0.0);
    EXPECT_GT(outside.norm(), 5.5);  // eight metres along the axes, less across
}

TEST(WalkableGround, PathsGoAroundWalls) {
    Model model = lawn();
    test::add_box(model, "wall", {-20, 0, -0.2}, {15, 3, 0.2});
    const WalkableGround ground = ground_of(model);
    const auto nearest = [&](const Vector3d& p) {
        const auto spot = std::ranges::min_element(
            ground.spots(), {}, [&](const WalkableGround::Spot& s) { return (s.foot - p).norm(); });
        return static_cast<std::uint32_t>(spot - ground.spots().begin());
    };
    const std::uint32_t start = nearest({-10, 0, 10});
    const std::uint32_t end = nearest({-10, 0, -10});
    const auto path = ground.waypoints(ground.shortest_paths_from(start), end);
    ASSERT_GE(path.size(), 3U);
    EXPECT_EQ(path.front(), ground.spots()[start].foot);
    EXPECT_EQ(path.back(), ground.spots()[end].foot);
    for (std::size_t i = 1; i < path.size(); ++i) {  // no segment crosses the wall
        const Vector3d& a = path[i - 1];
        const Vector3d& b = path[i];
        if ((a.z() > 0.0) != (b.z() > 0.0)) {
            EXPECT_GT(a.x() + (b.x() - a.x()) * a.z() / (a.z() - b.z()), 15.3);
        }
    }
}

TEST(WalkableGround, HasNoSpotsOnABareWall) {
    Model model;
    test::add_turned_box(model, "wall", {0, 2, 0}, {6, 4, 0.05}, 0);
    EXPECT_FALSE(ground_of(model).best_spawn_spot(Vector3d::Zero(), {}));
}

}  // namespace
}  // namespace campuswalk::scene

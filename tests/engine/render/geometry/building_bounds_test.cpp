#include "engine/render/geometry/building_bounds.h"

#include <gtest/gtest.h>

#include "tests/engine/render/small_scenes.h"

namespace campuswalk::engine::render::test {
namespace {

TEST(BuildingBounds, EncloseTheNodesOfEachBuildingInTheWorld) {
    Eigen::Matrix4d moved = Eigen::Matrix4d::Identity();
    moved(0, 3) = 10.0;
    scene::Building tower;
    tower.id = "tower";
    scene::Building park;
    park.id = "park";
    const scene::Campus campus = campus_of(SceneBuilder()
                                               .colored(kGrey)
                                               .ground(100.0)
                                               .named("tower")
                                               .placed(moved)
                                               .box({-1, 0, -2}, {1, 9, 2})
                                               .model(),
                                           {tower, park});
    const auto bounds = building_bounds(campus);
    ASSERT_EQ(bounds.size(), 2U);
    EXPECT_TRUE(bounds[0].min.isApprox(Eigen::Vector3d(9, 0, -2)));
    EXPECT_TRUE(bounds[0].max.isApprox(Eigen::Vector3d(11, 9, 2)));
    EXPECT_TRUE(bounds[1].empty()) << "no node is named park";
}

}  // namespace
}  // namespace campuswalk::engine::render::test

#include "engine/render/geometry/sky_view.h"

#include <span>

#include <gtest/gtest.h>

#include "tests/engine/render/small_scenes.h"

namespace campuswalk::engine::render::test {
namespace {

using Eigen::Vector3d;

double open_at(const scene::Model& model, const Vector3d& point) {
    const CampusGeometry geometry = bake(std::span(&model, 1), 20.0);
    return sky_view_factor(geometry, point - geometry.origin);
}

SceneBuilder field() {
    SceneBuilder scene;
    scene.colored(kGrey).ground(100.0);
    return scene;
}

const Vector3d kEyes(0, 1.65, 0);

TEST(SkyViewFactor, IsOneInAField) {
    EXPECT_EQ(open_at(field().model(), kEyes), 1.0);
    EXPECT_EQ(sky_view_factor({}, Vector3d::Zero()), 1.0);
}

TEST(SkyViewFactor, IsHalfBesideATallWall) {
    EXPECT_NEAR(open_at(field().box({-50, 0, -2}, {50, 40, -0.1}).model(), kEyes), 0.5, 0.1);
}

TEST(SkyViewFactor, IsZeroInARoomAndSmallAtItsDoor) {
    // Four walls and a roof; the wall towards +Z has an opening 4 m wide.
    const scene::Model room = field()
                                  .box({-5, 3, -5}, {5, 3.2, 5})
                                  .box({-5, 0, -5}, {5, 3, -4.8})
                                  .box({-5, 0, -5}, {-4.8, 3, 5})
                                  .box({4.8, 0, -5}, {5, 3, 5})
                                  .box({-5, 0, 4.8}, {-2, 3, 5})
                                  .box({2, 0, 4.8}, {5, 3, 5})
                                  .model();
    EXPECT_LT(open_at(room, kEyes), 0.05);
    const double by_the_door = open_at(room, {0, 1.65, 4.5});
    EXPECT_GT(by_the_door, 0.1);
    EXPECT_LT(by_the_door, 0.6);
}

TEST(SkyViewFactor, IgnoresGlassFoliageAndDistantCeilings) {
    for (const scene::AlphaMode mode : {scene::AlphaMode::blend, scene::AlphaMode::mask}) {
        const scene::Model roofed =
            field().colored({1, 1, 1, 0.4F}).alpha(mode).box({-9, 3, -9}, {9, 3.2, 9}).model();
        EXPECT_EQ(open_at(roofed, kEyes), 1.0);
    }
    EXPECT_EQ(open_at(field().box({-9, 40, -9}, {9, 41, 9}).model(), kEyes), 1.0);
}

}  // namespace
}  // namespace campuswalk::engine::render::test

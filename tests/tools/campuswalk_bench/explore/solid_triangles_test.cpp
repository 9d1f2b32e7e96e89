#include "tools/campuswalk_bench/explore/solid_triangles.h"

#include <memory>
#include <utility>

#include <gtest/gtest.h>

#include "tests/support/mesh_pieces.h"
#include "tests/support/mesh_volume.h"

namespace campuswalk::tools::bench {
namespace {

using collision::Vec3;

constexpr double kPi = 3.141592653589793;

/// Of a solid somewhere, turned.
double volume_of(const collision::Shape& shape) {
    collision::World world(std::make_unique<collision::LinearBroadPhase>());
    collision::Object object;
    object.shape = shape;
    object.X_world_shape = {support::turn({1, 2, 3}, 0.7), {4, -2, 1}};
    world.add(std::move(object));
    return support::enclosed_volume(solid_triangles(world));
}

TEST(SolidTriangles, EncloseWhatTheyStandFor) {
    EXPECT_NEAR(volume_of(collision::Box{{1, 2, 0.5}}), 8.0, 1e-5);
    EXPECT_NEAR(volume_of(collision::Sphere{2.0}) / (4.0 / 3.0 * kPi * 8.0), 1.0, 0.03);
    EXPECT_NEAR(volume_of(collision::Capsule{0.5, 1.5}) / (kPi * 0.25 * (3.0 + 2.0 / 3.0)), 1.0, 0.03);
    EXPECT_NEAR(volume_of(collision::Wheel{0.8, 0.25}) / (kPi * 0.64 * 0.5), 1.0, 0.03);
    collision::TriangleMesh cube;
    support::add_box(cube, {0, 0, 0}, {2, 2, 2});
    EXPECT_NEAR(volume_of(std::make_shared<const collision::MeshCollider>(std::move(cube))), 8.0, 1e-5);
}

TEST(SolidTriangles, LeaveOutWhatIsNotSolid) {
    collision::World world(std::make_unique<collision::LinearBroadPhase>());
    collision::Object trigger;
    trigger.shape = collision::Box{};
    trigger.detection = collision::Detection::trigger;
    world.add(trigger);
    EXPECT_EQ(solid_triangles(world).triangles.size(), 0U);
}

}  // namespace
}  // namespace campuswalk::tools::bench

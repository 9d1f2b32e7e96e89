#include "scene/model/mesh_parts.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "tests/support/mesh_volume.h"
#include "tests/support/solid_mesh.h"

namespace campuswalk::scene {
namespace {

using collision::Pose;
using collision::TriangleMesh;
using collision::Vec3;

Pose quarter_turn_about_y() {
    Pose X;
    X.rotation << 0, 0, 1, 0, 1, 0, -1, 0, 0;
    X.translation = {10.0, 0.0, 5.0};
    return X;
}

TEST(MeshParts, BoxIsClosedAndPlaced) {
    TriangleMesh mesh;
    MeshParts(mesh).add_box(quarter_turn_about_y(), {0.0, 1.0, 2.0}, {1.0, 0.5, 0.25});
    EXPECT_EQ(mesh.triangles.size(), 12U);
    EXPECT_NEAR(support::enclosed_volume(mesh), 2.0 * 1.0 * 0.5, 1e-6);
    const support::SolidMesh parts(mesh);
    EXPECT_TRUE(parts.contains({12.0, 1.0, 5.9}));
    EXPECT_FALSE(parts.contains({12.3, 1.0, 5.0}));
    EXPECT_FALSE(parts.contains({12.0, 1.6, 5.0}));
}

TEST(MeshParts, BallIsClosedAndScaledByItsBumps) {
    TriangleMesh smooth;
    MeshParts(smooth).add_ball(Vec3(1.0, 2.0, 3.0), Vec3(2.0, 1.0, 1.0), 40, 30, [] { return 1.0; });
    EXPECT_NEAR(support::enclosed_volume(smooth), 4.0 / 3.0 * 3.14159265 * 2.0, 0.1);
    EXPECT_TRUE(support::SolidMesh(smooth).contains({2.9, 2.0, 3.0}));
    EXPECT_FALSE(support::SolidMesh(smooth).contains({1.0, 3.01, 3.0}));
    TriangleMesh half;
    MeshParts(half).add_ball(Vec3(1.0, 2.0, 3.0), Vec3(2.0, 1.0, 1.0), 40, 30, [] { return 0.5; });
    EXPECT_NEAR(support::enclosed_volume(half), support::enclosed_volume(smooth) / 8.0, 1e-3);
}

TEST(MeshParts, PrismFacesOutward) {
    TriangleMesh mesh;
    MeshParts(mesh).add_prism(quarter_turn_about_y(), {0.0, -1.0, 0.0}, 0.5, 3.0, 6);
    EXPECT_EQ(mesh.triangles.size(), 12U);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const collision::Triangle t = vertices(mesh, i);
        const Vec3 out = (t.a + t.b + t.c) / 3.0 - Vec3(10.0, 0.5, 5.0);
        const Vec3 normal = (t.b - t.a).cross(t.c - t.a).normalized();
        EXPECT_NEAR(normal.dot(out), 0.5 * 0.8660254, 1e-5);
        EXPECT_NEAR(std::min({t.a.y(), t.b.y(), t.c.y()}), -1.0, 1e-6);
        EXPECT_NEAR(std::max({t.a.y(), t.b.y(), t.c.y()}), 2.0, 1e-6);
    }
}

}  // namespace
}  // namespace campuswalk::scene

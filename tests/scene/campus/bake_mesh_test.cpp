#include "scene/campus/bake_mesh.h"

#include <gtest/gtest.h>

namespace campuswalk::scene {
namespace {

using collision::Vec3;

TEST(BakeMesh, KeepsMillimetresFarFromTheWorldOrigin) {
    const Vec3 far(84616.0004, 12.5, 447750.0004);
    WorldGeometry geometry;
    geometry.positions = {far, far + Vec3(1.001, 0, 0), far + Vec3(0, 0, 2.002)};
    geometry.triangles = {{0, 1, 2}};
    const BakedMesh baked = bake_mesh(geometry);
    ASSERT_EQ(baked.mesh.triangles.size(), 1U);
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 world = baked.mesh.positions[k].cast<double>() + baked.p_world_origin;
        EXPECT_LT((world - geometry.positions[k]).norm(), 1e-6);
    }
    const Vec3 millimetres = baked.p_world_origin * 1000.0;
    EXPECT_LT((millimetres - Vec3(millimetres.array().round())).norm(), 1e-6);
}

TEST(BakeMesh, JoinsEqualPositionsAndDropsUnusedOnes) {
    WorldGeometry geometry;
    geometry.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {9, 9, 9}};
    geometry.triangles = {{0, 1, 2}, {3, 4, 5}};
    const BakedMesh baked = bake_mesh(geometry);
    EXPECT_EQ(baked.mesh.positions.size(), 4U);
    EXPECT_EQ(baked.mesh.triangles[1], (std::array<std::uint32_t, 3>{1, 3, 2}));
    EXPECT_EQ(baked.p_world_origin, Vec3(0.5, 0.5, 0));  // the unused (9, 9, 9) doesn't count
}

TEST(BakeMesh, DropsZeroAreaTriangles) {
    WorldGeometry geometry;
    geometry.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {1, 1e-9, 0}, {1, 1e-4, 0}};
    geometry.triangles = {{0, 1, 2}, {0, 0, 1}, {0, 1, 3}, {0, 4, 3}, {0, 3, 5}};
    const BakedMesh baked = bake_mesh(geometry);
    EXPECT_EQ(baked.zero_area, 3U);
    EXPECT_EQ(baked.mesh.triangles.size(), 2U);  // a sliver of a tenth of a millimetre is kept
}

TEST(BakeMesh, IsEmptyWithoutTriangles) {
    EXPECT_TRUE(bake_mesh(WorldGeometry{}).mesh.triangles.empty());
    EXPECT_TRUE(bake_every_triangle(WorldGeometry{}).mesh.triangles.empty());
}

TEST(BakeEveryTriangle, KeepsThinTrianglesAndAllIndices) {
    WorldGeometry geometry;
    geometry.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}};
    geometry.triangles = {{0, 0, 1}, {0, 1, 2}, {0, 1, 3}};
    const BakedMesh baked = bake_every_triangle(geometry);
    EXPECT_EQ(baked.mesh.triangles.size(), 3U);
    EXPECT_EQ(baked.mesh.triangles[1], (std::array<std::uint32_t, 3>{0, 1, 2}));
    EXPECT_EQ(baked.zero_area, 0U);
}

TEST(BakeEveryTriangle, KeepsPositionsThatFitIntoFloatsExactly) {
    WorldGeometry geometry;
    geometry.positions = {{0.1F, 0, 1000.3F}, {0.7F, 0, 0}, {0, 1e-20F, 0}};
    geometry.triangles = {{0, 1, 2}};
    const BakedMesh exact = bake_every_triangle(geometry);
    EXPECT_EQ(exact.p_world_origin, Vec3(0, 0, 0));
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(exact.mesh.positions[k].cast<double>(), geometry.positions[k]);
    }
    geometry.positions[0].x() = 84616.0004;
    const BakedMesh rounded = bake_every_triangle(geometry);
    EXPECT_EQ(rounded.p_world_origin, Vec3(42308, 0, 500.15));
    EXPECT_EQ(rounded.mesh.positions[0].x(), static_cast<float>(geometry.positions[0].x() - 42308.0));
}

}  // namespace
}  // namespace campuswalk::scene

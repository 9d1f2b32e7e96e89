#include "collision/mesh/mesh_collider.h"

#include <limits>
#include <optional>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/support/mesh_pieces.h"

namespace campuswalk::collision {
namespace {

TriangleMesh box() {
    TriangleMesh mesh;
    support::add_box(mesh, {0, 0, 0}, {1, 1, 1});
    return mesh;
}

TEST(MeshCollider, HoldsTheMeshAndOneTree) {
    const MeshCollider bvh8(box());
    EXPECT_EQ(bvh8.tree_kind(), TreeKind::bvh8);
    EXPECT_EQ(bvh8.mesh().triangles.size(), 12U);
    EXPECT_FALSE(bvh8.bvh8().leaves.empty());
    EXPECT_THROW(bvh8.hybrid_tree(), std::bad_variant_access);
    const MeshCollider hybrid(box(), TreeKind::hybrid);
    EXPECT_EQ(hybrid.tree_kind(), TreeKind::hybrid);
    EXPECT_EQ(hybrid.mesh().triangles.size(), 12U);
    EXPECT_EQ(hybrid.hybrid_tree().order.size(), 12U);
    EXPECT_THROW(hybrid.bvh8(), std::bad_variant_access);
}

TEST(MeshCollider, AcceptsATreeBuiltEarlier) {
    const MeshCollider built(box());
    const MeshCollider taken(box(), built.bvh8(), built.closed_parts());
    EXPECT_EQ(taken.tree_kind(), TreeKind::bvh8);
    EXPECT_EQ(taken.bvh8().leaves.size(), built.bvh8().leaves.size());
    Bvh8 foreign = built.bvh8();
    foreign.leaves[0].triangle[3] = 12;
    EXPECT_THROW(MeshCollider(box(), foreign, built.closed_parts()), std::invalid_argument);
    TriangleMesh damaged = box();
    damaged.triangles[7][1] = static_cast<std::uint32_t>(damaged.positions.size());
    EXPECT_THROW(MeshCollider(damaged, built.bvh8(), built.closed_parts()), std::invalid_argument);
}

TEST(MeshCollider, HasItsClosedPartsUnlessTheInteriorIsUnknown) {
    for (const TreeKind tree_kind : {TreeKind::bvh8, TreeKind::hybrid}) {
        EXPECT_TRUE(MeshCollider(box(), tree_kind).closed_parts().has(0));
        EXPECT_THROW(MeshCollider(box(), tree_kind, Interior::unknown).closed_parts(),
                     std::bad_optional_access);
    }
}

TEST(MeshCollider, RefusesAMeshWithoutTriangles) {
    EXPECT_THROW(MeshCollider{TriangleMesh{}}, std::invalid_argument);
    TriangleMesh points = box();
    points.triangles.clear();
    EXPECT_THROW(MeshCollider{points}, std::invalid_argument);
}

TEST(MeshCollider, RefusesAnIndexOutOfRange) {
    TriangleMesh mesh = box();
    mesh.triangles[7][1] = static_cast<std::uint32_t>(mesh.positions.size());
    EXPECT_THROW(MeshCollider{mesh}, std::invalid_argument);
}

TEST(MeshCollider, RefusesPositionsThatAreNotFinite) {
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        TriangleMesh mesh = box();
        mesh.positions[5].y() = bad;
        EXPECT_THROW(MeshCollider{mesh}, std::invalid_argument);
    }
}

}  // namespace
}  // namespace campuswalk::collision

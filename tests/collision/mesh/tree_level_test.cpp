#include "collision/mesh/tree_level.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/support/random_scene.h"

namespace campuswalk::collision {
namespace {

using support::Dice;

bool holds(const PosedBox& posed, const Vec3& point) {
    const Vec3 local = posed.X_mesh_box.inverse_apply(point);
    return (local.cwiseAbs().array() <= posed.box.half_extents.array() + 1e-4).all();
}

double largest(const std::vector<PosedBox>& boxes) {
    double size = 0.0;
    for (const PosedBox& posed : boxes) {
        size = std::max(size, posed.box.half_extents.norm());
    }
    return size;
}

TEST(TreeLevel, EveryLevelOfEitherTreeHoldsTheWholeMesh) {
    Dice dice(3);
    for (const TreeKind tree_kind : {TreeKind::bvh8, TreeKind::hybrid}) {
        const MeshCollider mesh(support::random_mesh(dice, 600, 5.0), tree_kind, Interior::unknown);
        for (const int level : {0, 1, 2, 4, 40}) {
            const auto boxes = boxes_at_level(mesh, level);
            for (std::size_t t = 0; t < mesh.mesh().triangles.size(); ++t) {
                const Triangle c = vertices(mesh.mesh(), t);
                ASSERT_TRUE(std::ranges::any_of(boxes,
                                                [&](const PosedBox& posed) {
                                                    return holds(posed, c.a) && holds(posed, c.b) &&
                                                           holds(posed, c.c);
                                                }))
                    << "level " << level << ", triangle " << t;
            }
        }
    }
}

TEST(TreeLevel, LevelsMatchTheCollidersTree) {
    Dice dice(3);
    const TriangleMesh mesh = support::random_mesh(dice, 600, 5.0);
    const MeshCollider bvh8(mesh, TreeKind::bvh8, Interior::unknown);
    const MeshCollider hybrid(mesh, TreeKind::hybrid, Interior::unknown);
    EXPECT_EQ(boxes_at_level(bvh8, 0).size(), 1U);
    EXPECT_EQ(boxes_at_level(bvh8, 1).size(), bvh8.bvh8().nodes[0].count);
    EXPECT_EQ(boxes_at_level(bvh8, 100).size(), bvh8.bvh8().leaves.size());
    EXPECT_EQ(boxes_at_level(hybrid, 0).size(), 1U);
    EXPECT_EQ(boxes_at_level(hybrid, 1).size(), 2U);
    EXPECT_EQ(boxes_at_level(hybrid, 3).size(), 8U);
    EXPECT_EQ(2 * boxes_at_level(hybrid, 100).size(), hybrid.hybrid_tree().nodes.size() + 1);
    for (const MeshCollider* each : {&bvh8, &hybrid}) {
        EXPECT_LT(largest(boxes_at_level(*each, 3)), largest(boxes_at_level(*each, 0)));
    }
}

}  // namespace
}  // namespace campuswalk::collision

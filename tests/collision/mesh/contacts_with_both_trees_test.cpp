#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>

#include "collision/mesh/mesh_contacts.h"
#include "tests/support/effort.h"
#include "tests/support/random_scene.h"

namespace campuswalk::collision {
namespace {

using support::Dice;

TEST(MeshContacts, AreTheSameWithTheHybridTreeAsWithTheBvh8) {
    Dice dice(440);
    std::size_t found = 0;
    for (int i = 0; i < support::repeats(40); ++i) {
        SCOPED_TRACE(i);
        const TriangleMesh a = support::random_mesh(dice, 1 + dice.below(150), 2.0);
        const TriangleMesh b = support::random_mesh(dice, 1 + dice.below(150), 2.0);
        const Pose X = support::random_pose(dice, 2.0);
        std::vector<TrianglePair> bvh8;
        std::vector<TrianglePair> hybrid{{77, 77}};
        all_contacts(MeshCollider(a), MeshCollider(b), X, bvh8);
        const MeshCollider hybrid_a(a, TreeKind::hybrid);
        const MeshCollider hybrid_b(b, TreeKind::hybrid);
        QueryStatistics hybrid_counters;
        all_contacts(hybrid_a, hybrid_b, X, hybrid, &hybrid_counters);
        EXPECT_GT(hybrid_counters.volume_tests, 0U);
        EXPECT_EQ(first_contact(hybrid_a, hybrid_b, X, &hybrid_counters),
                  hybrid.empty() ? std::nullopt : std::optional(hybrid.front()));
        std::sort(bvh8.begin(), bvh8.end());
        std::sort(hybrid.begin(), hybrid.end());
        EXPECT_EQ(bvh8, hybrid);
        found += bvh8.size();
    }
    EXPECT_GT(found, static_cast<std::size_t>(support::repeats(1000)));
}

TEST(MeshContacts, BetweenDifferentKindsOfTreesAreRefused) {
    Dice dice(441);
    const MeshCollider bvh8(support::random_mesh(dice, 5, 1.0));
    const MeshCollider hybrid(bvh8.mesh(), TreeKind::hybrid);
    std::vector<TrianglePair> pairs;
    EXPECT_THROW(all_contacts(bvh8, hybrid, {}, pairs), std::invalid_argument);
    EXPECT_THROW(first_contact(hybrid, bvh8, {}), std::invalid_argument);
}

TEST(MeshContacts, WithHybridTreesRefuseAMirroredPose) {
    Dice dice(442);
    const MeshCollider hybrid(support::random_mesh(dice, 5, 1.0), TreeKind::hybrid);
    Pose mirror;
    mirror.rotation(0, 0) = -1.0;
    EXPECT_THROW(first_contact(hybrid, hybrid, mirror), std::invalid_argument);
}

}  // namespace
}  // namespace campuswalk::collision

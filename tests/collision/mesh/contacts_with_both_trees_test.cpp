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
        std::vector<TrianglePair> wide;
        std::vector<TrianglePair> paper{{77, 77}};
        all_contacts(MeshCollider(a), MeshCollider(b), X, wide);
        const MeshCollider paper_a(a, TreeKind::hybrid);
        const MeshCollider paper_b(b, TreeKind::hybrid);
        QueryStatistics paper_counters;
        all_contacts(paper_a, paper_b, X, paper, &paper_counters);
        EXPECT_GT(paper_counters.volume_tests, 0U);
        EXPECT_EQ(first_contact(paper_a, paper_b, X, &paper_counters),
                  paper.empty() ? std::nullopt : std::optional(paper.front()));
        std::sort(wide.begin(), wide.end());
        std::sort(paper.begin(), paper.end());
        EXPECT_EQ(wide, paper);
        found += wide.size();
    }
    EXPECT_GT(found, static_cast<std::size_t>(support::repeats(1000)));
}

TEST(MeshContacts, BetweenDifferentKindsOfTreesAreRefused) {
    Dice dice(441);
    const MeshCollider wide(support::random_mesh(dice, 5, 1.0));
    const MeshCollider paper(wide.mesh(), TreeKind::hybrid);
    std::vector<TrianglePair> pairs;
    EXPECT_THROW(all_contacts(wide, paper, {}, pairs), std::invalid_argument);
    EXPECT_THROW(first_contact(paper, wide, {}), std::invalid_argument);
}

TEST(MeshContacts, WithHybridTreesRefuseAMirroredPose) {
    Dice dice(442);
    const MeshCollider paper(support::random_mesh(dice, 5, 1.0), TreeKind::hybrid);
    Pose mirror;
    mirror.rotation(0, 0) = -1.0;
    EXPECT_THROW(first_contact(paper, paper, mirror), std::invalid_argument);
}

}  // namespace
}  // namespace campuswalk::collision

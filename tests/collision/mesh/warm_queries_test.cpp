#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "collision/mesh/mesh_contacts.h"
#include "collision/mesh/mesh_query.h"
#include "tests/collision/allocation_count.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/effort.h"
#include "tests/support/mesh_pieces.h"

/// Repeating a query with the same vector allocates nothing.
namespace campuswalk::collision {
namespace {

template <typename Query>
std::size_t allocations_of(const Query& query) {
    const std::size_t before = allocation_count();
    query();
    return allocation_count() - before;
}

template <typename Query>
void expect_no_allocation_when_warm(const Query& query) {
    query();
    EXPECT_EQ(allocations_of(query), 0U);
}

TEST(AllocationCount, SeesAVectorGrow) {
    std::vector<int> numbers;
    EXPECT_EQ(allocations_of([&] { numbers.push_back(1); }), 1U);
    EXPECT_EQ(allocations_of([&] { numbers[0] = 2; }), 0U);
}

/// A sphere of some hundred or thousand triangles with needles and a lattice thrown in: every stage of a
/// query has something to do.
TriangleMesh crowded_mesh(std::uint32_t seed) {
    TriangleMesh mesh = support::ball(support::kSanitized ? 16 : 40);
    support::Dice dice(seed);
    for (const TriangleMesh& other :
         {support::lattice_soup(dice, 200, Vec3(-3, -3, -3)), support::needles(dice, 20)}) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
        for (const auto& t : other.triangles) {
            mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
        }
    }
    return mesh;
}

Pose crossing_pose() {
    Pose X;
    X.rotation = support::turn({1, 2, 3}, 0.7);
    X.translation = Vec3(0.5, 0.4, 0.3);
    return X;
}

class WarmQueries : public ::testing::TestWithParam<TreeKind> {
protected:
    const MeshCollider mesh_{crowded_mesh(1), GetParam()};
    QueryStatistics counters_;
};

TEST_P(WarmQueries, ForNearTrianglesAllocateNothing) {
    std::vector<std::uint32_t> out;
    expect_no_allocation_when_warm([&] {
        triangles_near(mesh_, {{-1, 0, 0}, {1, 0.5, 0}}, 0.3, out, &counters_);
    });
    EXPECT_GT(out.size(), 20U);
    expect_no_allocation_when_warm([&] {
        triangles_near(mesh_, {{1, 0, 0}, {1, 0, 0}}, 0.3, out, &counters_);
    });
    EXPECT_FALSE(out.empty());
    expect_no_allocation_when_warm([&] {
        triangles_in_box(mesh_, Box{{1, 0.5, 0.2}}, crossing_pose(), out, &counters_);
    });
    EXPECT_GT(out.size(), 20U);
    std::vector<std::uint32_t> fresh;
    EXPECT_GT(allocations_of([&] {
                  triangles_in_box(mesh_, Box{{1, 0.5, 0.2}}, crossing_pose(), fresh, &counters_);
              }),
              0U);
}

TEST_P(WarmQueries, ForRayHitsAllocateNothing) {
    const Ray ray{{-4, 0.1, 0.2}, {4, 0.2, -0.1}};
    std::vector<MeshHit> out;
    expect_no_allocation_when_warm([&] { all_on_ray(mesh_, ray, out, &counters_); });
    EXPECT_GT(out.size(), 2U);
    expect_no_allocation_when_warm([&] { EXPECT_TRUE(first_on_ray(mesh_, ray, &counters_)); });
    expect_no_allocation_when_warm([&] { EXPECT_TRUE(any_on_ray(mesh_, ray, &counters_)); });
}

TEST_P(WarmQueries, ForTheClosestPointAllocateNothing) {
    expect_no_allocation_when_warm([&] {
        EXPECT_GT(closest_point(mesh_, {0.1, 0.2, 0.3}, &counters_).distance, 0.0);
    });
}

TEST_P(WarmQueries, ForASweepAllocateNothing) {
    const auto sweep_both = [&] {
        EXPECT_TRUE(sweep(mesh_, {{-8, 0, 0}, {-8, 1, 0}}, 0.3, {8, 0, 0}, &counters_));
        EXPECT_TRUE(sweep(mesh_, {{-8, 0, 0}, {-8, 0, 0}}, 0.3, {8, 0, 0}, &counters_));
    };
    expect_no_allocation_when_warm(sweep_both);
}

/// Nothing is cached per thread: the first query of a new one needs only the vector it is passed.
TEST_P(WarmQueries, OnANewThreadAllocateNothing) {
    std::vector<std::uint32_t> out;
    triangles_near(mesh_, {{-1, 0, 0}, {1, 0.5, 0}}, 0.3, out, &counters_);
    std::size_t taken = 1;
    std::thread([&] {
        taken = allocations_of([&] {
            triangles_near(mesh_, {{-1, 0, 0}, {1, 0.5, 0}}, 0.3, out, &counters_);
        });
    }).join();
    EXPECT_EQ(taken, 0U);
}

INSTANTIATE_TEST_SUITE_P(BothTrees, WarmQueries, ::testing::Values(TreeKind::bvh8, TreeKind::hybrid),
                         [](const auto& each) { return each.param == TreeKind::bvh8 ? "bvh8" : "hybrid"; });

struct ContactKind {
    TreeKind tree_kind = TreeKind::bvh8;
    SimdTarget simd_target = SimdTarget::sse42;
    const char* name = "";
};

class WarmContacts : public ::testing::TestWithParam<ContactKind> {
protected:
    void SetUp() override {
        if (!can_run(GetParam().simd_target)) {
            GTEST_SKIP() << "this machine has no " << GetParam().name;
        }
    }

    const MeshCollider a_{crowded_mesh(2), GetParam().tree_kind};
    const MeshCollider b_{crowded_mesh(3), GetParam().tree_kind};
    QueryStatistics counters_;
};

TEST_P(WarmContacts, OfAllPairsAllocateNothing) {
    std::vector<TrianglePair> out;
    const Pose X = crossing_pose();
    expect_no_allocation_when_warm([&] { all_contacts(a_, b_, X, out, &counters_, GetParam().simd_target); });
    EXPECT_GT(out.size(), 200U);
    std::vector<TrianglePair> fresh;
    EXPECT_GT(allocations_of([&] { all_contacts(a_, b_, X, fresh, &counters_, GetParam().simd_target); }),
              0U);
}

TEST_P(WarmContacts, OfTheFirstPairAllocateNothing) {
    expect_no_allocation_when_warm(
        [&] { EXPECT_TRUE(first_contact(a_, b_, crossing_pose(), &counters_, GetParam().simd_target)); });
}

/// A body that passes through another, twice.
TEST_P(WarmContacts, OfAMovingBodyAllocateNothing) {
    std::vector<TrianglePair> out;
    const auto pass = [&] {
        Pose X = crossing_pose();
        for (int i = 0; i < 4; ++i) {
            X.translation.x() = 0.5 * i - 1.0;
            all_contacts(a_, b_, X, out, &counters_, GetParam().simd_target);
        }
    };
    expect_no_allocation_when_warm(pass);
}

INSTANTIATE_TEST_SUITE_P(EveryKernel, WarmContacts,
                         ::testing::Values(ContactKind{TreeKind::bvh8, SimdTarget::sse42, "sse42"},
                                           ContactKind{TreeKind::bvh8, SimdTarget::avx2, "avx2"},
                                           ContactKind{TreeKind::bvh8, SimdTarget::avx512, "avx512"},
                                           ContactKind{TreeKind::hybrid, SimdTarget::sse42, "hybrid"}),
                         [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace campuswalk::collision

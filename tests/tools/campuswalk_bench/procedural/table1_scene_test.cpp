#include "tools/campuswalk_bench/procedural/table1_scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "collision/mesh/mesh_contacts.h"
#include "tests/support/mesh_volume.h"
#include "tests/support/solid_mesh.h"
#include "tools/campuswalk_bench/procedural/cylinder.h"
#include "tools/campuswalk_bench/procedural/teapot.h"

namespace campuswalk::tools::bench {
namespace {

using collision::SimdTarget;
using collision::TriangleMesh;
using collision::TrianglePair;

/// Directed edges and their counts. On a closed surface, each edge occurs once in each direction.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed_edges(const TriangleMesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const auto& t : mesh.triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            ++edges[{t[i], t[(i + 1) % 3]}];
        }
    }
    return edges;
}

std::size_t open_edges(const TriangleMesh& mesh) {
    const auto edges = directed_edges(mesh);
    return static_cast<std::size_t>(std::count_if(edges.begin(), edges.end(), [&](const auto& edge) {
        return !edges.contains({edge.first.second, edge.first.first});
    }));
}

TEST(Cylinder, IsClosedAndFacesOutward) {
    const TriangleMesh mesh = cylinder();
    EXPECT_EQ(mesh.triangles.size(), 8064U);
    EXPECT_EQ(mesh.positions.size(), 64U * 63U + 2U);
    EXPECT_EQ(open_edges(mesh), 0U);
    for (const auto& [edge, times] : directed_edges(mesh)) {
        ASSERT_EQ(times, 1);
    }
    // A prism of 64 sides: 64 / 2 r^2 sin(2 pi / 64) h.
    EXPECT_NEAR(support::enclosed_volume(mesh), 32.0 * 1.4 * 1.4 * 0.0980171403 * 2.5, 1e-4);
    const support::SolidMesh parts(mesh);
    EXPECT_TRUE(parts.contains({1.39, 0.0, 1.24}));
    EXPECT_FALSE(parts.contains({1.41, 0.0, 0.0}));
    EXPECT_FALSE(parts.contains({0.0, 0.0, 1.26}));
}

TEST(Cylinder, HasTheRequestedSizes) {
    const TriangleMesh mesh = cylinder({2.0, 3.0, 5, 2});
    EXPECT_EQ(mesh.triangles.size(), 2U * 5U * 2U + 2U * 5U);
    EXPECT_EQ(open_edges(mesh), 0U);
    for (const auto& p : mesh.positions) {
        EXPECT_LE(std::abs(p.z()), 1.5F);
        EXPECT_LE(p.head<2>().norm(), 2.0001F);
    }
}

TEST(Teapot, HasTheSizesOfNewellsTeapot) {
    const TriangleMesh mesh = teapot();
    EXPECT_EQ(mesh.triangles.size(), 8680U);
    Eigen::Vector3f low = mesh.positions.front();
    Eigen::Vector3f high = low;
    for (const auto& p : mesh.positions) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    EXPECT_LT((low + high).norm(), 1e-6F) << "centred";
    // From the handle to the tip of the spout, across the body, and from the bottom to the lid's knob.
    EXPECT_NEAR(high.x() - low.x(), 6.43, 0.01);
    EXPECT_NEAR(high.y() - low.y(), 4.0, 0.01);
    EXPECT_NEAR(high.z() - low.z(), 3.15, 0.01);
}

TEST(Teapot, IsWeldedAndHasNoDegenerateTriangles) {
    const TriangleMesh mesh = teapot();
    for (const auto& t : mesh.triangles) {
        ASSERT_TRUE(t[0] != t[1] && t[1] != t[2] && t[2] != t[0]);
    }
    for (const auto& [edge, times] : directed_edges(mesh)) {
        ASSERT_EQ(times, 1) << "all patches face the same way";
    }
    // Open edges: the rims of lid and body, 48 each, and both ends of handle and spout; none between patches.
    EXPECT_EQ(open_edges(mesh), 2U * 48U + 2U * (2U * 11U) + 2U * (2U * 9U));
}

TEST(Teapot, FinenessMultipliesTheQuads) {
    // Four times the quads, and twice the degenerate triangles at the poles.
    const std::size_t quads = std::size_t{2} * (24U * 12U * 12U + 4U * 11U * 13U + 4U * 9U * 10U);
    const std::size_t at_poles = quads - teapot().triangles.size();
    EXPECT_EQ(teapot(2).triangles.size(), 4U * quads - 2U * at_poles);
}

TEST(Table1Scene, HasThePapersCountsOfOverlappingPairs) {
    const Table1Scene scene = table1_scene();
    const collision::MeshCollider cylinder(scene.cylinder);
    const collision::MeshCollider teapot(scene.teapot);
    std::vector<std::size_t> numbers;
    for (const Table1Placement& placement : scene.placements) {
        SCOPED_TRACE(placement.pairs);
        std::vector<TrianglePair> in_order;
        for (const SimdTarget i : {SimdTarget::sse42, SimdTarget::avx2, SimdTarget::avx512}) {
            if (!can_run(i)) {
                continue;
            }
            std::vector<TrianglePair> pairs;
            collision::QueryStatistics counters;
            all_contacts(cylinder, teapot, placement.X_cylinder_teapot, pairs, &counters, i);
            EXPECT_EQ(pairs.size(), placement.pairs);
            if (i == SimdTarget::sse42) {
                numbers.push_back(pairs.size());
                in_order = pairs;
            }
            EXPECT_EQ(pairs, in_order);
        }
    }
    EXPECT_EQ(numbers, (std::vector<std::size_t>{31, 142, 238, 347, 429, 666, 815, 961, 1081, 1295}));
}

}  // namespace
}  // namespace campuswalk::tools::bench

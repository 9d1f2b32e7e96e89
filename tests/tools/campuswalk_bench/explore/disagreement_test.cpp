#include "tools/campuswalk_bench/explore/disagreement.h"

#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "engine/walkspace/explore/explore.h"
#include "tests/support/mesh_pieces.h"

namespace campuswalk::tools::bench {
namespace {

using collision::Triangle;
using collision::Vec3;

/// A floor of 8 m by 8 m, fenced so that the walk space ends 0.3 m before its rim.
engine::WalkSpace fenced_floor() {
    collision::World world(std::make_unique<collision::LinearBroadPhase>());
    collision::TriangleMesh mesh;
    support::add_floor(mesh, 4.0);
    support::add_room(mesh, {-4, 0, -4}, {4, 2, 4}, 0.0);
    support::add_object(world, std::move(mesh));
    engine::ExploreSettings settings;
    settings.starts = {Vec3::Zero()};
    return explore({world, 1, {}}, settings);
}

/// A level rectangle.
void add(std::vector<Triangle>& triangles, const Vec3& low, const Vec3& high) {
    const Vec3 b(high.x(), low.y(), low.z());
    const Vec3 c(high.x(), low.y(), high.z());
    const Vec3 d(low.x(), low.y(), high.z());
    triangles.push_back({low, b, c});
    triangles.push_back({low, c, d});
}

TEST(Disagreement, IsNothingOnTheSameGround) {
    std::vector<Triangle> triangles;
    add(triangles, {-3.5, 0.1, -3.5}, {3.5, 0.1, 3.5});
    const Disagreement found = compare(fenced_floor(), triangles);
    EXPECT_NEAR(found.polygon_area, 49.0, 1e-9);
    EXPECT_EQ(found.only_ours.area, 0.0);
    EXPECT_EQ(found.only_peer.area, 0.0);
    EXPECT_TRUE(found.only_peer.clusters.empty());
}

TEST(Disagreement, IsWhatOnlyOneReaches) {
    std::vector<Triangle> triangles;
    add(triangles, {-3.5, 0, -3.5}, {0, 0, 3.5});
    add(triangles, {10, 0, 0}, {11, 0, 2});
    add(triangles, {-1, 3, -1}, {-0.5, 3, 0});
    const Disagreement found = compare(fenced_floor(), triangles);
    EXPECT_NEAR(found.only_ours.area, 3.5 * 7.0, 0.3 * 8.0);
    ASSERT_EQ(found.only_ours.clusters.size(), 1U);
    EXPECT_GT(found.only_ours.clusters.front().at.x(), 1.0);
    EXPECT_DOUBLE_EQ(found.only_peer.area, 2.0 + 0.5);
    ASSERT_EQ(found.only_peer.clusters.size(), 2U) << "the larger first";
    EXPECT_EQ(found.only_peer.clusters[0].cells, 32U);
    EXPECT_NEAR(found.only_peer.clusters[0].at.x(), 10.5, 0.25);
    EXPECT_EQ(found.only_peer.clusters[1].cells, 8U) << "above our floor, but 3 m";
    EXPECT_DOUBLE_EQ(found.only_peer.clusters[1].at.y(), 3.0);
}

}  // namespace
}  // namespace campuswalk::tools::bench

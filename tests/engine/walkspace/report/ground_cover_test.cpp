#include "engine/walkspace/report/ground_cover.h"

#include <gtest/gtest.h>

#include "tests/engine/walkspace/explore/explored_ground.h"
#include "tests/support/mesh_pieces.h"

namespace campuswalk::engine {
namespace {

using collision::TriangleMesh;
using collision::Vec3;

GroundCover cover_of(const TriangleMesh& mesh) {
    const scene::Campus campus = campus_of(mesh);
    return measure_ground(WorkerWorlds(campus.world, 1, {}));
}

TEST(GroundCover, IsAFloorWithoutItsEdge) {
    TriangleMesh mesh;
    support::add_box(mesh, {0, -0.2, 0}, {5, 0, 4});
    const GroundCover cover = cover_of(mesh);
    EXPECT_GT(cover.area, (5 - 1.3) * (4 - 1.3));
    EXPECT_LT(cover.area, 5 * 4);
    EXPECT_NEAR(cover.height, 0.0, 0.01);
    EXPECT_EQ(cover.share_below, 0.0);
    EXPECT_FALSE(lacks_ground(cover));
}

TEST(GroundCover, IsNotExploredFartherThanNeedBe) {
    TriangleMesh mesh;
    support::add_box(mesh, {-100, -0.2, -100}, {100, 0, 100});
    const GroundCover cover = cover_of(mesh);
    EXPECT_TRUE(cover.is_cut_short);
    EXPECT_GT(cover.area, 200.0);
    EXPECT_LT(cover.area, 1'000.0);
    EXPECT_LT(cover.share, 0.03);
    EXPECT_FALSE(lacks_ground(cover));
}

TEST(GroundCover, TellsHowMuchLooksLikeIt) {
    TriangleMesh mesh;
    support::add_box(mesh, {-100, -0.2, -100}, {100, 0, 100});
    EXPECT_NEAR(cover_of(mesh).seen, 200.0 * 200.0, 0.03 * 200.0 * 200.0);
    TriangleMesh small;
    support::add_box(small, {0, -0.2, 0}, {5, 0, 4});
    EXPECT_EQ(cover_of(small).seen, cover_of(small).area);
}

TEST(GroundCover, IsTheTopOfABlockOfTerrain) {
    TriangleMesh mesh;
    support::add_box(mesh, {-50, -8, -50}, {50, 0, 50});
    EXPECT_FALSE(is_roof(cover_of(mesh)));
    EXPECT_NEAR(cover_of(mesh).height, 0.0, 0.01);
}

TEST(GroundCover, IsTheFloorOfAClosedHall) {
    TriangleMesh mesh;
    support::add_box(mesh, {-15, -0.2, -10}, {15, 0, 10});
    support::add_box(mesh, {-15, 5, -10}, {15, 5.2, 10});
    for (const double side : {-1.0, 1.0}) {
        support::add_box(mesh, {-15, 0, 9.9 * side - 0.1}, {15, 5, 9.9 * side + 0.1});
        support::add_box(mesh, {14.9 * side - 0.1, 0, -10}, {14.9 * side + 0.1, 5, 10});
    }
    EXPECT_NEAR(cover_of(mesh).height, 0.0, 0.01);
    EXPECT_FALSE(lacks_ground(cover_of(mesh)));
}

TEST(GroundCover, IsTheLargestOfSeveralRegions) {
    TriangleMesh mesh;
    support::add_box(mesh, {8, -0.2, 0}, {10, 0, 5});
    support::add_box(mesh, {0, -1.2, 0}, {5, -1, 5});
    EXPECT_NEAR(cover_of(mesh).height, -1.0, 0.01);
}

TEST(GroundCover, CrossesLowStepsOnly) {
    const auto area_with_step = [](double step) {
        TriangleMesh mesh;
        support::add_box(mesh, {0, -1, 0}, {4, 0, 4});
        support::add_box(mesh, {4, -1, 0}, {8, step, 4});
        return cover_of(mesh).area;
    };
    EXPECT_GT(area_with_step(0.25), 1.6 * area_with_step(0.9));
}

/// A grid of closed rooms of 5 m, four by four.
void add_walls(TriangleMesh& mesh) {
    for (int i = 0; i < 5; ++i) {
        support::add_box(mesh, {0, 0, 5.0 * i}, {20.2, 2.8, 5.0 * i + 0.2});
        support::add_box(mesh, {5.0 * i, 0, 0}, {5.0 * i + 0.2, 2.8, 20.2});
    }
}

TEST(GroundCover, IsLackingOnTopsOfWalls) {
    TriangleMesh mesh;
    add_walls(mesh);
    EXPECT_TRUE(lacks_ground(cover_of(mesh)));
    support::add_box(mesh, {-10, -0.1, -10}, {30, 0, 30});
    EXPECT_FALSE(lacks_ground(cover_of(mesh)));
}

TEST(GroundCover, AddsUpRoomsBehindClosedDoors) {
    TriangleMesh mesh;
    add_walls(mesh);
    support::add_box(mesh, {0, -0.1, 0}, {20.2, 0, 20.2});
    const GroundCover cover = cover_of(mesh);
    EXPECT_FALSE(lacks_ground(cover));
    EXPECT_GT(cover.area, 0.25 * 20.2 * 20.2);  // each room has at most 4.8 m by 4.8 m, 5.6 %
    EXPECT_NEAR(cover.height, 0.0, 0.01);
}

/// A floor of so many squares along each of its sides, of `size` metres.
void add_fine_floor(TriangleMesh& mesh, double size, std::uint32_t squares) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const std::uint32_t row = squares + 1;
    for (std::uint32_t i = 0; i < row * row; ++i) {
        const std::uint32_t line = i / row;
        mesh.positions.emplace_back(size * (i % row) / squares, 0.0, size * line / squares);
    }
    for (std::uint32_t i = 0; i + row + 1 < row * row; ++i) {
        if (i % row < squares) {
            const std::uint32_t a = first + i;
            mesh.triangles.push_back({a, a + row, a + 1});
            mesh.triangles.push_back({a + 1, a + row, a + row + 1});
        }
    }
}

TEST(GroundCover, IsOnlyLookedAtAmongVeryManyTriangles) {
    TriangleMesh scan;
    add_fine_floor(scan, 12.0, 400);
    const GroundCover cover = cover_of(scan);  // walking over all of it would take tens of seconds
    EXPECT_TRUE(cover.is_cut_short);
    EXPECT_LT(cover.area, 10.0);
    EXPECT_GT(cover.share, 0.8);
    EXPECT_FALSE(lacks_ground(cover));
}

TEST(GroundCover, KeepsOutOfWhereMostTrianglesAre) {
    TriangleMesh mesh;
    add_fine_floor(mesh, 3.0, 200);  // a carpet in the corner
    support::add_box(mesh, {0, -0.2, 0}, {12, -0.01, 12});
    const GroundCover cover = cover_of(mesh);
    EXPECT_TRUE(cover.is_cut_short);
    EXPECT_GT(cover.area, 30.0);
    EXPECT_NEAR(cover.height, -0.01, 0.02);
}

TEST(GroundCover, IsLackingOnARoof) {
    TriangleMesh mesh;
    support::add_box(mesh, {0, 0, 0}, {10, 20, 10});
    const GroundCover tower = cover_of(mesh);
    EXPECT_GT(tower.share, 0.25);
    // 800 of 900 m2, all but the roof and what faces down: the centroids of the walls' triangles are at 1/3
    // and 2/3.
    EXPECT_NEAR(tower.share_below, 8.0 / 9.0, 1e-6);
    EXPECT_TRUE(is_roof(tower));
    support::add_box(mesh, {-20, -0.1, -20}, {30, 0, 30});
    EXPECT_FALSE(lacks_ground(cover_of(mesh)));
}

TEST(GroundCover, MayBeAboveCellars) {
    TriangleMesh mesh;
    support::add_box(mesh, {-50, -0.2, -50}, {50, 0, 50});
    support::add_box(mesh, {0, -6, 0}, {20, -2, 20});
    EXPECT_FALSE(lacks_ground(cover_of(mesh)));
}

TEST(GroundCover, NeedsHeadroom) {
    TriangleMesh mesh;
    support::add_box(mesh, {0, -0.2, 0}, {5, 0, 5});
    support::add_box(mesh, {0, 1.2, 0}, {5, 1.4, 5});
    EXPECT_NEAR(cover_of(mesh).height, 1.4, 0.01);
}

TEST(GroundCover, IsFastForManyOverlappingLayers) {
    TriangleMesh mesh;
    for (int i = 0; i < 1000; ++i) {  // 12,000 triangles of up to half a square kilometre
        support::add_box(mesh, {0, 3.0 * i, 0}, {1000, 3.0 * i + 0.1, 1000});
    }
    EXPECT_TRUE(cover_of(mesh).is_cut_short);  // looking at every cell would take minutes and gigabytes
}

}  // namespace
}  // namespace campuswalk::engine

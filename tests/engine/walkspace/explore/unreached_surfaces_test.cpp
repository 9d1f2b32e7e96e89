#include "engine/walkspace/explore/unreached_surfaces.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/engine/small_campus.h"
#include "tests/engine/walkspace/explore/explored_ground.h"
#include "tests/support/mesh_pieces.h"

namespace campuswalk::engine {
namespace {

/// Nothing is reached. On three threads as on one.
std::vector<Surface> surfaces_of(const scene::Campus& campus) {
    const WalkSpace nowhere(WalkGrid{0.25});
    const ExploreSettings settings = explore_from({0, 0, 0});
    const auto find = [&](std::size_t workers) {
        const WorkerWorlds worlds(campus.world, workers,
                                  [] { return std::make_unique<collision::LinearBroadPhase>(); });
        return unreached_surfaces(worlds, settings, nowhere, campus.world.bounds()).value();
    };
    std::vector<Surface> alone = find(1);
    const std::vector<Surface> together = find(3);
    EXPECT_EQ(alone.size(), together.size());
    for (std::size_t i = 0; i < alone.size() && i < together.size(); ++i) {
        EXPECT_EQ(alone[i].cell, together[i].cell);
        EXPECT_EQ(alone[i].y, together[i].y);
    }
    return alone;
}

/// How many there are in each cell at this height.
std::map<GridCell, int> count_at(const std::vector<Surface>& surfaces, double y) {
    std::map<GridCell, int> count;
    for (const Surface& surface : surfaces) {
        count[surface.cell] += surface.y == y ? 1 : 0;
    }
    return count;
}

/// From 18 m to the west and south of the origin to as far in the north and east: several squares in which
/// surfaces are looked for meet there.
constexpr int kHalf = 72;  // half the floor's width, cells

TEST(UnreachedSurfaces, AreThereOnceInEachCellOnBothSidesOfTheOrigin) {
    collision::TriangleMesh mesh;
    support::add_box(mesh, {-18, -0.5, -18}, {18, 0, 18});
    const std::vector<Surface> surfaces = surfaces_of(campus_of(std::move(mesh)));
    auto count = count_at(surfaces, 0.0);
    for (int z = -kHalf; z < kHalf; ++z) {
        for (int x = -kHalf; x < kHalf; ++x) {
            EXPECT_EQ((count[{x, z}]), 1) << x << " " << z;
        }
    }
    EXPECT_EQ(count.size(), 4U * kHalf * kHalf);
    EXPECT_EQ(surfaces.size(), count.size()) << "its underside is covered";
}

TEST(UnreachedSurfaces, LeavesOutWhatIsCoveredInEverySquare) {
    // A low roof, and the floor goes on around it.
    constexpr int kRoof = 64;  // half its width, cells
    collision::TriangleMesh mesh;
    support::add_floor(mesh, 18.0);
    support::add_box(mesh, {-16, 0.8, -16}, {16, 0.9, 16});
    auto floor = count_at(surfaces_of(campus_of(std::move(mesh))), 0.0);
    for (int z = -kHalf; z < kHalf; ++z) {
        for (int x = -kHalf; x < kHalf; ++x) {
            const int inwards = kRoof - std::max(std::abs(2 * x + 1), std::abs(2 * z + 1)) / 2;
            if (inwards > 1 || inwards < 0) {
                EXPECT_EQ((floor[{x, z}]), inwards < 0 ? 1 : 0) << x << " " << z;
            }
        }
    }
}

TEST(UnreachedSurfaces, AreNoneForAnyNumberOfWorkersIfThereAreTooMany) {
    constexpr std::size_t kCells = 4U * kHalf * kHalf;
    collision::TriangleMesh mesh;
    support::add_box(mesh, {-18, -0.5, -18}, {18, 0, 18});
    const scene::Campus campus = campus_of(std::move(mesh));
    const WalkSpace nowhere(WalkGrid{0.25});
    for (const std::size_t workers : {1U, 3U}) {
        const WorkerWorlds worlds(campus.world, workers,
                                  [] { return std::make_unique<collision::LinearBroadPhase>(); });
        const auto find = [&](std::size_t most) {
            return unreached_surfaces(worlds, explore_from({0, 0, 0}), nowhere, campus.world.bounds(), most);
        };
        EXPECT_FALSE(find(kCells - 1)) << workers;
        ASSERT_TRUE(find(kCells)) << workers;
        EXPECT_EQ(find(kCells)->size(), kCells) << workers;
    }
}

/// Above or below the middle of which cells the triangle lies: each of those around it is tried.
std::map<GridCell, int> cells_over(const collision::Triangle& triangle, const WalkGrid& grid) {
    const std::array<collision::Vec3, 3> t{triangle.a, triangle.b, triangle.c};
    const collision::Vec3 low = t[0].cwiseMin(t[1]).cwiseMin(t[2]);
    const collision::Vec3 high = t[0].cwiseMax(t[1]).cwiseMax(t[2]);
    const GridCell first = grid.cell_at(low);
    const GridCell last = grid.cell_at(high);
    std::map<GridCell, int> cells;
    for (int z = first.z; z <= last.z; ++z) {
        for (int x = first.x; x <= last.x; ++x) {
            const collision::Vec3 p = grid.center({x, z});
            int left = 0;
            int right = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                const collision::Vec3 along = t[(i + 1) % 3] - t[i];
                const double side = along.x() * (p.z() - t[i].z()) - along.z() * (p.x() - t[i].x());
                left += side > 0.0 ? 1 : 0;
                right += side < 0.0 ? 1 : 0;
            }
            if (left == 3 || right == 3) {
                cells[{x, z}] = 1;
            }
        }
    }
    return cells;
}

TEST(UnreachedSurfaces, OfLongTrianglesThatLieAskewMissNone) {
    std::mt19937 random(52);
    std::uniform_real_distribution<float> at(-30.0F, 30.0F);
    std::uniform_real_distribution<float> beside(-1.5F, 1.5F);
    for (int trial = 0; trial < 40; ++trial) {
        const Eigen::Vector3f a(at(random), 0.0F, at(random));
        const Eigen::Vector3f b(at(random), 0.0F, at(random));
        const Eigen::Vector3f c = 0.5F * (a + b) + Eigen::Vector3f(beside(random), 0.0F, beside(random));
        collision::TriangleMesh mesh;
        mesh.positions = {a, b, c};
        mesh.triangles = {{0, 1, 2}};
        const auto cells = cells_over(collision::vertices(mesh, 0), WalkGrid{0.25});
        EXPECT_EQ(count_at(surfaces_of(campus_of(std::move(mesh))), 0.0), cells) << "trial " << trial;
    }
}

TEST(UnreachedSurfaces, KeepsWhatTheBodyHasRoomAbove) {
    // It is 1.8 m high and 0.6 m wide: over an edge, its foot hangs lower.
    for (const double roof : {1.1, 1.3}) {
        collision::TriangleMesh mesh;
        support::add_floor(mesh, 4.0);
        support::add_box(mesh, {-4, roof, -4}, {4, roof + 0.1, 4});
        auto floor = count_at(surfaces_of(campus_of(std::move(mesh))), 0.0);
        EXPECT_EQ((floor[{0, 0}]), roof > 1.2 ? 1 : 0) << roof;
    }
}

}  // namespace
}  // namespace campuswalk::engine

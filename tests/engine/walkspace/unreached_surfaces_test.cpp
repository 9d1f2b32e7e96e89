#include "engine/walkspace/unreached_surfaces.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <memory>

#include <gtest/gtest.h>

#include "tests/engine/small_campus.h"
#include "tests/engine/walkspace/explored_ground.h"
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
        return unreached_surfaces(worlds, settings, nowhere, campus.world.bounds());
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

// What is reached, on ground whose reachable part is known.

#include "engine/walkspace/explore/explore.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "tests/engine/small_campus.h"
#include "tests/engine/walkspace/explore/explored_ground.h"
#include "tests/support/angles.h"
#include "tests/support/course/walls.h"
#include "tests/support/mesh_pieces.h"

namespace campuswalk::engine {
namespace {

using collision::TriangleMesh;
using collision::Vec3;
using testing::Contains;
using testing::IsEmpty;
using testing::Not;

/// A body stands on a rim with its middle almost its radius of 0.3 m outside, on its side: in the second
/// cell.
constexpr int kCellsBeyondARim = 2;

template <typename Add>
scene::Campus floor_with(double half_size, const Add& add) {
    TriangleMesh mesh;
    support::add_floor(mesh, half_size);
    add(mesh);
    return campus_of(std::move(mesh));
}

TEST(Explore, ReachesAnEmptyFloorUpToItsRim) {
    TriangleMesh mesh;
    support::add_quad(mesh, {-5, 0, 3}, {5, 0, 3}, {5, 0, -3}, {-5, 0, -3});
    const scene::Campus campus = campus_of(std::move(mesh));
    const WalkSpace space = explored(campus, {0, 0, 0});
    std::map<GridCell, int> nodes;
    for (const WalkNodeId& node : nodes_of(space)) {
        const GridCell cell = space.cell_of(node);
        ++nodes[cell];
        EXPECT_TRUE(cell.x >= -20 - kCellsBeyondARim && cell.x < 20 + kCellsBeyondARim);
        EXPECT_TRUE(cell.z >= -12 - kCellsBeyondARim && cell.z < 12 + kCellsBeyondARim);
    }
    for (int x = -20; x < 20; ++x) {
        for (int z = -12; z < 12; ++z) {
            EXPECT_EQ((nodes[{x, z}]), 1) << "cell " << x << ", " << z;
        }
    }
    EXPECT_GE(space.area(), 10.0 * 6.0);
    EXPECT_LE(space.area(), 11.0 * 7.0);
    EXPECT_LE(space.area(), 0.0625 * static_cast<double>(space.node_count()));  // some hang over the rim
}

TEST(Explore, ReachesPlacesByShortChains) {
    const scene::Campus campus = level_campus(18.0);
    const WalkSpace space = explored(campus, {0, 0, 0});
    Strider strider(campus.world, strides_of(), {});
    std::size_t far = 0;
    for (const WalkNodeId& node : some_nodes(space, 500)) {
        const Vec3 at = space.position(node).cwiseAbs();
        const double straight = std::abs(at.x() - at.z());  // the rest is diagonal
        const double shortest = straight + std::sqrt(2.0) * std::min(at.x(), at.z());
        if (shortest > 3.0) {
            ++far;
            EXPECT_LE(length_of(space.chain(node, strider)), 1.03 * shortest) << at.transpose();
        }
    }
    EXPECT_GT(far, 400U);
}

TEST(Explore, ReachesNothingBehindAWall) {
    const scene::Campus campus = floor_with(5.0, [](TriangleMesh& mesh) {
        support::add_box(mesh, {1, 0, -6}, {1.2, 3, 6});
    });
    const WalkSpace space = explored(campus, {-2, 0, 0});
    for (const WalkNodeId& node : nodes_of(space)) {
        EXPECT_LE(space.position(node).x(), 1.0 - 0.3 + space.grid.cell);
    }
    EXPECT_TRUE(reaches(space, {0.6, 0, 0}));
    EXPECT_GE(space.area(), (5.0 + 0.5) * 10.0);
    EXPECT_TRUE(space.touched.front());
}

TEST(Explore, FallsFromALedgeButDoesNotGetBack) {
    const scene::Campus campus = floor_with(5.0, [](TriangleMesh& mesh) {
        support::add_box(mesh, {-2, 0, -2}, {2, 1, 2});
    });
    const WalkSpace from_above = explored(campus, {0, 1, 0});
    EXPECT_TRUE(reaches(from_above, {4, 0, 4}));
    std::size_t falls = 0;
    for (const WalkNodeId& node : nodes_of(from_above)) {
        const auto parent = from_above.parent(node);
        if (parent && from_above.position(*parent).y() - from_above.position(node).y() > 0.5) {
            ++falls;
            EXPECT_EQ(from_above.node(node).returns, 0U);
        }
    }
    EXPECT_GT(falls, 0U);
    const WalkSpace from_below = explored(campus, {4, 0, 4});
    EXPECT_FALSE(reaches(from_below, {0, 1, 0}));
    EXPECT_EQ(from_below.position(from_below.starts.front()).y(),
              from_below.node(from_below.starts.front()).y);
}

TEST(Explore, LandsOnWhatIsSetBackBelowAnEdge) {
    // A balcony under a deck, over nothing: out, and then back.
    TriangleMesh mesh;
    support::add_box(mesh, {-4, 5.8, -2}, {0, 6, 2});
    support::add_box(mesh, {-4, 0, -2}, {0, 0.2, 2});
    support::add_box(mesh, {-4, -9, -2}, {-3, 5.8, 2});
    const WalkSpace space = explored(campus_of(std::move(mesh)), {-2, 6, 0});
    EXPECT_TRUE(reaches(space, {-1, 0.2, 0}));
    EXPECT_THAT(space.bounds, Contains(Bound::steering)) << "not every way to steer was tried";
}

TEST(Explore, SteersNoFallTowardsGroundWithoutRoomAboveIt) {
    // What faces up, or down, below the platform's rim is its own underside.
    TriangleMesh mesh;
    support::add_box(mesh, {-4, -0.5, -4}, {4, 0, 4});
    const scene::Campus platform = campus_of(std::move(mesh));
    ExploreSettings settings = explore_from({0, 0, 0});
    const WalkSpace steered = explored(platform.world, settings);
    settings.steer_falls = false;
    const WalkSpace straight = explored(platform.world, settings);
    EXPECT_FALSE(straight.tiles.empty());
    EXPECT_EQ(steered.strides, straight.strides);
    EXPECT_EQ(steered.ticks, straight.ticks);
}

TEST(Explore, LandsOnALedgeThatSticksOutFromUnderAnEdge) {
    // A podium on a slab that is 0.18 m wider to the east, over nothing: no cell has its middle on the ledge.
    TriangleMesh mesh;
    support::add_box(mesh, {-4, 0, -4}, {-0.1, 1, 4});
    support::add_box(mesh, {-4, -0.2, -4}, {0.08, 0, 4});
    const WalkSpace space = explored(campus_of(std::move(mesh)), {-2, 1, 0});
    const auto nodes = nodes_of(space);
    EXPECT_TRUE(std::ranges::any_of(nodes, [&](const WalkNodeId& node) {
        return space.position(node).y() < 0.1 && space.position(node).x() > -0.2;
    }));
}

TEST(Explore, KnowsThatLevelGroundIsWalkedBackToo) {
    const WalkSpace space = explored(level_campus(3.0), {0, 0, 0});
    for (const WalkNodeId& node : nodes_of(space)) {
        EXPECT_EQ(space.node(node).returns, 1U);
    }
}

/// Whether the top of a box of this height on the floor is reached from the floor.
bool climbs(double riser) {
    const scene::Campus campus = floor_with(4.0, [&](TriangleMesh& mesh) {
        support::add_box(mesh, {-1, 0, -1}, {1, riser, 1});
    });
    return reaches(explored(campus, {3, 0, 3}), {0, riser, 0});
}

TEST(Explore, ClimbsRisersUpToTheStepHeight) {
    EXPECT_TRUE(climbs(0.29));
    EXPECT_FALSE(climbs(0.31));
}

/// Whether a deck is reached over a ramp of so many degrees.
bool walks_up(double degrees) {
    const double run = 2.0 / std::tan(support::radians(degrees));
    const scene::Campus campus = floor_with(6.0, [&](TriangleMesh& mesh) {
        support::add_quad(mesh, {0, 0, 2}, {run, 2, 2}, {run, 2, -2}, {0, 0, -2});
        support::add_box(mesh, {run, 0, -2}, {run + 2, 2, 2});
    });
    return reaches(explored(campus, {-3, 0, 0}), {run + 1, 2, 0});
}

TEST(Explore, WalksUpSlopesOfFiftyDegrees) {
    EXPECT_TRUE(walks_up(49.0));
    EXPECT_FALSE(walks_up(51.0));
}

/// In a pit of 20 m by 20 m, whose floor slopes and whose edges no stride leads over, askew to the cells.
WalkSpace explored_pit(double slope_deg) {
    const double rise = 20.0 * std::tan(support::radians(slope_deg));
    TriangleMesh mesh;
    support::add_quad(mesh, {-10, 0, 10}, {10, rise, 10}, {10, rise, -10}, {-10, 0, -10});
    support::add_box(mesh, {-11, -1, -10}, {-10, 30, 10});
    support::add_box(mesh, {10, -1, -10}, {11, 30, 10});
    support::add_box(mesh, {-11, -1, -11}, {11, 30, -10});
    support::add_box(mesh, {-11, -1, 10}, {11, 30, 11});
    const Eigen::AngleAxisf askew(0.4F, Eigen::Vector3f::UnitY());
    for (Eigen::Vector3f& p : mesh.positions) {
        p = askew * p;
    }
    return explored(campus_of(std::move(mesh)), {0, 0.5 * rise + 0.3, 0});
}

TEST(Explore, TakesFewStridesToGroundThatItKnows) {
    struct Pit {
        double slope_deg;
        double strides;  ///< a node, at most
        double ticks;    ///< likewise: a stride straight to the next cell takes 11
    };
    // Without looking ahead up and down slopes: 2.7 and 4.7 strides. Sliding along the walls to the end of
    // each stride: 13.8 ticks on the level.
    for (const Pit& pit : {Pit{0.0, 1.2, 13.5}, Pit{25.0, 1.4, 16.2}, Pit{42.0, 1.8, 21.5}}) {
        const WalkSpace space = explored_pit(pit.slope_deg);
        const auto nodes = static_cast<double>(space.node_count());
        EXPECT_GE(space.area(), 19.4 * 19.4) << pit.slope_deg;
        EXPECT_LE(static_cast<double>(space.strides), pit.strides * nodes) << pit.slope_deg;
        EXPECT_LE(static_cast<double>(space.ticks), pit.ticks * nodes) << pit.slope_deg;
    }
}

/// Whether a passage with a ceiling at this height is walked through.
bool fits_under(double ceiling) {
    // In a room: on the rim of a floor, a body hangs lower.
    const scene::Campus campus = floor_with(4.0, [&](TriangleMesh& mesh) {
        support::add_room(mesh, {-4, 0, -4}, {4, 2, 4}, 0.0);
        support::add_box(mesh, {-1, ceiling, -4}, {1, ceiling + 1.0, 4});
    });
    return reaches(explored(campus, {-3, 0, 0}), {3, 0, 0});
}

TEST(Explore, NeedsHeadroom) {
    EXPECT_TRUE(fits_under(1.81));
    EXPECT_FALSE(fits_under(1.79));
}

TEST(Explore, RecordsFallsOutOfTheWorld) {
    const scene::Campus campus = level_campus(3.0);
    const WalkSpace space = explored(campus, {0, 0, 0});
    bool rims[4] = {};
    for (const WalkTile& tile : space.tiles) {
        for (const WalkTile::Drop& drop : tile.drops) {
            EXPECT_NEAR(std::max(std::abs(drop.edge.x()), std::abs(drop.edge.z())), 3.0, 0.301);
            EXPECT_EQ(std::ranges::count_if(tile.drops,
                                            [&](const WalkTile::Drop& other) {
                                                return space.grid.cell_at(other.edge) ==
                                                       space.grid.cell_at(drop.edge);
                                            }),
                      1)
                << "one for each cell of the rim";
            rims[0] = rims[0] || drop.edge.x() > 2.7;
            rims[1] = rims[1] || drop.edge.x() < -2.7;
            rims[2] = rims[2] || drop.edge.z() > 2.7;
            rims[3] = rims[3] || drop.edge.z() < -2.7;
        }
    }
    for (const bool rim : rims) {
        EXPECT_TRUE(rim);
    }
    const scene::Campus fenced = floor_with(3.0, [](TriangleMesh& mesh) {
        support::add_room(mesh, {-3, 0, -3}, {3, 2, 3}, 0.0);
    });
    for (const WalkTile& tile : explored(fenced, {0, 0, 0}).tiles) {
        EXPECT_TRUE(tile.drops.empty());
    }
}

TEST(Explore, SaysWhatCutItShort) {
    const scene::Campus floor = level_campus(20.0);
    ExploreSettings settings = explore_from({0, 0, 0});
    settings.max_nodes = 100;
    const WalkSpace cut = explored(floor.world, settings);
    EXPECT_THAT(cut.bounds, Contains(Bound::nodes));
    EXPECT_LT(cut.area(), 1000.0);

    const scene::Campus fenced = floor_with(3.0, [](TriangleMesh& mesh) {
        support::add_room(mesh, {-3, 0, -3}, {3, 2, 3}, 0.0);
    });
    EXPECT_THAT(explored(fenced, {0, 0, 0}).bounds, IsEmpty());

    const scene::Campus tower = floor_with(5.0, [](TriangleMesh& mesh) {
        support::add_room(mesh, {-5, 0, -5}, {5, 2, 5}, 0.0);
        support::add_box(mesh, {-1, 0, -1}, {1, 4, 1});
    });
    EXPECT_THAT(explored(tower, {0, 4, 0}).bounds, Contains(Bound::steering));
}

TEST(Explore, EndsAtItsGoal) {
    const scene::Campus campus = level_campus(40.0);
    const ExploreSettings settings = explore_from({0, 0, 0});
    const GridCell goal = WalkGrid{}.cell_at({5, 0, 5});
    const UntilCell until{[&](const GridCell& cell, double) { return cell == goal; }};
    const WalkSpace space = explore(WorkerWorlds(campus.world, 1, {}), settings, until);
    ASSERT_TRUE(space.goal);
    EXPECT_EQ(space.cell_of(*space.goal), goal);
    EXPECT_FALSE(reaches(space, {39, 0, 39}));
}

TEST(Explore, LeavesOutStartsWithoutRoomOrGround) {
    const scene::Campus campus = level_campus(3.0);
    ExploreSettings settings = explore_from({0, 0, 0});
    settings.starts = {{50, 0, 0}, {1, 0, 1}, {2, 0, -2}};
    const WalkSpace space = explored(campus.world, settings);
    EXPECT_THAT(space.start_of, testing::ElementsAre(1U, 2U));
    EXPECT_EQ(space.cell_of(space.starts.front()), space.grid.cell_at({1, 0, 1}));
    EXPECT_FALSE(space.parent(space.starts.back()));
}

TEST(Explore, RunsAndJumpsWhereItMay) {
    // Decks of 1.5 m, 1.2 m apart: too far to walk over, near enough to jump.
    const scene::Campus campus = floor_with(6.0, [](TriangleMesh& mesh) {
        support::add_box(mesh, {-4, 0, -1}, {-0.6, 1.5, 1});
        support::add_box(mesh, {0.6, 0, -1}, {4, 1.5, 1});
    });
    ExploreSettings settings = explore_from({-2, 1.5, 0});
    EXPECT_FALSE(reaches(explored(campus.world, settings), {3, 1.5, 0}));
    settings.jump = true;
    EXPECT_TRUE(reaches(explored(campus.world, settings), {3, 1.5, 0}));
}

TEST(Explore, JumpsFromAsFarAsItTakes) {
    // A slope of 15 degrees down to a block of 0.93 m. A body that jumps 0.4 m gets a hold on edges up to its
    // radius of 0.3 m above its foot: beside the block that is too low, but 1.1 m before it the ground is 0.3
    // m higher.
    const double rise = 4.0 * 0.268;
    const scene::Campus campus = floor_with(6.0, [&](TriangleMesh& mesh) {
        support::add_box(mesh, {0, 0, -0.5}, {2, 0.93, 0.5});
        support::add_quad(mesh, {-4, rise, 4}, {0, 0, 4}, {0, 0, -4}, {-4, rise, -4});
    });
    ExploreSettings settings = explore_from({-3, 1, 0});
    EXPECT_FALSE(reaches(explored(campus.world, settings), {1, 0.93, 0}));
    settings.jump = true;
    EXPECT_TRUE(reaches(explored(campus.world, settings), {1, 0.93, 0}));
}

TEST(Explore, JumpsOntoWhatItWalksUnder) {
    AvatarProfile robot;
    robot.height = 0.42;
    robot.radius = 0.2;
    robot.step_height = 0.2;
    for (const double x : {0.5, 3.6}) {  // in a tile, and across a border
        const scene::Campus campus = floor_with(6.0, [&](TriangleMesh& mesh) {
            support::add_box(mesh, {x, 0.53, 1.6}, {x + 0.8, 0.56, 2.4});
        });
        ExploreSettings settings = explore_from({-2, 0, 0}, robot);
        EXPECT_FALSE(reaches(explored(campus.world, settings), {x + 0.4, 0.56, 2}));
        settings.jump = true;
        EXPECT_TRUE(reaches(explored(campus.world, settings), {x + 0.4, 0.56, 2})) << x;
    }
}

TEST(Explore, IgnoresDisabledObjects) {
    scene::Campus campus = level_campus(4.0);
    add_box(campus, "gate", {1, 0, -5}, {1.2, 3, 5});
    std::vector<bool> disabled = {false, true};
    ExploreSettings settings = explore_from({-2, 0, 0});
    EXPECT_FALSE(reaches(explored(campus.world, settings), {3, 0, 0}));
    settings.solids.disabled = &disabled;
    EXPECT_TRUE(reaches(explored(campus.world, settings), {3, 0, 0}));
}

}  // namespace
}  // namespace campuswalk::engine

// Storeys, unreached ground, traps and holes: what a report on a walk space is made of.

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "collision/mesh/mesh_collider.h"
#include "engine/walkspace/barrier/island_barriers.h"
#include "engine/walkspace/explore/campus_settings.h"
#include "engine/walkspace/explore/unreached_ground.h"
#include "engine/walkspace/passage/hot_spots.h"
#include "engine/walkspace/passage/traps.h"
#include "engine/walkspace/passage/trigger_overhangs.h"
#include "engine/walkspace/report/walk_report.h"
#include "engine/walkspace/space/holes.h"
#include "engine/walkspace/space/storeys.h"
#include "tests/engine/small_campus.h"
#include "tests/support/mesh_pieces.h"

namespace campuswalk::engine {
namespace {

using collision::Vec3;

/// With stairs of 0.25 m along the west wall up to a gallery at 3 m, under which one walks.
scene::Campus yard_with_gallery() {
    scene::Campus campus = walled_yard();
    for (int i = 1; i <= 12; ++i) {
        add_box(campus, "tread-" + std::to_string(i), {-6, -0.1, 5.5 - 0.5 * i},
                {-4.5, 0.25 * i, 6.0 - 0.5 * i});
    }
    add_box(campus, "gallery", {-6, 2.8, -6}, {2, 3, -0.5});
    return campus;
}

class Findings : public testing::Test {
protected:
    /// Explores from the middle.
    const WalkSpace& explored(const scene::Campus& campus, bool jump = false) {
        worlds_.emplace(campus.world, 1, WorkerWorlds::MakeBroadPhase());
        settings_ = explore_settings(campus, AvatarProfile(), 60);
        settings_.starts = {{0, 0, 0}};
        settings_.keep_rim = true;
        settings_.jump = jump;
        space_.emplace(explore(*worlds_, settings_));
        return *space_;
    }
    std::vector<Island> islands(double least = kNotableIsland) {
        return find_unreached_ground(*worlds_, settings_, *space_, least).value();
    }

    std::optional<WorkerWorlds> worlds_;
    ExploreSettings settings_;
    std::optional<WalkSpace> space_;
};

TEST_F(Findings, AFloorAboveAnotherIsAStoreyOfItsOwn) {
    const scene::Campus campus = yard_with_gallery();
    const WalkSpace& space = explored(campus);
    const Storeys storeys = find_storeys(space);
    ASSERT_EQ(storeys.list.size(), 2U);
    EXPECT_NEAR(storeys.list[0].main_height, 0.0, 0.05);
    EXPECT_NEAR(storeys.list[1].main_height, 3.0, 0.05);
    // The body's middle keeps off the walls by its radius, and hangs over the edges, where cells have several
    // nodes.
    EXPECT_GT(storeys.list[1].area, (8 - 0.3) * (5.5 - 0.3));
    EXPECT_LT(storeys.list[1].area, 1.5 * 8.0 * 5.5);
    const auto above = space.find(space.grid.cell_at(0.0, -3.0), 3.0);
    const auto below = space.find(space.grid.cell_at(0.0, -3.0), 0.0);
    ASSERT_TRUE(above && below);
    EXPECT_EQ(storeys.of(*above), 1U);
    EXPECT_EQ(storeys.of(*below), 0U);
}

TEST_F(Findings, UnreachedGroundIsAnIslandOfItsSize) {
    scene::Campus campus = walled_yard();
    add_box(campus, "stage", {1, -0.1, 1}, {5, 0.5, 4});
    explored(campus);
    std::vector<Island> found = islands();
    std::erase_if(found,
                  [](const Island& island) { return island.bounds.min.y() > 3.0; });  // the walls' tops
    std::erase_if(found,
                  [](const Island& i) { return i.bounds.max.cwiseAbs().maxCoeff() > 6.0; });  // outside
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].area(space_->grid), 4.0 * 3.0, 1.0);
    EXPECT_NEAR(found[0].bounds.max.y(), 0.5, 1e-3);
    const auto barrier = find_island_barriers(*worlds_, settings_, *space_, found, 1)[0];
    ASSERT_TRUE(barrier);
    EXPECT_EQ(barrier->kind, ReasonKind::riser);
    EXPECT_NEAR(barrier->measured, 0.5, 0.002);
    EXPECT_EQ(campus.objects[index_of(barrier->object.value())].id, "stage");
}

/// Walls and a roof of single faces about the point, 4 m x 4 m x 3 m, without a floor. The wall in the north
/// has a window of so many metres at the height of the eyes.
std::shared_ptr<const collision::MeshCollider> shell(double window) {
    collision::TriangleMesh mesh;
    support::add_quad(mesh, {-2, 0, 2}, {2, 0, 2}, {2, 3, 2}, {-2, 3, 2});
    support::add_quad(mesh, {-2, 0, -2}, {-2, 0, 2}, {-2, 3, 2}, {-2, 3, -2});
    support::add_quad(mesh, {2, 0, 2}, {2, 0, -2}, {2, 3, -2}, {2, 3, 2});
    support::add_quad(mesh, {-2, 3, 2}, {2, 3, 2}, {2, 3, -2}, {-2, 3, -2});
    support::add_quad(mesh, {2, 0, -2}, {window, 0, -2}, {window, 3, -2}, {2, 3, -2});
    support::add_quad(mesh, {window, 0, -2}, {-2, 0, -2}, {-2, 1.5, -2}, {window, 1.5, -2});
    support::add_quad(mesh, {window, 1.5 + window, -2}, {-2, 1.5 + window, -2}, {-2, 3, -2}, {window, 3, -2});
    support::add_quad(mesh, {0, 1.5, -2}, {-2, 1.5, -2}, {-2, 1.5 + window, -2}, {0, 1.5 + window, -2});
    return std::make_shared<const collision::MeshCollider>(std::move(mesh));
}

/// What is inside of the shell, by a report on a yard with it in the middle.
IslandReport inside_shell(scene::Campus& campus, const Vec3& start = {4.5, 0, 4.5}) {
    const WorkerWorlds worlds(campus.world, 1, {});
    ExploreSettings settings = explore_settings(campus, AvatarProfile(), 60);
    settings.starts = {start};
    for (IslandReport& entry : report_walks(campus, AvatarProfile(), worlds, settings).islands) {
        if (entry.island.bounds.max.cwiseAbs().maxCoeff() < 2.0) {
            return std::move(entry);
        }
    }
    ADD_FAILURE() << "no island";
    return {};
}

/// Nobody stands on treads that are no deeper than the body's radius, so the stairs aren't part of the
/// island, and begin farther away from it than its edge is from the ground below.
TEST_F(Findings, TheRiserOfStairsWithNarrowTreadsIsNamed) {
    scene::Campus campus = walled_yard();
    for (int i = 1; i <= 10; ++i) {
        add_box(campus, "tread-" + std::to_string(i), {1, 0, 5.0 - 0.3 * i}, {3, 0.17 * i, 5.3 - 0.3 * i});
    }
    add_box(campus, "gallery", {0, 1.5, -4}, {4, 1.7, 2});
    explored(campus);
    settings_.strides.body.step_height = 0.1;
    space_.emplace(explore(*worlds_, settings_));
    std::vector<Island> found = islands();
    std::erase_if(found, [](const Island& island) {
        return std::abs(island.nearest_to({2, 1.7, -1}).y() - 1.7) > 0.01 || island.bounds.max.x() > 5.0;
    });
    ASSERT_EQ(found.size(), 1U);
    const auto barrier = [&](const std::vector<bool>& with_stairs) {
        return find_island_barriers(*worlds_, settings_, *space_, found, 1, nullptr, with_stairs)[0];
    };
    ASSERT_TRUE(barrier({}) && barrier({true}));
    EXPECT_EQ(barrier({})->kind, ReasonKind::ledge) << "the test is about stairs that begin farther away";
    EXPECT_EQ(barrier({true})->kind, ReasonKind::riser);
    EXPECT_NEAR(barrier({true})->measured, 0.17, 0.002);
}

TEST_F(Findings, WhatAShellEnclosesIsAHollow) {
    scene::Campus closed = walled_yard();
    add_object(closed, "shell", shell(0.0), {0, 0, 0});
    EXPECT_TRUE(inside_shell(closed).hollow);

    scene::Campus with_window = walled_yard();
    add_object(with_window, "shell", shell(0.6), {0, 0, 0});
    EXPECT_FALSE(inside_shell(with_window).hollow);
}

/// Higher than the air of a column is filled at once.
TEST_F(Findings, ATowerIsAHollowUnlessItHasNoRoof) {
    collision::TriangleMesh walls;
    support::add_quad(walls, {-2, 0, 2}, {2, 0, 2}, {2, 25, 2}, {-2, 25, 2});
    support::add_quad(walls, {-2, 0, -2}, {-2, 0, 2}, {-2, 25, 2}, {-2, 25, -2});
    support::add_quad(walls, {2, 0, 2}, {2, 0, -2}, {2, 25, -2}, {2, 25, 2});
    support::add_quad(walls, {2, 0, -2}, {-2, 0, -2}, {-2, 25, -2}, {2, 25, -2});
    scene::Campus open = walled_yard();
    add_object(open, "tower", std::make_shared<const collision::MeshCollider>(walls), {0, 0, 0});
    add_box(open, "sky", {-8, 30, -8}, {8, 30.2, 8});
    EXPECT_FALSE(inside_shell(open).hollow) << "its air leads over the walls down to the yard";
    scene::Campus closed = walled_yard();
    support::add_quad(walls, {-2, 25, 2}, {2, 25, 2}, {2, 25, -2}, {-2, 25, -2});
    add_object(closed, "tower", std::make_shared<const collision::MeshCollider>(walls), {0, 0, 0});
    add_box(closed, "sky", {-8, 30, -8}, {8, 30.2, 8});
    EXPECT_TRUE(inside_shell(closed).hollow);
}

TEST_F(Findings, ARoomBehindAClosedDoorIsNoHollow) {
    scene::Campus campus = walled_yard();
    add_box(campus, "west", {-2.2, 0, -2}, {-2, 3, 2.2});
    add_box(campus, "east", {2, 0, -2}, {2.2, 3, 2.2});
    add_box(campus, "north", {-2.2, 0, -2.2}, {2.2, 3, -2});
    add_box(campus, "south/left", {-2, 0, 2}, {-0.5, 3, 2.2});
    add_box(campus, "south/right", {0.5, 0, 2}, {2, 3, 2.2});
    add_box(campus, "roof", {-2.2, 2.9, -2.2}, {2.2, 3.1, 2.2});
    const collision::ObjectId door = add_box(campus, "door", {-0.5, 0, 2}, {0.5, 3, 2.2});
    for (const Vec3& start : {Vec3(4.5, 0, 4.5), Vec3(-4.5, 0, 4.5), Vec3(4.5, 0, -4.5), Vec3(0, 0, -4.5)}) {
        const IslandReport room = inside_shell(campus, start);
        EXPECT_FALSE(room.hollow);
        ASSERT_TRUE(room.barrier);
        EXPECT_EQ(room.barrier->object, door) << "and no wall, from " << start.transpose();
    }
}

TEST_F(Findings, ARoomWithClosedShuttersIsNoHollow) {
    scene::Campus campus = walled_yard();
    add_object(campus, "walls", shell(1.0), {0, 0, 0});
    add_box(campus, "shutter/left", {0.0, 1.4, -2.1}, {0.5, 2.6, -1.9});
    add_box(campus, "shutter/right", {0.5, 1.4, -2.1}, {1.0, 2.6, -1.9});
    EXPECT_FALSE(inside_shell(campus).hollow) << "neither of the two lets anybody in alone";
}

TEST_F(Findings, APitThatOneCantClimbOutOfIsATrap) {
    scene::Campus campus = walled_yard();
    // A deck of 1 m that steps lead up to, with a hole in it.
    for (int i = 1; i <= 3; ++i) {
        add_box(campus, "tread-" + std::to_string(i), {-2, -0.1, 0.2 + 0.4 * i}, {2, 0.25 * i, 6});
    }
    add_box(campus, "deck/left", {-2, -0.1, 2}, {-1, 1, 6});
    add_box(campus, "deck/right", {1, -0.1, 2}, {2, 1, 6});
    add_box(campus, "deck/near", {-2, -0.1, 2}, {2, 1, 3});
    const WalkSpace& space = explored(campus);
    // The treads go on below the deck: the pit's floor is the third, 0.75 m high, and the deck 0.25 m above
    // it.
    EXPECT_TRUE(find_traps(*worlds_, settings_, space).empty());

    scene::Campus deeper = walled_yard();
    for (int i = 1; i <= 3; ++i) {
        add_box(deeper, "tread-" + std::to_string(i), {-2, -0.1, 0.2 + 0.4 * i}, {2, 0.25 * i, 2});
    }
    add_box(deeper, "deck/left", {-2, -0.1, 2}, {-1, 1, 6});
    add_box(deeper, "deck/right", {1, -0.1, 2}, {2, 1, 6});
    add_box(deeper, "deck/near", {-2, -0.1, 2}, {2, 1, 3});
    const WalkSpace& pit = explored(deeper);
    const std::vector<Trap> traps = find_traps(*worlds_, settings_, pit);
    ASSERT_EQ(traps.size(), 1U);
    EXPECT_NEAR(traps[0].drop, 1.0, 0.05);
    EXPECT_NEAR(static_cast<double>(traps[0].nodes.size()) * pit.grid.cell * pit.grid.cell,
                (2 - 0.6) * (3 - 0.6), 1.0);
}

/// A yard with a deck of `height` that steps of 0.25 m lead up to, and a hole in it of 2 m x 3 m, whose floor
/// is the yard's but for a bench in it of `bench`. A gate of the same height may close a way out of it.
scene::Campus yard_with_pit(double height, double bench, bool has_gate = false) {
    scene::Campus campus = walled_yard();
    for (int i = 1; 0.25 * i <= height; ++i) {
        add_box(campus, "tread-" + std::to_string(i), {-2, -0.1, 2 - 0.5 * i},
                {2, height - 0.25 * (i - 1), 2});
    }
    add_box(campus, "pit/south", {-2, -0.1, 2}, {2, height, 3});
    add_box(campus, "pit/west", {-2, -0.1, 2}, {-1, height, has_gate ? 3.5 : 6});
    if (has_gate) {
        add_box(campus, "pit/north-west", {-2, -0.1, 4.5}, {-1, height, 6});
        add_box(campus, "pit/gate", {-1.6, 0, 3.5}, {-1.4, height + 0.5, 4.5});
    }
    add_box(campus, "pit/east", {1, -0.1, 2}, {2, height, 6});
    add_box(campus, "pit/bench", {-1, -0.1, 5}, {1, bench, 6});
    return campus;
}

/// What keeps one in the only pit of the campus.
std::optional<Barrier> barrier_of_pit(const scene::Campus& campus) {
    const WorkerWorlds worlds(campus.world, 1, {});
    ExploreSettings settings = explore_settings(campus, AvatarProfile(), 60);
    settings.starts = {{4, 0, -4}};
    const WalkReport report = report_walks(campus, AvatarProfile(), worlds, settings);
    EXPECT_EQ(report.traps.size(), 1U);
    return report.traps.empty() ? std::nullopt : report.traps.front().out;
}

TEST_F(Findings, ATrapSaysWhichRiserKeepsOneIn) {
    const scene::Campus campus = yard_with_pit(0.75, 0.25);
    const auto out = barrier_of_pit(campus);
    ASSERT_TRUE(out);
    EXPECT_EQ(out->kind, ReasonKind::riser);
    EXPECT_NEAR(out->measured, 0.5, 0.002) << "from the bench, and not from the floor";
    ASSERT_TRUE(out->object);
    EXPECT_TRUE(campus.objects[index_of(*out->object)].id.starts_with("pit/"));
    EXPECT_GT(out->at.z(), 4.5) << "beside the bench";
}

TEST_F(Findings, ATrapSaysHowHighItsLedgeIs) {
    for (const double height : {1.25, 3.25}) {
        const auto out = barrier_of_pit(yard_with_pit(height, 0.0));
        ASSERT_TRUE(out);
        EXPECT_EQ(out->kind, ReasonKind::ledge);
        EXPECT_NEAR(out->measured, height, 0.05);
    }
}

TEST_F(Findings, ATrapSaysWhichObjectKeepsOneIn) {
    const scene::Campus campus = yard_with_pit(1.5, 0.0, true);
    const auto out = barrier_of_pit(campus);
    ASSERT_TRUE(out && out->object);
    EXPECT_EQ(out->kind, ReasonKind::object);
    EXPECT_EQ(campus.objects[index_of(*out->object)].id, "pit/gate");
}

/// From the gallery over three balconies down to the ground, one jump after the other, and no way back up.
TEST_F(Findings, WhatIsLeftOverSeveralLedgesIsNoTrap) {
    scene::Campus campus = yard_with_gallery();
    const auto add_balcony = [&](const std::string& name, double z, double height) {
        add_box(campus, name, {-2, height - 0.2, z}, {2, height, z + 1.6});
        add_box(campus, name + "/left", {-2.2, height - 0.2, z}, {-2, 4, z + 1.6});
        add_box(campus, name + "/right", {2, height - 0.2, z}, {2.2, 4, z + 1.6});
    };
    add_balcony("upper", -0.5, 2.25);
    add_balcony("middle", 1.1, 1.5);
    add_balcony("lower", 2.7, 0.75);
    const WalkSpace& space = explored(campus);
    ASSERT_TRUE(space.find(space.grid.cell_at(0.0, 0.3), 2.25));
    ASSERT_TRUE(space.find(space.grid.cell_at(0.0, 3.5), 0.75));
    EXPECT_TRUE(find_traps(*worlds_, settings_, space).empty());

    add_box(campus, "lower/railing", {-2, 0.75, 4.2}, {2, 4, 4.3});
    const WalkSpace& closed = explored(campus);
    std::set<GridCell> trapped;
    for (const Trap& trap : find_traps(*worlds_, settings_, closed)) {
        for (const WalkNodeId& node : trap.nodes) {
            trapped.insert(closed.cell_of(node));
        }
    }
    for (const double z : {0.3, 1.9, 3.5}) {
        EXPECT_TRUE(trapped.contains(closed.grid.cell_at(0.0, z))) << "now nobody leaves the lowest";
    }
    EXPECT_FALSE(trapped.contains(closed.grid.cell_at(0.0, -3.0))) << "the gallery";
    EXPECT_FALSE(trapped.contains(closed.grid.cell_at(0.0, 5.0))) << "the yard";
}

TEST_F(Findings, ATriggerThatReachesThroughAFloorIsFound) {
    scene::Campus campus = yard_with_gallery();
    ObjectTraits trigger;
    trigger.detection = collision::Detection::trigger;
    add_box(campus, "on-the-gallery", {-1, 3, -4}, {1, 5, -2}, trigger);
    const collision::ObjectId overhanging =
        add_box(campus, "through-the-floor", {-1, 1.6, -4}, {1, 5, -2}, trigger);
    const collision::ObjectId below = add_box(campus, "below", {-2, 0, -5}, {2, 1.5, -1}, trigger);
    add_box(campus, "on-both", {-1, 0, -4}, {1, 5, -2}, trigger);
    const WalkSpace& space = explored(campus);
    const std::vector<TriggerOverhang> found =
        find_trigger_overhangs(campus, *worlds_, settings_, space, find_storeys(space));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].trigger, overhanging);
    EXPECT_EQ(found[0].storey, 0U);
    EXPECT_TRUE(found[0].from_above);
    EXPECT_NEAR(found[0].depth, 0.2, 0.01);
    EXPECT_NEAR(found[0].foot.y(), 0.0, 0.05);
    ASSERT_FALSE(found[0].also_in.empty());
    EXPECT_EQ(found[0].also_in[0], below);
}

/// Also beyond the middle of a visitor upstairs.
TEST_F(Findings, ATriggerIsTheMoreOfAnOverhangTheFartherItReaches) {
    for (const double top : {3.1, 3.5, 3.8, 4.2, 4.6}) {
        scene::Campus campus = yard_with_gallery();
        ObjectTraits trigger;
        trigger.detection = collision::Detection::trigger;
        add_box(campus, "lower-room", {-2, 0, -4}, {1, top, -2}, trigger);
        const collision::ObjectId upper = add_box(campus, "upper-room", {-2, 3, -4}, {1, 5, -2}, trigger);
        const WalkSpace& space = explored(campus);
        const std::vector<TriggerOverhang> found =
            find_trigger_overhangs(campus, *worlds_, settings_, space, find_storeys(space));
        ASSERT_EQ(found.size(), 1U) << top;
        EXPECT_EQ(found[0].storey, 1U);
        EXPECT_FALSE(found[0].from_above);
        EXPECT_NEAR(found[0].depth, top - 3.0, 0.01);
        EXPECT_EQ(found[0].also_in, std::vector{upper});
    }
}

TEST_F(Findings, ATriggerForTwoStoreysIsNoOverhang) {
    for (const double top : {4.75, 5.0, 9.0}) {  // as high as who stands upstairs, or nearly
        scene::Campus campus = yard_with_gallery();
        ObjectTraits trigger;
        trigger.detection = collision::Detection::trigger;
        add_box(campus, "atrium", {-2, 0, -4}, {1, top, -2}, trigger);
        add_box(campus, "stairwell", {-6, 0, -6}, {-4, top, 6}, trigger);
        const WalkSpace& space = explored(campus);
        EXPECT_TRUE(find_trigger_overhangs(campus, *worlds_, settings_, space, find_storeys(space)).empty())
            << top;
    }
}

/// Stairs that one also walks under: who climbs them leaves the room's trigger little by little, which is no
/// fault of it. The floor that they lead to is another thing.
TEST_F(Findings, StairsOutOfATriggerAreNoOverhang) {
    for (const bool reaches_the_gallery : {false, true}) {
        scene::Campus campus = walled_yard();
        for (int i = 1; i <= 12; ++i) {
            add_box(campus, "tread-" + std::to_string(i), {-6, 0.25 * i - 0.1, 5.5 - 0.5 * i},
                    {-4.5, 0.25 * i, 6.0 - 0.5 * i});
        }
        add_box(campus, "gallery", {-6, 2.8, -6}, {2, 3, -0.5});
        ObjectTraits trigger;
        trigger.detection = collision::Detection::trigger;
        add_box(campus, "room", {-6, 0, -6}, {6, reaches_the_gallery ? 3.6 : 2.9, 6}, trigger);
        const WalkSpace& space = explored(campus);
        ASSERT_TRUE(space.find(space.grid.cell_at(-5.0, 0.8), 2.5)) << "on the stairs";
        ASSERT_TRUE(space.find(space.grid.cell_at(-5.0, 0.8), 0.0)) << "under them";
        const std::vector<TriggerOverhang> found =
            find_trigger_overhangs(campus, *worlds_, settings_, space, find_storeys(space));
        ASSERT_EQ(found.size(), reaches_the_gallery ? 1U : 0U);
        if (reaches_the_gallery) {
            EXPECT_EQ(found[0].storey, 1U);
            EXPECT_NEAR(found[0].foot.y(), 3.0, 0.1) << "the feet may hang over the edge a little";
        }
    }
}

/// A carpet on the floor, 2 m x 2 m about the point, of triangles with sides of 5 cm.
std::shared_ptr<const collision::MeshCollider> carpet() {
    constexpr std::uint32_t kCells = 40;
    collision::TriangleMesh mesh;
    for (std::uint32_t z = 0; z <= kCells; ++z) {
        for (std::uint32_t x = 0; x <= kCells; ++x) {
            mesh.positions.emplace_back(0.05F * static_cast<float>(x) - 1.0F, 0.01F,
                                        0.05F * static_cast<float>(z) - 1.0F);
        }
    }
    for (std::uint32_t z = 0; z < kCells; ++z) {
        for (std::uint32_t x = 0; x < kCells; ++x) {
            const std::uint32_t first = z * (kCells + 1) + x;
            mesh.triangles.push_back({first, first + kCells + 1, first + 1});
            mesh.triangles.push_back({first + 1, first + kCells + 1, first + kCells + 2});
        }
    }
    return std::make_shared<const collision::MeshCollider>(std::move(mesh));
}

TEST_F(Findings, AnIslandMayLieAThousandKilometresAway) {
    scene::Campus campus = walled_yard();
    add_box(campus, "far", {1e6, -0.5, -1e6}, {1e6 + 4.0, 0, -1e6 + 4.0});
    explored(campus);
    const std::vector<Island> found = islands();
    const auto is_far = [](const Island& island) { return island.bounds.min.x() > 9e5; };
    ASSERT_EQ(std::ranges::count_if(found, is_far), 1) << "its top, not its underside as well";
    const Island& far = *std::ranges::find_if(found, is_far);
    EXPECT_NEAR(far.area(space_->grid), 16.0, 1.0);
}

TEST_F(Findings, ManyTrianglesAroundTheBodyAreAHotSpot) {
    scene::Campus campus = walled_yard();
    EXPECT_TRUE(find_hot_spots(WorkerWorlds(campus.world, 1, {}), settings_, explored(campus)).empty());
    const collision::ObjectId object = add_object(campus, "carpet", carpet(), {3, 0, 3});
    const WalkSpace& space = explored(campus);
    const std::vector<HotSpot> spots = find_hot_spots(*worlds_, settings_, space);
    ASSERT_FALSE(spots.empty());
    EXPECT_EQ(spots[0].object, object);
    // Within the radius and a step of the core's lower end: a circle of about half a metre.
    EXPECT_GT(spots[0].pieces, 300U);
    EXPECT_LT(spots[0].pieces, 1200U);
    EXPECT_LT((spots[0].foot - Vec3(3, 0, 3)).norm(), 1.2);
}

TEST_F(Findings, HotSpotsNearAHotterOneDontCount) {
    scene::Campus campus = level_campus(16.0);
    add_object(campus, "first", carpet(), {-6, 0, 0});
    add_object(campus, "beside", carpet(), {-1, 0, 0});
    add_object(campus, "over", carpet(), {-6, 0.001, 0});
    const collision::ObjectId far = add_object(campus, "far", carpet(), {8, 0, 0});
    const WalkSpace& space = explored(campus);
    const std::vector<HotSpot> spots = find_hot_spots(*worlds_, settings_, space);
    ASSERT_EQ(spots.size(), 2U);
    EXPECT_LT((spots[0].foot - Vec3(-6, 0, 0)).norm(), 1.2) << "two carpets on one another";
    EXPECT_GT(spots[0].pieces, spots[1].pieces);
    EXPECT_EQ(spots[1].object, far);
}

TEST_F(Findings, AGapInTheWallIsAHole) {
    scene::Campus campus = level_campus(6.0);
    add_box(campus, "north", {-6, 0, -6}, {6, 4, -5.8});
    add_box(campus, "south", {-6, 0, 5.8}, {6, 4, 6});
    add_box(campus, "west", {-6, 0, -6}, {-5.8, 4, 6});
    add_box(campus, "east", {5.8, 0, -6}, {6, 4, 0});
    add_box(campus, "east-end", {5.8, 0, 3}, {6, 4, 6});
    const std::vector<Hole> holes = find_holes(explored(campus));
    ASSERT_EQ(holes.size(), 1U);
    EXPECT_NEAR(holes[0].length, 3.0 - 0.6, 0.75);
    for (const Hole::Edge& edge : holes[0].edges) {
        EXPECT_GT(edge.at.x(), 5.4);
        EXPECT_GT(edge.at.z(), 0.0);
        EXPECT_LT(edge.at.z(), 3.0);
    }
    const std::vector<Hole> by_jumps = find_holes(explored(campus, true));
    ASSERT_EQ(by_jumps.size(), 1U);
    EXPECT_NEAR(by_jumps[0].length, holes[0].length, 0.5) << "from before the edge: a cell more at each end";
}

}  // namespace
}  // namespace campuswalk::engine

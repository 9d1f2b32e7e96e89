#include "engine/script/resolve_targets.h"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/simulation/simulation.h"
#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"
#include "tests/support/says.h"

namespace campuswalk::engine {
namespace {

using Eigen::Vector3d;
using support::says;
using testing::ElementsAre;

/// A floor with a hut that has walls, a club of which only the record is known, and a place put on the floor.
scene::Campus yard() {
    scene::Campus campus = level_campus(10.0);
    add_building(campus, "hut");
    add_building(campus, "club");
    ObjectTraits of_hut;
    of_hut.building = "hut";
    add_box(campus, "hut/wall", {3, 0, 3}, {4, 2, 5}, of_hut);
    campus.description.places = {{{}, "bench", {2, 0.25, 1}, false}};
    return campus;
}

LookAtStep look_at_building(std::size_t building, int line) {
    LookAtStep step = look_at({"building", {0, 0, 0}, true});
    step.mark = {"a.walk.yaml", line, 14};
    step.building = building;
    return step;
}

SnapshotStep snapshot_of(std::size_t building, int line) {
    SnapshotStep step = snapshot("view");
    step.camera.view = OrbitView{.around = CameraTarget{"it", building, {}, {"a.walk.yaml", line, 20}}};
    return step;
}

TEST(ResolveTargets, LooksAtTheMiddleOfABuilding) {
    Walk walk = walk_of({spawn_at({0, 0, 0}), look_at_building(0, 4), snapshot_of(0, 5)});
    EXPECT_FALSE(is_resolved(walk));
    EXPECT_TRUE(resolve_targets(yard(), walk).empty());
    EXPECT_TRUE(is_resolved(walk));
    EXPECT_TRUE(std::get<LookAtStep>(walk.steps[1]).target.point.isApprox(Vector3d(3.5, 1, 4)));
}

TEST(ResolveTargets, TeleportsToTheGroundOfAPlace) {
    TeleportStep step = teleport_to({2, 0, 1}, {}, "bench");
    step.place = 0;
    Walk walk = walk_of({spawn_at({0, 0, 0}), step});
    EXPECT_TRUE(resolve_targets(yard(), walk).empty());
    EXPECT_EQ(std::get<TeleportStep>(walk.steps[1]).position, Vector3d(2, 0.25, 1));
    EXPECT_TRUE(is_resolved(walk));
}

TEST(ResolveTargets, NamesBuildingsThatAreNowhere) {
    Walk walk = walk_of({spawn_at({0, 0, 0}), look_at_building(1, 4), snapshot_of(1, 5)});
    walk.camera.view = FixedView{.look_at = CameraTarget{"club", 1, {}, {"a.walk.yaml", 2, 30}}};
    std::vector<std::string> lines;
    for (const scene::Diagnostic& each : resolve_targets(yard(), walk)) {
        lines.push_back(to_string(each));
    }
    EXPECT_THAT(lines, ElementsAre(says("a.walk.yaml:2:30: error no-extent", {"'club'"}),
                                   says("a.walk.yaml:4:14: error no-extent", {"'club'"}),
                                   says("a.walk.yaml:5:20: error no-extent", {"'club'"})));
    EXPECT_EQ(check_aim(yard(), walk.camera.view).size(), 1U);
    EXPECT_TRUE(check_aim(yard(), View(OrbitView())).empty());
}

TEST(ResolveTargets, MustComeBeforeASimulation) {
    const scene::Campus campus = yard();
    Walk walk = walk_of({spawn_at({0, 0, 0}), look_at_building(0, 4)});
    EXPECT_THROW(Simulation(campus, walk), std::invalid_argument);
    resolve_targets(campus, walk);
    EXPECT_NO_THROW(Simulation(campus, walk));
}

}  // namespace
}  // namespace campuswalk::engine

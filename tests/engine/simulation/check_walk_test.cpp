#include "engine/simulation/check_walk.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"
#include "tests/support/says.h"

namespace campuswalk::engine {
namespace {

using collision::Detection;
using support::says;
using testing::ElementsAre;

/// A floor, a wall in a separate layer, a table 0.4 m high and a door's trigger.
scene::Campus furnished_room() {
    scene::Campus campus = level_campus();
    add_building(campus, "library");
    add_box(campus, "library/walls", {4, 0, -2}, {6, 3, 2}, {Detection::solid, "library", true, "buildings"});
    add_box(campus, "table", {-6, 0, -2}, {-4, 0.4, 2});
    add_box(campus, "library/door", {2, 0, -1}, {3.5, 2, 1}, {Detection::trigger, "library", true, ""});
    return campus;
}

std::vector<std::string> diagnostics(const Walk& walk) {
    std::vector<std::string> reported;
    for (const scene::Diagnostic& diagnostic : check_walk(furnished_room(), walk)) {
        reported.push_back(scene::to_string(diagnostic));
    }
    return reported;
}

template <typename Marked>
Marked marked(Marked item, int line) {
    item.mark = {"a.walk.yaml", line, 5};
    return item;
}

using Diagnostics = std::vector<std::string>;

TEST(CheckWalk, AcceptsFreePlaces) {
    EXPECT_EQ(diagnostics(walk_of({spawn_at({0, 0, 0}), teleport_to({0, 20, 0}), teleport_to({2.5, 0, 0})})),
              Diagnostics())
        << "on the ground, in the air, in a trigger";
}

TEST(CheckWalk, AcceptsAPlaceThatIsFreeUpToHalfAMetreAbove) {
    // The table's top is 0.4 m up; a capsule whose lowest point is there is free.
    EXPECT_EQ(diagnostics(walk_of({spawn_at({-5, 0, 0})})), Diagnostics());
    EXPECT_EQ(diagnostics(walk_of({spawn_at({-5, -0.05, 0})})), Diagnostics());
    EXPECT_EQ(diagnostics(walk_of({spawn_at({-5, -0.15, 0})})).size(), 1U);
}

TEST(CheckWalk, RejectsASpawnInTheAirThatDoesNotSaySo) {
    EXPECT_EQ(diagnostics(walk_of({spawn_at({0, 0.49, 0})})), Diagnostics());
    EXPECT_THAT(
        diagnostics(walk_of({marked(spawn_at({0, 0.51, 0}), 12)})),
        ElementsAre(says("a.walk.yaml:12:5: error spawn-in-air", {"0.51 m above the ground", "fall: true"})));
    EXPECT_THAT(
        diagnostics(walk_of({marked(spawn_at({-5, 30.4, 0}, 0.0, "roof"), 12)})),
        ElementsAre(says("a.walk.yaml:12:5: error spawn-in-air", {"roof", "30.00 m above the ground"})));
    EXPECT_THAT(diagnostics(walk_of({spawn_at({5000, 0, 0})})),
                ElementsAre(says("error spawn-in-air", {"over nothing"})));
    SpawnStep announced = spawn_at({-5, 30.4, 0});
    announced.fall = true;
    EXPECT_EQ(diagnostics(walk_of({announced})), Diagnostics());
    // Its edge is enough to stand on.
    EXPECT_EQ(diagnostics(walk_of({spawn_at({-6.2, 0.4, 0})})), Diagnostics());
}

TEST(CheckWalk, RejectsASpawnInAWall) {
    EXPECT_THAT(diagnostics(walk_of({marked(spawn_at({5, 0.25, 0.5}, 0.0, "main-gate"), 12)})),
                ElementsAre(says("a.walk.yaml:12:5: error spawn-blocked",
                                 {"main-gate", "5.000,0.250,0.500", "library/walls", "0.30 m", "1.80 m"})));
}

TEST(CheckWalk, AcceptsATeleportThatCanBePushedOutOfAWall) {
    const auto teleport_with_gap = [](double gap) {
        return diagnostics(walk_of({spawn_at({0, 0, 0}), marked(teleport_to({4.0 - 0.3 - gap, 0, 0}), 14)}));
    };
    EXPECT_EQ(teleport_with_gap(0.001), Diagnostics());
    EXPECT_EQ(teleport_with_gap(-0.299), Diagnostics()) << "by less than the radius";
    EXPECT_THAT(teleport_with_gap(-0.301),
                ElementsAre(says("a.walk.yaml:14:5: error spawn-blocked",
                                 {"elsewhere", "4.001,0.000,0.000", "library/walls"})));
}

TEST(CheckWalk, UsesTheWalksOwnAvatar) {
    // Below the floor, into which an adult's head reaches.
    Walk low = walk_of({spawn_at({0, 0, 0}), marked(teleport_to({5, -1.1, 0}), 14)});
    EXPECT_EQ(diagnostics(low).size(), 1U);
    low.avatar.height = 1.0;
    low.avatar.radius = 0.1;
    EXPECT_EQ(diagnostics(low), Diagnostics());
}

TEST(CheckWalk, SkipsIgnoredLayers) {
    Walk ghost = walk_of({spawn_at({5, 0, 0})});
    EXPECT_EQ(diagnostics(ghost).size(), 1U);
    ghost.avatar.ignore_layers = {"buildings"};
    EXPECT_EQ(diagnostics(ghost), Diagnostics());
}

TEST(CheckWalk, RejectsATypoWithASuggestion) {
    Walk walk = walk_of({spawn_at({0, 0, 0})});
    walk.expectations = {expect_never("trigger.enter libary/door", 21)};
    EXPECT_THAT(diagnostics(walk), ElementsAre(says("a.walk.yaml:21:5: error unknown-name",
                                                    {"'trigger.enter libary/door'", "'library/door'"})));
}

TEST(CheckWalk, RejectsAnObjectOfAnotherDetectionMode) {
    Walk walk = walk_of({spawn_at({0, 0, 0})});
    walk.expectations = {expect_count("ray.enter table", {}, 1, {}, 22)};
    EXPECT_THAT(diagnostics(walk),
                ElementsAre(says("a.walk.yaml:22:5: error unknown-name", {"'ray.enter table'"})));
}

TEST(CheckWalk, RejectsEnablingAnUnknownObject) {
    EnableStep step = enable("libary/door");
    step.objects[0].mark = {"a.walk.yaml", 8, 13};
    EXPECT_THAT(
        diagnostics(walk_of({spawn_at({0, 0, 0}), disable("library/*"), step, step})),
        ElementsAre(says("a.walk.yaml:8:13: error unknown-name", {"'libary/door'", "'library/door'"})))
        << "once, however often the step is played";
}

TEST(CheckWalk, RejectsWaitingForAnImpossibleEvent) {
    WaitUntilStep step = wait_until("trigger.enter library/dor");
    step.event.mark = {"a.walk.yaml", 9, 17};
    EXPECT_THAT(diagnostics(walk_of({spawn_at({0, 0, 0}), step})),
                ElementsAre(says("a.walk.yaml:9:17: error unknown-name",
                                 {"'trigger.enter library/dor'", "'library/door'"})));
}

TEST(CheckWalk, ReportsEverythingAtOnce) {
    Walk walk = walk_of({spawn_at({5, 0, 0}), teleport_to({5, 0, 0})});
    walk.expectations = {
        expect_sequence({"popup.open library", "popup.open librari", "collision.enter tabel"}),
        expect_never("popup.close l?b")};
    const std::vector<scene::Diagnostic> found = check_walk(furnished_room(), walk);
    std::vector<std::string> codes;
    codes.reserve(found.size());
    for (const scene::Diagnostic& diagnostic : found) {
        codes.emplace_back(diagnostic.code.text());
    }
    EXPECT_EQ(codes, Diagnostics(
                         {"spawn-blocked", "spawn-blocked", "unknown-name", "unknown-name", "unknown-name"}));
}

TEST(CheckWalk, ChecksTheBuildingsAndObjectsOfExpectations) {
    const SourceMark mark = {"a.walk.yaml", 21, 5};
    const auto about = [&](const Expectation& expectation) {
        Walk walk = walk_of({spawn_at({0, 0, 0})});
        walk.expectations = {expectation};
        return diagnostics(walk);
    };
    const std::string unknown = "a.walk.yaml:21:5: error unknown-name";
    EXPECT_EQ(about(ExpectPopup{mark, {mark, "library"}}), Diagnostics());
    EXPECT_THAT(about(ExpectPopup{mark, {mark, "libary"}}),
                ElementsAre(says(unknown, {"building", "'libary'", "'library'"})));
    EXPECT_THAT(about(ExpectVisits{mark, {{mark, "l*"}, {mark, "lab"}}, 1.0}),
                ElementsAre(says(unknown, {"building", "'lab'"})));
    EXPECT_THAT(about(ExpectBlockedBy{mark, {mark, "tabel"}}),
                ElementsAre(says(unknown, {"object", "'tabel'", "'table'"})));
    EXPECT_EQ(about(ExpectStuck{mark, {mark, "*"}}), Diagnostics());
    EXPECT_THAT(about(ExpectNot{mark, ExpectStuck{mark, {mark, "library/door"}}}),
                ElementsAre(says(unknown, {"object", "'library/door'"})))
        << "a trigger blocks nobody";
    EXPECT_EQ(about(ExpectNear{mark, {}, 1.0, EventPattern{mark, "trigger.enter", "table"}}).size(), 1U);
    EXPECT_EQ(about(ExpectWithin{mark, {mark, "trigger.enter", "a"}, {mark, "popup.open", "b"}, 1.0}).size(),
              2U);
}

TEST(CheckWalk, ChecksExpectationsInSteps) {
    const ExpectStep step = {{}, {expect_never("popup.open libary", 9)}};
    EXPECT_EQ(diagnostics(walk_of({spawn_at({0, 0, 0}), step, step})).size(), 1U)
        << "once, however often the step is played";
}

TEST(CheckWalk, AcceptsAnyTargetOfReaches) {
    Walk walk = walk_of({spawn_at({0, 0, 0})});
    walk.expectations = {expect_reaches({"nowhere", {1e6, 0, 0}, false}, 0.1)};
    EXPECT_EQ(diagnostics(walk), Diagnostics());
}

}  // namespace
}  // namespace campuswalk::engine

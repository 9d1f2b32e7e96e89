#include "engine/expect/failure_scene.h"

#include <gtest/gtest.h>

#include "tests/engine/expect/single_evaluator.h"
#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"

namespace campuswalk::engine {
namespace {

/// A floor with a post 2 m east of the origin, a hall 20 m north and a lab 40 m south.
scene::Campus yard() {
    scene::Campus campus = level_campus();
    add_building(campus, "hall");
    add_building(campus, "lab");
    add_box(campus, "post", {1.9, 0, -0.1}, {2.1, 2, 0.1});
    add_box(campus, "hall/door", {-1, 0, -21}, {1, 2, -20},
            {collision::Detection::trigger, "hall", true, ""});
    add_box(campus, "lab/door", {-1, 0, 40}, {1, 2, 41}, {collision::Detection::trigger, "lab", true, ""});
    return campus;
}

FailureScene scene_at(const Eigen::Vector3d& position) {
    StateSnapshot state;
    state.avatar.position = position;
    return scene_of(state, yard(), {});
}

TEST(FailureScene, NamesTheNearestObjectButNotTheGround) {
    const FailureScene scene = scene_at({0, 0.0, 0});
    EXPECT_EQ(scene.nearest, "post");
    EXPECT_NEAR(scene.nearest_distance, 1.9 - 0.3, 1e-9) << "from the surface of the body";
    EXPECT_EQ(scene_at({2.0, 0.0, 0.0}).nearest_distance, 0.0) << "inside";
}

TEST(FailureScene, NamesNoObjectThatIsFarAway) {
    const FailureScene scene = scene_at({-20, 0, 0});
    EXPECT_EQ(scene.nearest, "");
    EXPECT_EQ(scene.nearest_distance, 0.0);
}

TEST(FailureScene, ShowsWhatTheBodyNearlyTouches) {
    const FailureScene scene = scene_at({1.3, 0, 0});
    ASSERT_TRUE(scene.contact.has_value());
    EXPECT_DOUBLE_EQ(scene.contact->x(), 1.9);
    EXPECT_FALSE(scene_at({0.5, 0, 0}).contact.has_value()) << "1.1 m away";
}

TEST(FailureScene, ShowsWhereTheReasonWasMeasured) {
    scene::Campus campus = level_campus();
    add_box(campus, "stage", {-20, -0.1, -14}, {20, 0.45, -4});
    const RecordedRun result = run(campus, walk_of({spawn_at({0, 0, 0}), walk_to(0, -10)}));
    ASSERT_EQ(result.summary.failures.size(), 1U);
    ASSERT_TRUE(result.summary.failures[0].scene.contact.has_value());
    const Eigen::Vector3d contact = *result.summary.failures[0].scene.contact;
    EXPECT_NEAR(contact.z(), -4.0, 1e-3);
    EXPECT_NEAR(contact.x(), 0.0, 0.3);
    const RecordedRun fallen = run(level_campus(5.0), walk_of({spawn_at({0, 0, 0}), walk_to(0, -10)}));
    ASSERT_TRUE(fallen.summary.failures.at(0).scene.contact.has_value());
    EXPECT_NEAR(fallen.summary.failures[0].scene.contact->z(), -5.0, 0.35) << "where it last stood";
}

TEST(FailureScene, NamesTheNearestBuilding) {
    EXPECT_EQ(scene_at({0, 0, 9}).building, "hall") << "29 m against 31 m";
    EXPECT_EQ(scene_at({0, 0, 11}).building, "lab");
    StateSnapshot state;
    state.building = 1;
    EXPECT_EQ(scene_of(state, yard(), {}).building, "lab")
        << "a building with an open pop-up takes precedence";
    EXPECT_EQ(scene_of({}, level_campus(), {}).building, "");
}

TEST(FailureScene, ListsTheLastEventsAsInTheLog) {
    StateHistory history;
    TickFeed(history)
        .tick({"walk.start me", "trigger.enter a"})
        .tick({})
        .tick({"popup.open a", "popup.close a", "trigger.exit a", "avatar.arrive goal"});
    const FailureScene scene = scene_of(history.now(), yard(), {});
    EXPECT_EQ(scene.last_events,
              std::vector<std::string>(
                  {"000000    0.000000 trigger.enter    a", "000002    0.200000 popup.open       a",
                   "000002    0.200000 popup.close      a", "000002    0.200000 trigger.exit     a",
                   "000002    0.200000 avatar.arrive    goal"}));
    EXPECT_EQ(scene.tick, 2);
    EXPECT_EQ(scene.time, 0.2);
}

TEST(FailureScene, ShowsTheEndOfTheWalkIfAStepGaveUp) {
    scene::Campus campus = level_campus();
    add_box(campus, "wall", {-5, 0, -3}, {5, 3, -2});
    const RecordedRun result = run(campus, walk_of({spawn_at({0, 0, 0}), walk_to(0, -8)}));
    ASSERT_EQ(result.summary.failures.size(), 1U);
    const FailureScene& scene = result.summary.failures[0].scene;
    EXPECT_EQ(scene.tick, result.summary.ticks);
    EXPECT_EQ(scene.nearest, "wall");
    EXPECT_NEAR(scene.nearest_distance, 0.02, 1e-6) << "the skin width";
    EXPECT_NEAR(scene.position.z(), -1.68, 1e-6);
    ASSERT_FALSE(scene.last_events.empty());
    EXPECT_NE(scene.last_events.back().find("avatar.blocked   goal"), std::string::npos)
        << "without the events of the walk's end";
}

TEST(FailureScene, DoesNotNameADisabledObject) {
    const RecordedRun result = [] {
        Walk walk = walk_of({spawn_at({0, 0, 0}), disable("post"), wait_for(0.1),
                             ExpectStep{{"a.walk.yaml", 4, 5}, {expect_never("object.disable")}}});
        return run(yard(), walk);
    }();
    ASSERT_EQ(result.summary.failures.size(), 1U);
    EXPECT_EQ(result.summary.failures[0].scene.nearest, "");
}

}  // namespace
}  // namespace campuswalk::engine

// Enabling and disabling objects during a walk, and waiting for events.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"

namespace campuswalk::engine {
namespace {

using collision::Detection;
using Eigen::Vector3d;
using testing::AllOf;
using testing::HasSubstr;
using Lines = std::vector<std::string>;

const ObjectTraits kSwitched{Detection::trigger, "", true, ""};
const ObjectTraits kLookedAt{Detection::ray, "", true, ""};

std::string cause_of(const Event& event) {
    return has_field(event, "cause") ? field<std::string>(event, "cause") : "";
}

TEST(Disable, OpensAGateAndEnableClosesIt) {
    scene::Campus campus = level_campus();
    add_box(campus, "gate/left", {-5, 0, -3}, {0, 3, -2.8});
    add_box(campus, "gate/right", {0, 0, -3}, {5, 3, -2.8});
    const RecordedRun result =
        run(campus, walk_of({spawn_at({0, 0, 0}), walk_to_or_proceed(0, -6), disable("gate/*"),
                             walk_to(0, -6), enable("gate/*"), walk_to_or_proceed(0, 0)}));
    EXPECT_EQ(result.recorder.events("avatar.blocked goal").size(), 2U);
    EXPECT_EQ(result.recorder.events("avatar.arrive goal").size(), 1U);
    EXPECT_LT(result.recorder.states().back().avatar.position.z(), -3.2);
    EXPECT_EQ(result.recorder.events("object.disable").size(), 2U);
    EXPECT_EQ(result.recorder.events("object.enable gate/left").size(), 1U);
}

TEST(Disable, EndsEveryContactAtOnceAndLogsTheCause) {
    scene::Campus campus = level_campus();
    add_building(campus, "hall");
    add_box(campus, "hall/zone", {-1, 0, -1}, {1, 2, 1}, {Detection::trigger, "hall", true, ""});
    add_box(campus, "hall/wall", {-5, 0, -3}, {5, 3, -2},
            {Detection::solid | Detection::ray, "hall", true, ""});
    const RecordedRun result = run(
        campus, walk_of({spawn_at({0, 0, 0}), walk_to_or_proceed(0, -5), disable("hall/*"), wait_for(0.5)}));
    for (const char* kind : {"trigger.exit", "collision.exit", "ray.exit"}) {
        const auto exits = result.recorder.events(kind);
        ASSERT_EQ(exits.size(), 1U) << kind;
        if (std::string(kind) != "trigger.exit") {
            EXPECT_EQ(cause_of(exits[0]), "disabled") << kind << ", without gaze hold";
            EXPECT_EQ(exits[0].tick, result.recorder.events("object.disable hall/wall")[0].tick);
        }
    }
    EXPECT_EQ(result.recorder.events("popup.close hall").size(), 1U);
}

TEST(Disable, ExitsATriggerAroundTheAvatar) {
    scene::Campus campus = level_campus();
    add_box(campus, "zone", {-1, 0, -1}, {1, 2, 1}, kSwitched);
    const RecordedRun result = run(campus, walk_of({spawn_at({0, 0, 0}), wait_for(0.1), disable("zone"),
                                                    wait_for(0.1), enable("zone"), wait_for(0.1)}));
    EXPECT_EQ(result.recorder.event_lines(),
              Lines({"trigger.enter zone", "object.disable zone", "trigger.exit zone", "object.enable zone",
                     "trigger.enter zone", "trigger.exit zone"}));
    const auto enters = result.recorder.events("trigger.enter");
    const auto exits = result.recorder.events("trigger.exit");
    EXPECT_EQ(cause_of(enters[0]), "spawn");
    EXPECT_EQ(cause_of(exits[0]), "disabled");
    EXPECT_EQ(cause_of(enters[1]), "enable");
    EXPECT_EQ(cause_of(exits[1]), "end");
    EXPECT_EQ(field<std::int64_t>(exits[0], "ticks"), 6);
    EXPECT_FALSE(has_field(exits[0], "at"));
}

TEST(Disable, LetsTheGazePassThroughTheObject) {
    scene::Campus campus = level_campus();
    add_box(campus, "curtain", {-1, 0, -4}, {1, 3, -3});
    add_box(campus, "picture", {-1, 0, -6}, {1, 3, -5}, kLookedAt);
    const RecordedRun result =
        run(campus, walk_of({spawn_at({0, 0, 0}), wait_for(0.1), disable("curtain"), wait_for(0.1)}));
    const auto enters = result.recorder.events("ray.enter picture");
    ASSERT_EQ(enters.size(), 1U);
    EXPECT_EQ(cause_of(enters[0]), "disabled");
}

TEST(Disable, MakesTheAvatarFallIfItStandsOnTheObject) {
    scene::Campus campus = level_campus();
    add_box(campus, "trapdoor", {-1, 0, -1}, {1, 2, 1});
    const RecordedRun result =
        run(campus,
            walk_of({spawn_at({0, 2, 0}), wait_for(0.1), disable("trapdoor"), wait_until("avatar.landed")}));
    EXPECT_TRUE(result.summary.passed);
    EXPECT_NEAR(field<Decimal>(result.recorder.events("avatar.landed").at(0), "height").value, 2.0, 2e-3);
    EXPECT_NEAR(result.recorder.states().back().avatar.position.y(), 0.0, 1e-3);
}

TEST(Disable, LogsNothingForDisabledObjects) {
    scene::Campus campus = level_campus();
    add_box(campus, "zone", {-1, 0, -1}, {1, 2, 1}, kSwitched);
    const RecordedRun result =
        run(campus,
            walk_of({spawn_at({5, 0, 0}), enable("zone"), disable("zone"), disable("z*"), wait_for(0.1)}));
    EXPECT_EQ(result.recorder.event_lines(), Lines({"object.disable zone"}));
}

TEST(Enable, PushesTheAvatarOutOfASolid) {
    scene::Campus campus = level_campus();
    add_box(campus, "door", {-1, 0, -0.4}, {1, 2, -0.1});
    const RecordedRun result =
        run(campus,
            walk_of({spawn_at({0, 0, 5}), disable("door"), walk_to(0, 0), enable("door"), wait_for(0.1)}));
    EXPECT_TRUE(result.summary.passed);
    const auto pushes = result.recorder.events("avatar.depenetrated stroll");
    ASSERT_EQ(pushes.size(), 1U);
    EXPECT_EQ(field<std::string>(pushes[0], "by"), "door");
    const double z = result.recorder.states().back().avatar.position.z();
    EXPECT_GE(z, -0.1 + 0.3);
    EXPECT_LT(z, -0.1 + 0.3 + 0.01);
    EXPECT_EQ(cause_of(result.recorder.events("collision.enter door").at(0)), "enable");
}

TEST(Enable, EndsTheWalkIfASolidEnclosesTheAvatar) {
    scene::Campus campus = level_campus();
    add_box(campus, "block", {-3, -1, -3}, {3, 4, 3});
    EnableStep on = enable("block");
    on.mark = {"a.walk.yaml", 7, 3};
    const RecordedRun result = run(campus, walk_of({spawn_at({8, 0, 0}), disable("block"), walk_to(0, 0), on,
                                                    snapshot("never"), wait_for(1.0)}));
    ASSERT_EQ(result.summary.failures.size(), 1U);
    EXPECT_EQ(result.summary.failures[0].code, "enclosed");
    EXPECT_THAT(result.summary.failures[0].message, HasSubstr("block"));
    EXPECT_EQ(result.summary.failures[0].mark.line, 7);
    EXPECT_TRUE(result.recorder.events("snapshot.take").empty());
}

// ---- waiting --------------------------------------------------------------------------------------------

TEST(WaitUntil, EndsInTheTickOfTheEvent) {
    const RecordedRun result = run(level_campus(), walk_of({spawn_at({0, 0, 0}), teleport_to({0, 5, 0}),
                                                            wait_until("avatar.landed"), snapshot("down")}));
    EXPECT_TRUE(result.summary.passed);
    EXPECT_EQ(result.recorder.events("snapshot.take down").at(0).tick,
              result.recorder.events("avatar.landed").at(0).tick);
}

TEST(WaitUntil, SeesEventsOfAnEnableStepBeforeIt) {
    scene::Campus campus = level_campus();
    add_box(campus, "zone", {-1, 0, -1}, {1, 2, 1}, kSwitched);
    const RecordedRun result = run(campus, walk_of({spawn_at({0, 0, 0}), disable("zone"), wait_for(0.5),
                                                    enable("zone"), wait_until("trigger.enter zone", 2.0)}));
    EXPECT_TRUE(result.summary.passed);
    EXPECT_EQ(result.summary.ticks, 31);
}

TEST(WaitUntil, IgnoresEarlierEvents) {
    scene::Campus campus = level_campus();
    add_box(campus, "zone", {-1, 0, -1}, {1, 2, 1}, kSwitched);
    WaitUntilStep wait = wait_until("trigger.enter zone", 2.0);
    wait.mark = {"a.walk.yaml", 6, 3};
    const RecordedRun result =
        run(campus, walk_of({spawn_at({0, 0, 0}), wait_for(0.1), wait, snapshot("never")}));
    ASSERT_EQ(result.summary.failures.size(), 1U);
    EXPECT_EQ(result.summary.failures[0].code, "timeout");
    EXPECT_THAT(result.summary.failures[0].message,
                AllOf(HasSubstr("'trigger.enter zone'"), HasSubstr("2.0 s")));
    EXPECT_EQ(result.summary.failures[0].mark.line, 6);
    EXPECT_EQ(result.summary.ticks, 6 + 120);
    EXPECT_TRUE(result.recorder.events("snapshot.take").empty());
}

}  // namespace
}  // namespace campuswalk::engine

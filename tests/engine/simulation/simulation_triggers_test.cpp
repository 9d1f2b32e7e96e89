#include <cmath>

#include <gtest/gtest.h>

#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"
#include "tests/support/mesh_pieces.h"

// Triggers on straight walks along -Z from the origin. The avatar has a radius of 0.3 m, walks at 1.4 m/s and
// stands between 0 and 1.8 m, so that a volume as high as a person is touched where its outline is.

namespace campuswalk::engine {
namespace {

using collision::Detection;
using Eigen::Vector3d;

constexpr double kRadius = 0.3;
constexpr double kTickLength = 1.4 / 60.0;  // metres walked in a tick
constexpr double kLeaveSlack = 1e-3;        // a trigger is left a millimetre outside its surface
const ObjectTraits kTrigger{Detection::trigger, "", true, ""};

/// A tick, and a fraction of its motion.
struct TickFraction {
    Tick tick = 0;
    double at = 0.0;
};
/// When a walk that begins in tick 1 has gone this far.
TickFraction after(double metres, double tick_length = kTickLength) {
    const double ticks = metres / tick_length;
    const double tick = std::ceil(ticks);
    return {static_cast<Tick>(tick), ticks - (tick - 1.0)};
}

void expect_time(const Event& event, const TickFraction& expected) {
    EXPECT_EQ(event.tick, expected.tick) << event_line(event);
    EXPECT_NEAR(event.at, expected.at, 1e-8) << event_line(event);
    EXPECT_NEAR(field<Decimal>(event, "at").value, expected.at, 1e-8);
    EXPECT_FALSE(has_field(event, "cause"));
}

/// Walks 8 m along -Z and expects one contact, between two distances from the start.
void expect_contact(const scene::Campus& campus, double enter, double leave) {
    const RecordedRun result = run(campus, walk_of({spawn_at({0, 0, 0}), walk_to(0, -8)}));
    const auto enters = result.recorder.events("trigger.enter");
    const auto exits = result.recorder.events("trigger.exit");
    ASSERT_EQ(enters.size(), 1U);
    ASSERT_EQ(exits.size(), 1U);
    expect_time(enters[0], after(enter));
    expect_time(exits[0], after(leave));
    EXPECT_NEAR(field<Vector3d>(enters[0], "pos").z(), -enter, 1e-9);
    EXPECT_NEAR(field<Vector3d>(exits[0], "pos").z(), -leave, 1e-9);
    EXPECT_EQ(field<std::int64_t>(exits[0], "ticks"), exits[0].tick - enters[0].tick);
}

TEST(Triggers, AreTouchedAtTheFacesOfABox) {
    scene::Campus campus = level_campus();
    add_box(campus, "door", {-1, 0, -3.5}, {1, 2, -2.5}, kTrigger);
    expect_contact(campus, 2.5 - kRadius, 3.5 + kRadius + kLeaveSlack);
}

TEST(Triggers, AreTouchedAroundTheEdgeOfABox) {
    scene::Campus campus = level_campus();
    add_box(campus, "door", {0.25, 0, -3.5}, {1, 2, -2.5}, kTrigger);
    const double in = std::sqrt(kRadius * kRadius - 0.25 * 0.25);
    const double out = std::sqrt((kRadius + kLeaveSlack) * (kRadius + kLeaveSlack) - 0.25 * 0.25);
    expect_contact(campus, 2.5 - in, 3.5 + out);
}

TEST(Triggers, AreNotTouchedHalfAMillimetreAway) {
    scene::Campus campus = level_campus();
    add_box(campus, "door", {kRadius + 0.0005, 0, -3.5}, {1, 2, -2.5}, kTrigger);
    const RecordedRun result = run(campus, walk_of({spawn_at({0, 0, 0}), walk_to(0, -8)}));
    EXPECT_TRUE(result.recorder.events("trigger.*").empty());
}

TEST(Triggers, AreEnteredByTheHead) {
    scene::Campus campus = level_campus();
    add_box(campus, "sign", {-1, 1.7, -3.5}, {1, 2, -2.5}, kTrigger);
    // The head is a sphere about a point 1.5 m up; the avatar keeps 0.1 mm away from the ground.
    const double below = 1.7 - 1.5 - 1e-4;
    const double in = std::sqrt(kRadius * kRadius - below * below);
    const double out = std::sqrt((kRadius + kLeaveSlack) * (kRadius + kLeaveSlack) - below * below);
    expect_contact(campus, 2.5 - in, 3.5 + out);
}

TEST(Triggers, CanBeSpheres) {
    scene::Campus campus = level_campus();
    add_object(campus, "ball", collision::Sphere{0.5}, {0.4, 1, -3}, kTrigger);
    const auto half = [](double reach) { return std::sqrt(reach * reach - 0.4 * 0.4); };
    expect_contact(campus, 3 - half(0.5 + kRadius), 3 + half(0.5 + kRadius + kLeaveSlack));
}

TEST(Triggers, CanBeCapsules) {
    scene::Campus campus = level_campus();
    add_object(campus, "post", collision::Capsule{0.2, 1.0}, {-0.3, 1, -4}, kTrigger);
    const auto half = [](double reach) { return std::sqrt(reach * reach - 0.3 * 0.3); };
    expect_contact(campus, 4 - half(0.2 + kRadius), 4 + half(0.2 + kRadius + kLeaveSlack));
}

TEST(Triggers, CanBeWheels) {
    scene::Campus campus = level_campus();
    add_object(campus, "wheel", collision::Wheel{0.8, 0.1}, {0.05, 1, -3}, kTrigger);
    expect_contact(campus, 3 - 0.8 - kRadius, 3 + 0.8 + kRadius + kLeaveSlack);
}

TEST(Triggers, CanBeMeshesAndAreFilledIfClosed) {
    scene::Campus campus = level_campus();
    collision::TriangleMesh room;
    support::add_box(room, {-3, 0, -6.5}, {3, 3, -1.5});
    add_object(campus, "room", std::make_shared<const collision::MeshCollider>(std::move(room)),
               Vector3d::Zero(), kTrigger);
    // The contact goes on in the middle of the room, two metres from every wall.
    expect_contact(campus, 1.5 - kRadius, 6.5 + kRadius + kLeaveSlack);
}

TEST(Triggers, AreTouchedOnADiagonalPath) {
    scene::Campus campus = level_campus();
    add_box(campus, "gate", {1.5, 0, -50}, {40, 2, 50}, kTrigger);
    const RecordedRun result = run(campus, walk_of({spawn_at({0, 0, 0}), walk_to(3, -4)}));
    const auto enters = result.recorder.events("trigger.enter gate");
    ASSERT_EQ(enters.size(), 1U);
    expect_time(enters[0], after((1.5 - kRadius) / 0.6));
}

// ---- several within a tick ------------------------------------------------------------------------------

/// Walks 20 m at 60 m/s: a metre per tick.
RecordedRun dash(const scene::Campus& campus) {
    WalkToStep step = walk_to(0, -20);
    step.speed = 60.0;
    return run(campus, walk_of({spawn_at({0, 0, 0}), step}));
}

using Lines = std::vector<std::string>;

TEST(Triggers, AreNotMissedByAFastAvatar) {
    scene::Campus campus = level_campus();
    add_box(campus, "thin", {-1, 0, -2.5}, {1, 2, -2.4}, kTrigger);
    const RecordedRun result = dash(campus);
    const auto enters = result.recorder.events("trigger.enter");
    const auto exits = result.recorder.events("trigger.exit");
    ASSERT_EQ(enters.size(), 1U);
    ASSERT_EQ(exits.size(), 1U);
    expect_time(enters[0], {3, 0.1});
    expect_time(exits[0], {3, 0.8});
    EXPECT_EQ(field<std::int64_t>(exits[0], "ticks"), 0);
}

TEST(Triggers, AreOrderedByTimeWithinATick) {
    scene::Campus campus = level_campus();
    // Entered at 2.1, 2.7 and 2.4 m, left at 2.8, 3.4 and 3.1 m.
    add_box(campus, "first", {-1, 0, -2.5}, {1, 2, -2.4}, kTrigger);
    add_box(campus, "third", {-1, 0, -3.1}, {1, 2, -3.0}, kTrigger);
    add_box(campus, "second", {-1, 0, -2.8}, {1, 2, -2.7}, kTrigger);
    const RecordedRun result = dash(campus);
    EXPECT_EQ(
        result.recorder.event_lines(),
        Lines({"trigger.enter first", "trigger.enter second", "trigger.enter third", "trigger.exit first",
               "trigger.exit second", "trigger.exit third", "avatar.arrive goal"}));
    const auto exits = result.recorder.events("trigger.exit");
    expect_time(exits[0], {3, 0.8});
    // These were entered in an earlier tick, so they are left a millimetre later.
    expect_time(exits[1], {4, 0.1 + kLeaveSlack});
    expect_time(exits[2], {4, 0.4 + kLeaveSlack});
}

TEST(Triggers, AreOrderedByObjectAtTheSameTime) {
    scene::Campus campus = level_campus();
    for (const char* name : {"zebra", "ape", "mule"}) {
        add_box(campus, name, {-1, 0, -3.5}, {1, 2, -2.5}, kTrigger);
    }
    const RecordedRun result = run(campus, walk_of({spawn_at({0, 0, 0}), walk_to(0, -8)}));
    EXPECT_EQ(result.recorder.event_lines(),
              Lines({"trigger.enter zebra", "trigger.enter ape", "trigger.enter mule", "trigger.stay zebra",
                     "trigger.stay ape", "trigger.stay mule", "trigger.exit zebra", "trigger.exit ape",
                     "trigger.exit mule", "avatar.arrive goal"}));
}

// ---- staying --------------------------------------------------------------------------------------------

/// The `ticks` of the stay events while the avatar crosses a volume in 69 ticks, beginning with the enter's.
std::vector<std::int64_t> stays(double stay_every) {
    scene::Campus campus = level_campus();
    add_box(campus, "door", {-1, 0, -3.5}, {1, 2, -2.5}, kTrigger);
    Walk walk = walk_of({spawn_at({0, 0, 0}), walk_to(0, -8)});
    walk.sim.stay_every = stay_every;
    const RecordedRun result = run(campus, walk);
    const Tick enter = result.recorder.events("trigger.enter")[0].tick;
    std::vector<std::int64_t> ticks;
    for (const Event& event : result.recorder.events("trigger.stay")) {
        ticks.push_back(field<std::int64_t>(event, "ticks"));
        EXPECT_EQ(event.tick - enter, ticks.back());
        EXPECT_FALSE(has_field(event, "at"));
        EXPECT_FALSE(has_field(event, "cause"));
    }
    return ticks;
}

TEST(Triggers, LogAStayOncePerSecond) {
    EXPECT_EQ(after(3.5 + kRadius + kLeaveSlack).tick - after(2.5 - kRadius).tick, 68);
    EXPECT_EQ(stays(1.0), std::vector<std::int64_t>({60}));
}

TEST(Triggers, LogStaysAtTheConfiguredInterval) {
    EXPECT_EQ(stays(0.25), std::vector<std::int64_t>({15, 30, 45, 60}));
    EXPECT_EQ(stays(2.0), std::vector<std::int64_t>());
    EXPECT_EQ(stays(0.024), stays(0.0)) << "1.44 ticks are rounded to one";
    EXPECT_EQ(stays(0.026), stays(2.0 / 60.0)) << "1.56 to two";
}

TEST(Triggers, LogAStayEveryTickIfConfiguredTo) {
    const std::vector<std::int64_t> ticks = stays(0.0);
    ASSERT_EQ(ticks.size(), 67U);
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        EXPECT_EQ(ticks[i], static_cast<std::int64_t>(i) + 1);
    }
}

// ---- enters and exits by other causes than walking -----------------------------------------------------

scene::Campus two_rooms() {
    scene::Campus campus = level_campus();
    add_box(campus, "a", {-1, 0, -1}, {1, 2, 1}, kTrigger);
    add_box(campus, "b", {9, 0, -1}, {11, 2, 1}, kTrigger);
    return campus;
}

TEST(Triggers, LogSpawnAndEndAsTheCause) {
    const RecordedRun result = run(two_rooms(), walk_of({spawn_at({0, 0, 0}), wait_for(0.5)}));
    const auto enter = result.recorder.events("trigger.enter a");
    const auto exit = result.recorder.events("trigger.exit a");
    ASSERT_EQ(enter.size(), 1U);
    ASSERT_EQ(exit.size(), 1U);
    EXPECT_EQ(enter[0].tick, 0);
    EXPECT_EQ(enter[0].at, 1.0);
    EXPECT_EQ(field<std::string>(enter[0], "cause"), "spawn");
    EXPECT_FALSE(has_field(enter[0], "at"));
    EXPECT_EQ(exit[0].tick, 30);
    EXPECT_EQ(field<std::string>(exit[0], "cause"), "end");
    EXPECT_EQ(field<std::int64_t>(exit[0], "ticks"), 30);
    EXPECT_FALSE(has_field(exit[0], "at"));
}

TEST(Triggers, AreLeftAtTheOldPlaceAndEnteredAtTheNewOneOnATeleport) {
    const RecordedRun result =
        run(two_rooms(), walk_of({spawn_at({0, 0, 0}), walk_to(0, -0.5), teleport_to({10, 0, 0}, 0.0, "yard"),
                                  wait_for(0.1)}));
    EXPECT_EQ(result.recorder.event_lines(),
              Lines({"trigger.enter a", "avatar.arrive goal", "trigger.exit a", "avatar.teleport yard",
                     "trigger.enter b", "trigger.exit b"}));
    const Event exit = result.recorder.events("trigger.exit a")[0];
    const Event teleport = result.recorder.events("avatar.teleport")[0];
    const Event enter = result.recorder.events("trigger.enter b")[0];
    EXPECT_EQ(exit.tick, teleport.tick);
    EXPECT_EQ(enter.tick, teleport.tick);
    EXPECT_EQ(field<std::string>(exit, "cause"), "teleport");
    EXPECT_EQ(field<std::string>(enter, "cause"), "teleport");
    EXPECT_NEAR((field<Vector3d>(exit, "pos") - result.recorder.at(exit.tick - 1).position).norm(), 0, 1e-12);
    EXPECT_NEAR(field<Vector3d>(exit, "pos").x(), 0.0, 1e-12);
    EXPECT_NEAR(field<Vector3d>(enter, "pos").x(), 10.0, 1e-12);
}

TEST(Triggers, AreLeftAndReenteredByATeleportWithinOne) {
    const RecordedRun result =
        run(two_rooms(), walk_of({spawn_at({0, 0, 0}), wait_for(0.1), teleport_to({0.5, 0, 0})}));
    EXPECT_EQ(result.recorder.event_lines(),
              Lines({"trigger.enter a", "trigger.exit a", "avatar.teleport elsewhere", "trigger.enter a",
                     "trigger.exit a"}));
}

TEST(Triggers, LogALaterSpawnAsTheCause) {
    const RecordedRun result =
        run(two_rooms(),
            walk_of({spawn_at({0, 0, 0}), wait_for(0.1), spawn_at({10, 0, 0}, 0.0, "yard"), wait_for(0.1)}));
    EXPECT_EQ(result.recorder.event_lines(), Lines({"trigger.enter a", "trigger.exit a", "avatar.spawn yard",
                                                    "trigger.enter b", "trigger.exit b"}));
    EXPECT_EQ(field<std::string>(result.recorder.events("trigger.exit a")[0], "cause"), "spawn");
    EXPECT_EQ(field<std::string>(result.recorder.events("trigger.enter b")[0], "cause"), "spawn");
}

TEST(Triggers, AreNotLeftWithinAMillimetre) {
    scene::Campus campus = level_campus();
    add_box(campus, "door", {-1, 0, -2}, {1, 2, -kRadius}, kTrigger);  // touched at z = 0
    const auto creep = [](double z) {
        WalkToStep step = walk_to(0, z);
        step.speed = 0.06;  // a millimetre per tick
        step.within = 1e-9;
        return step;
    };
    const RecordedRun result =
        run(campus, walk_of({spawn_at({0, 0, 0.0006}), creep(-0.0003), creep(0.0006), creep(0.0009),
                             creep(0.0012), creep(0.0006), wait_for(0.1)}));
    const auto enters = result.recorder.events("trigger.enter");
    const auto exits = result.recorder.events("trigger.exit");
    ASSERT_EQ(enters.size(), 1U);
    ASSERT_EQ(exits.size(), 1U);
    expect_time(enters[0], {1, 0.6 / 0.9});
    expect_time(exits[0], {4, 0.1 / 0.3});
}

TEST(Triggers, AreNotTouchedInIgnoredLayers) {
    scene::Campus campus = level_campus();
    add_box(campus, "a", {-1, 0, -3.5}, {1, 2, -2.5}, {Detection::trigger, "", true, "water"});
    add_box(campus, "b", {-1, 0, -3.5}, {1, 2, -2.5}, {Detection::trigger, "", true, "sand"});
    Walk walk = walk_of({spawn_at({0, 0, 0}), walk_to(0, -8)});
    walk.avatar.ignore_layers = {"water"};
    const RecordedRun result = run(campus, walk);
    EXPECT_TRUE(result.recorder.events("* a").empty());
    EXPECT_EQ(result.recorder.events("trigger.enter b").size(), 1U);
}

}  // namespace
}  // namespace campuswalk::engine

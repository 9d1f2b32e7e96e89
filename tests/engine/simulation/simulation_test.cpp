#include "engine/simulation/simulation.h"

#include <cmath>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/script/avatar_body.h"
#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"
#include "tests/support/angles.h"

namespace campuswalk::engine {
namespace {

using Eigen::Vector3d;
using support::radians;
using testing::AllOf;
using testing::HasSubstr;
using Lines = std::vector<std::string>;

TEST(Simulation, BeginsWithTheSpawn) {
    const scene::Campus campus = level_campus();
    const Walk walk = walk_of({spawn_at({3, 0, -4}, radians(90)), wait_for(1.0)});
    Simulation simulation(campus, walk);
    EXPECT_FALSE(simulation.finished());
    const TickRecord& record = simulation.step();
    EXPECT_EQ(record.tick, 0);
    EXPECT_EQ(record.time, 0.0);
    EXPECT_NEAR((record.avatar.position - Vector3d(3, 0, -4)).norm(), 0.0, 1e-3);
    EXPECT_NEAR(record.avatar.yaw, radians(90), 1e-15);
    EXPECT_TRUE(record.avatar.grounded);
    ASSERT_EQ(record.events.size(), 1U);
    EXPECT_EQ(event_line(record.events[0]), "walk.start stroll");
    EXPECT_EQ(field<Vector3d>(record.events[0], "pos"), record.avatar.position);
    EXPECT_NEAR(field<Decimal>(record.events[0], "yaw").value, 90.0, 1e-12);
    EXPECT_EQ(field<Decimal>(record.events[0], "yaw").digits, 1);
}

TEST(Simulation, FindsGroundAndRoomForTheSpawn) {
    const auto foot_of = [](double y) {
        scene::Campus campus = level_campus();
        add_box(campus, "table", {-6, 0, -2}, {-4, 0.4, 2});
        return run(campus, walk_of({spawn_at({-5, y, 0})})).recorder.at(0).position.y();
    };
    EXPECT_NEAR(foot_of(0.4), 0.4, 1e-3);
    EXPECT_NEAR(foot_of(0.0), 0.4, 1e-3) << "up onto the table";
    EXPECT_NEAR(foot_of(0.9), 0.4, 1e-3) << "down onto it";
    EXPECT_NEAR(foot_of(1.3), 0.4, 1e-3) << "by at most a metre";
    EXPECT_NEAR(foot_of(1.5), 1.5, 1e-12) << "left in the air";
}

TEST(Simulation, RunsUntilTheScriptEnds) {
    const scene::Campus campus = level_campus();
    const Walk walk = walk_of({spawn_at({0, 0, 0}), wait_for(0.5)});
    Simulation simulation(campus, walk);
    int ticks = 0;
    while (!simulation.finished()) {
        EXPECT_EQ(simulation.step().tick, ticks);
        ++ticks;
    }
    EXPECT_EQ(ticks, 1 + 30);
    EXPECT_FALSE(simulation.stop());
    EXPECT_EQ(simulation.distance(), 0.0);
}

TEST(Simulation, MeasuresTheDistanceWalked) {
    const RecordedRun result =
        run(level_campus(),
            walk_of({spawn_at({0, 0, 0}), walk_to(0, -10), teleport_to({40, 0, 40}), walk_to(43, 44)}));
    // 9.95 m and 4.95 m, each to the end of its tick; the teleport doesn't count.
    const double step = 1.4 / 60.0;
    EXPECT_NEAR(result.summary.distance, (std::ceil(9.95 / step) + std::ceil(4.95 / step)) * step, 1e-6);
}

TEST(Simulation, TurnsTheAvatarInItsWalkingDirection) {
    const RecordedRun result = run(level_campus(), walk_of({spawn_at({0, 0, 0}), walk_to(-10, 10)}));
    EXPECT_NEAR(result.recorder.states().back().avatar.yaw, radians(135), 1e-9);
}

TEST(Simulation, HashesEveryTick) {
    const scene::Campus campus = level_campus();
    const Walk walk = walk_of({spawn_at({0, 0, 0}), wait_for(0.5)});
    Simulation simulation(campus, walk);
    std::set<std::uint64_t> seen = {simulation.hash()};
    for (std::size_t i = 0; !simulation.finished(); ++i) {
        simulation.step();
        seen.insert(simulation.hash());
        ASSERT_EQ(seen.size(), i + 2) << "the avatar stands still, but time goes on";
    }
}

TEST(Simulation, CountsItsQueries) {
    scene::Campus campus = level_campus();
    add_box(campus, "wall", {-5, 0, -4}, {5, 3, -3});
    const WalkSummary summary = run(campus, walk_of({spawn_at({0, 0, 0}), walk_to(0, -2)})).summary;
    EXPECT_GT(summary.statistics.primitive_tests, 0U);
}

// ---- how steps end --------------------------------------------------------------------------------------

TEST(Simulation, LogsArrivals) {
    const RecordedRun result =
        run(level_campus(), walk_of({spawn_at({0, 0, 0}), walk_to(0, -1.4, "square")}));
    const auto arrives = result.recorder.events("avatar.arrive square");
    ASSERT_EQ(arrives.size(), 1U);
    EXPECT_EQ(arrives[0].tick, 58) << "1.35 m at 1.4 m/s take 57.9 ticks";
    EXPECT_NEAR(field<Vector3d>(arrives[0], "pos").z(), -58 * 1.4 / 60, 1e-9);
    EXPECT_TRUE(result.summary.passed);
}

TEST(Simulation, StopsWhenBlocked) {
    WalkToStep step = walk_to(0, -10, "square");
    step.mark = {"a.walk.yaml", 7, 5};
    const RecordedRun result =
        run(walled_campus(), walk_of({spawn_at({0, 0, 0}), step, walk_to(0, 5, "home"), snapshot("never")}));
    EXPECT_EQ(result.recorder.event_lines(),
              Lines({"collision.enter wall", "avatar.stuck stroll", "collision.stay wall",
                     "avatar.blocked square", "collision.exit wall", "expect.fail blocked"}));
    EXPECT_EQ(field<std::string>(result.recorder.events("collision.exit")[0], "cause"), "end");
    EXPECT_FALSE(result.summary.passed);
    ASSERT_EQ(result.summary.failures.size(), 1U);
    EXPECT_EQ(result.summary.failures[0].code, "blocked");
    EXPECT_THAT(result.summary.failures[0].message, AllOf(HasSubstr("square"), HasSubstr("wall")));
    EXPECT_EQ(result.summary.failures[0].mark.line, 7);
}

TEST(Simulation, ContinuesWhenBlockedIfConfiguredTo) {
    WalkToStep step = walk_to(0, -10, "square");
    step.if_blocked = IfBlocked::proceed;
    const RecordedRun result =
        run(walled_campus(), walk_of({spawn_at({0, 0, 0}), step, walk_to(0, 5, "home")}));
    EXPECT_EQ(result.recorder.event_lines(),
              Lines({"collision.enter wall", "avatar.stuck stroll", "collision.stay wall",
                     "avatar.blocked square", "collision.exit wall", "avatar.arrive home"}));
    EXPECT_TRUE(result.summary.passed);
    EXPECT_FALSE(has_field(result.recorder.events("collision.exit")[0], "cause"));
}

TEST(Simulation, NamesTheNearestOfSeveralObstacles) {
    for (const bool post_first : {true, false}) {
        scene::Campus campus = level_campus();
        const auto add_post = [&] { add_box(campus, "post", {0.34, 0, -4}, {1, 3, 0}); };
        if (post_first) {
            add_post();
        }
        add_box(campus, "wall", {-5, 0, -4}, {5, 3, -3});
        if (!post_first) {
            add_post();
        }
        const RecordedRun result = run(campus, walk_of({spawn_at({0, 0, -1}), walk_to(0, -10)}));
        const auto blocked = result.recorder.events("avatar.blocked");
        ASSERT_EQ(blocked.size(), 1U);
        EXPECT_EQ(field<std::string>(blocked[0], "by"), "wall") << "2 cm away; the post is 4 cm away";
    }
}

TEST(Simulation, StopsAtATimeoutWithoutAnObstacle) {
    WalkToStep step = walk_to(0, -10, "square");
    step.timeout = 2.0;
    const RecordedRun result = run(level_campus(), walk_of({spawn_at({0, 0, 0}), step}));
    const auto blocked = result.recorder.events("avatar.blocked square");
    ASSERT_EQ(blocked.size(), 1U);
    EXPECT_NEAR(static_cast<double>(blocked[0].tick), 120, 1);
    EXPECT_FALSE(has_field(blocked[0], "by"));
    ASSERT_EQ(result.summary.failures.size(), 1U);
    // 1.4 m/s for 121 ticks, the spawn's included.
    EXPECT_THAT(result.summary.failures[0].message,
                AllOf(HasSubstr("square"), HasSubstr("2.0 s"), HasSubstr(" 7.2")));
}

TEST(Simulation, ReportsATargetOnAnotherLevel) {
    WalkToStep step = walk_to(0, -2, "roof");
    step.target.point.y() = 0.75;
    step.target.has_height = true;
    const RecordedRun result = run(level_campus(), walk_of({spawn_at({0, 0, 0}), step}));
    ASSERT_EQ(result.summary.failures.size(), 1U);
    EXPECT_THAT(result.summary.failures[0].message, AllOf(HasSubstr("roof"), HasSubstr("0.750 m above")));
}

TEST(Simulation, LogsSnapshotsAndPassesThemToObservers) {
    const RecordedRun result = run(
        level_campus(),
        walk_of({spawn_at({0, 0, 0}), snapshot("gate"), snapshot("map"), walk_to(0, -1.4), snapshot("end")}));
    EXPECT_EQ(result.recorder.event_lines(),
              Lines({"snapshot.take gate", "snapshot.take map", "avatar.arrive goal", "snapshot.take end"}));
    EXPECT_EQ(result.recorder.states()[0].snapshots, Lines({"gate", "map"}));
    EXPECT_EQ(result.recorder.states()[58].snapshots, Lines({"end"}));
    EXPECT_EQ(result.recorder.states().back().snapshots, Lines()) << "not again with the closing events";
    const Event end = result.recorder.events("snapshot.take end")[0];
    EXPECT_EQ(field<Vector3d>(end, "pos"), result.recorder.at(58).position);
}

TEST(Simulation, LogsTeleports) {
    const RecordedRun result =
        run(level_campus(),
            walk_of({spawn_at({0, 0, 0}), wait_for(0.5), teleport_to({5, 0, 6}, radians(-45), "yard")}));
    const auto teleports = result.recorder.events("avatar.teleport yard");
    ASSERT_EQ(teleports.size(), 1U);
    EXPECT_EQ(teleports[0].tick, 31);
    EXPECT_NEAR((field<Vector3d>(teleports[0], "pos") - Vector3d(5, 0, 6)).norm(), 0.0, 1e-3);
    EXPECT_NEAR(field<Decimal>(teleports[0], "yaw").value, -45.0, 1e-12);
    EXPECT_TRUE(result.recorder.events("avatar.spawn").empty());
}

// ---- the avatar and the collision layer -----------------------------------------------------------------

TEST(MoverSettings, AreTakenFromTheProfile) {
    AvatarProfile avatar;
    avatar.height = 1.2;
    avatar.radius = 0.25;
    avatar.step_height = 0.2;
    avatar.skin_width = 0.03;
    avatar.max_slope = radians(60);
    const collision::MoverSettings settings = mover_settings(avatar);
    EXPECT_EQ(settings.height, 1.2);
    EXPECT_EQ(settings.radius, 0.25);
    EXPECT_EQ(settings.step_height, 0.2);
    EXPECT_EQ(settings.skin, 0.03);
    EXPECT_NEAR(settings.min_up, 0.5, 1e-15);
    EXPECT_EQ(settings.gravity, 9.81);
}

TEST(IgnoredLayers, AreBitsOfTheCampusLayers) {
    scene::Campus campus = empty_campus();
    campus.description.layers = {"ground", "trees", "water"};
    AvatarProfile avatar;
    EXPECT_EQ(ignored_layers(campus, avatar), 0U);
    avatar.ignore_layers = {"water"};
    EXPECT_EQ(ignored_layers(campus, avatar), 8U) << "bit 0 is for objects without a layer";
    avatar.ignore_layers = {"water", "ground"};
    EXPECT_EQ(ignored_layers(campus, avatar), 10U);
}

}  // namespace
}  // namespace campuswalk::engine

#include "config/loader/walk/read_steps.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/config/steps_fixture.h"
#include "tests/support/angles.h"
#include "tests/support/says.h"

namespace campuswalk::config {
namespace {

using namespace engine;
using Eigen::Vector3d;
using support::radians;
using support::says;
using testing::ElementsAre;

class ReadSteps : public test::StepsFixture {};

TEST_F(ReadSteps, ReadsSpawnsAndTeleports) {
    const auto steps = read(
        "  - spawn: gate\n  - teleport: gate\n  - teleport: {at: [1, 2, 3]}\n"
        "  - teleport: {at: [1, 2, 3], yaw_deg: 180}\n"
        "  - teleport: square\n  - teleport: {at: square, yaw_deg: 180}\n");
    const auto& spawn = std::get<SpawnStep>(steps.at(0));
    EXPECT_EQ(spawn.label, "gate");
    EXPECT_EQ(spawn.position, Vector3d(1, 0, 5));
    EXPECT_NEAR(spawn.yaw, radians(90), 1e-15);
    EXPECT_EQ(spawn.mark.line, 3);
    EXPECT_EQ(spawn.mark.column, 12);
    EXPECT_EQ(std::get<TeleportStep>(steps.at(1)).label, "gate");
    EXPECT_NEAR(std::get<TeleportStep>(steps.at(1)).yaw.value(), radians(90), 1e-15);
    EXPECT_EQ(std::get<TeleportStep>(steps.at(2)).label, "1,2,3");
    EXPECT_EQ(std::get<TeleportStep>(steps.at(2)).position, Vector3d(1, 2, 3));
    EXPECT_FALSE(std::get<TeleportStep>(steps.at(2)).yaw);
    EXPECT_NEAR(std::get<TeleportStep>(steps.at(3)).yaw.value(), radians(180), 1e-15);
    EXPECT_EQ(std::get<TeleportStep>(steps.at(4)).label, "square");
    EXPECT_TRUE(std::get<TeleportStep>(steps.at(4)).place);
    EXPECT_FALSE(std::get<TeleportStep>(steps.at(4)).yaw) << "the avatar looks where it did";
    EXPECT_NEAR(std::get<TeleportStep>(steps.at(5)).yaw.value(), radians(180), 1e-15);
}

TEST_F(ReadSteps, SpawnsAtCoordinates) {
    const auto steps = read("  - spawn: {at: [1.5, 0, -2], yaw_deg: -90}\n");
    const auto& spawn = std::get<SpawnStep>(steps.at(0));
    EXPECT_EQ(spawn.label, "1.5,0,-2");
    EXPECT_EQ(spawn.position, Vector3d(1.5, 0, -2));
    EXPECT_NEAR(spawn.yaw, radians(-90), 1e-15);
}

TEST_F(ReadSteps, ReadsGoTo) {
    const auto steps = read(
        "  - spawn: gate\n"
        "  - go_to: square\n"
        "  - go_to: {to: [4, 5], through: [square, [1, 2]], avoid: [\"bench/*\", {center: gate, radius: "
        "2}],\n"
        "            prefer: wide, within: 0.5, timeout: 30, speed: 2}\n"
        "  - go_to: {to: square, avoid: fountain}\n"
        "  - go_to: {to: square, avoid: {center: [3, 4], radius: 1}}\n");
    const auto& square = std::get<GoToStep>(steps.at(1));
    EXPECT_EQ(square.target.label, "square");
    EXPECT_TRUE(square.through.empty());
    EXPECT_TRUE(square.avoid.empty());
    EXPECT_EQ(square.within, 0.05);
    const auto& full = std::get<GoToStep>(steps.at(2));
    EXPECT_EQ(full.target.label, "4,5");
    ASSERT_EQ(full.through.size(), 2U);
    EXPECT_EQ(full.through[0].label, "square");
    EXPECT_EQ(full.through[1].label, "1,2");
    ASSERT_EQ(full.avoid.size(), 2U);
    EXPECT_EQ(full.avoid[0].objects->glob, "bench/*");
    EXPECT_EQ(full.avoid[1].center.point, Vector3d(1, 0, 5));
    EXPECT_EQ(full.avoid[1].radius, 2.0);
    EXPECT_EQ(full.prefer, RoutePreference::wide);
    EXPECT_EQ(square.prefer, RoutePreference::shortest);
    EXPECT_EQ(full.within, 0.5);
    EXPECT_EQ(full.timeout, 30.0);
    EXPECT_EQ(full.speed, 2.0);
    EXPECT_EQ(std::get<GoToStep>(steps.at(3)).avoid.at(0).objects->glob, "fountain");
    EXPECT_EQ(std::get<GoToStep>(steps.at(4)).avoid.at(0).center.point, Vector3d(3, 0, 4));
}

TEST_F(ReadSteps, ReadsWalkTo) {
    const auto steps = read(
        "  - spawn: gate\n"
        "  - walk_to: square\n"
        "  - walk_to: gate\n"
        "  - walk_to: [4, 5]\n"
        "  - walk_to: [4, 5, 6]\n"
        "  - walk_to: {to: square, within: 0.5, timeout: 30, speed: 2, if_blocked: continue}\n");
    const auto& square = std::get<WalkToStep>(steps.at(1));
    EXPECT_EQ(square.target.label, "square");
    EXPECT_EQ(square.target.point, Vector3d(2, 0, -3));
    EXPECT_TRUE(square.target.has_height);
    EXPECT_EQ(square.within, 0.05);
    EXPECT_FALSE(square.timeout);
    EXPECT_FALSE(square.speed);
    EXPECT_EQ(square.if_blocked, IfBlocked::fail);
    EXPECT_EQ(std::get<WalkToStep>(steps.at(2)).target.point, Vector3d(1, 0, 5));
    const auto& flat = std::get<WalkToStep>(steps.at(3)).target;
    EXPECT_EQ(flat.label, "4,5");
    EXPECT_EQ(flat.point.x(), 4.0);
    EXPECT_EQ(flat.point.z(), 5.0);
    EXPECT_FALSE(flat.has_height);
    EXPECT_EQ(std::get<WalkToStep>(steps.at(4)).target.point, Vector3d(4, 5, 6));
    EXPECT_TRUE(std::get<WalkToStep>(steps.at(4)).target.has_height);
    const auto& full = std::get<WalkToStep>(steps.at(5));
    EXPECT_EQ(full.target.label, "square");
    EXPECT_EQ(full.within, 0.5);
    EXPECT_EQ(full.timeout, 30.0);
    EXPECT_EQ(full.speed, 2.0);
    EXPECT_EQ(full.if_blocked, IfBlocked::proceed);
    EXPECT_EQ(full.mark.line, 8);
}

TEST_F(ReadSteps, ReadsWaitTurnLookAtAndSnapshot) {
    const auto steps = read(
        "  - spawn: gate\n"
        "  - wait: 2.5\n"
        "  - turn: -90\n"
        "  - turn: {to_deg: 180}\n"
        "  - look_at: square\n"
        "  - look_at: [1, 2]\n"
        "  - snapshot: view-1\n"
        "  - look_at: hut\n");
    EXPECT_EQ(std::get<WaitStep>(steps.at(1)).seconds, 2.5);
    EXPECT_NEAR(std::get<TurnStep>(steps.at(2)).angle, radians(-90), 1e-15);
    EXPECT_FALSE(std::get<TurnStep>(steps.at(2)).absolute);
    EXPECT_NEAR(std::get<TurnStep>(steps.at(3)).angle, radians(180), 1e-15);
    EXPECT_TRUE(std::get<TurnStep>(steps.at(3)).absolute);
    EXPECT_EQ(std::get<LookAtStep>(steps.at(4)).target.point, Vector3d(2, 0, -3));
    EXPECT_FALSE(std::get<LookAtStep>(steps.at(5)).target.has_height);
    EXPECT_EQ(std::get<SnapshotStep>(steps.at(6)).name, "view-1");
    EXPECT_FALSE(std::get<LookAtStep>(steps.at(4)).building);
    EXPECT_EQ(std::get<LookAtStep>(steps.at(7)).building, 0U);
}

TEST_F(ReadSteps, RequiresASpawnFirstAndOnlyThere) {
    EXPECT_THAT(folder_.about_steps("  - wait: 1\n  - spawn: gate\n"),
                ElementsAre(says("a.walk.yaml:3:5: error bad-value", {"'spawn'"}),
                            says("a.walk.yaml:4:12: error bad-value", {"'spawn'"})));
    EXPECT_THAT(folder_.about_steps("  []\n"),
                ElementsAre(says("a.walk.yaml:3:3: error bad-value", {"'steps'"})));
    EXPECT_THAT(folder_.about_steps("  spawn: gate\n"),
                ElementsAre(says("a.walk.yaml:3:3: error wrong-type", {"'steps'"})));
}

TEST_F(ReadSteps, RequiresOneKeyPerStep) {
    EXPECT_THAT(folder_.about_steps("  - spawn: gate\n    wait: 1\n"),
                ElementsAre(says("a.walk.yaml:3:5: error bad-value", {"'wait'"})));
    EXPECT_THAT(
        folder_.about_steps("  - spawn: gate\n  - {}\n  -\n  - wait\n  - wiat: 1\n  - fly: 2\n"),
        ElementsAre(says("a.walk.yaml:4:5: error bad-value"), says("a.walk.yaml:5:3: error wrong-type"),
                    says("a.walk.yaml:6:5: error wrong-type"),
                    says("a.walk.yaml:7:5: error unknown-key", {"'wiat'", "'wait'"}),
                    says("a.walk.yaml:8:5: error unknown-key", {"'fly'"})));
}

TEST_F(ReadSteps, DiagnosesTargets) {
    EXPECT_THAT(about("walk_to: sqare"),
                ElementsAre(says("a.walk.yaml:4:14: error unknown-name", {"'sqare'", "'square'"})));
    EXPECT_THAT(about("look_at: shed"),
                ElementsAre(says("a.walk.yaml:4:14: error unknown-name", {"'shed'"})));
    EXPECT_THAT(about("walk_to: [1]"),
                ElementsAre(says("a.walk.yaml:4:14: error wrong-type", {"'walk_to'"})));
    EXPECT_THAT(about("walk_to:"), ElementsAre(says("a.walk.yaml:4:5: error wrong-type", {"'walk_to'"})));
    EXPECT_THAT(about("look_at: {x: 1}"),
                ElementsAre(says("a.walk.yaml:4:14: error wrong-type", {"'look_at'"})));
    EXPECT_THAT(about("walk_to: [1, b]"), ElementsAre(says("a.walk.yaml:4:18: error wrong-type", {"'b'"})));
}

TEST_F(ReadSteps, DiagnosesWalkTo) {
    EXPECT_THAT(about("walk_to: {}"),
                ElementsAre(says("a.walk.yaml:4:14: error missing-key", {"'walk_to'", "'to'"})));
    EXPECT_THAT(about("walk_to: {to: square, witin: 1, timeout: 0, speed: 0, if_blocked: go}"),
                ElementsAre(says("a.walk.yaml:4:27: error unknown-key", {"'witin'", "'walk_to'", "'within'"}),
                            says("a.walk.yaml:4:46: error bad-value", {"'timeout'", "'0'"}),
                            says("a.walk.yaml:4:56: error bad-value", {"'speed'", "'0'"}),
                            says("a.walk.yaml:4:71: error bad-value", {"'if_blocked'", "'go'"})));
}

TEST_F(ReadSteps, DiagnosesSpawnsAndTeleports) {
    EXPECT_THAT(about("teleport: sqare"),
                ElementsAre(says("a.walk.yaml:4:15: error unknown-name", {"'sqare'", "'square'"})));
    EXPECT_THAT(about("teleport: {at: gate, fall: true}"),
                ElementsAre(says("a.walk.yaml:4:26: error unknown-key", {"'fall'"})));
    EXPECT_THAT(about("teleport: [1, 2, 3]"),
                ElementsAre(says("a.walk.yaml:4:15: error wrong-type", {"'teleport'"})));
    EXPECT_THAT(about("teleport: {yaw_deg: 3}"),
                ElementsAre(says("a.walk.yaml:4:15: error missing-key", {"'teleport'"})));
    EXPECT_THAT(folder_.about_steps("  - spawn: gaet\n"),
                ElementsAre(says("a.walk.yaml:3:12: error unknown-name", {"'gaet'", "'gate'"})));
}

TEST_F(ReadSteps, DiagnosesNumbersAndSnapshots) {
    EXPECT_THAT(about("wait: -1"),
                ElementsAre(says("a.walk.yaml:4:11: error bad-value", {"'wait'", "'-1'"})));
    EXPECT_THAT(about("wait: [1]"), ElementsAre(says("a.walk.yaml:4:11: error wrong-type", {"'wait'"})));
    EXPECT_THAT(about("turn: left"),
                ElementsAre(says("a.walk.yaml:4:11: error wrong-type", {"'turn'", "'left'"})));
    EXPECT_THAT(about("turn: {to: 3}"),
                ElementsAre(says("a.walk.yaml:4:11: error missing-key", {"'turn'"}),
                            says("a.walk.yaml:4:12: error unknown-key", {"'to'", "'turn'"})));
    EXPECT_THAT(about("snapshot: a\n  - snapshot: a"),
                ElementsAre(says("a.walk.yaml:5:15: error duplicate-name", {"'a'"})));
    EXPECT_THAT(about("snapshot: {name: ../x}"),
                ElementsAre(says("a.walk.yaml:4:22: error bad-value", {"'name'", "'../x'"})));
    EXPECT_THAT(about("snapshot: {view: top}"),
                ElementsAre(says("a.walk.yaml:4:15: error missing-key", {"'snapshot'", "'name'"})));
}

// ---- the body -------------------------------------------------------------------------------------------

TEST_F(ReadSteps, ReadsFollow) {
    const auto steps = read(
        "  - spawn: gate\n"
        "  - follow: [square, [4, 5], [6, 1, 7]]\n"
        "  - follow: {through: [gate], within: 0.3, timeout: 9, speed: 2, if_blocked: continue}\n");
    const auto& plain = std::get<FollowStep>(steps.at(1));
    ASSERT_EQ(plain.points.size(), 3U);
    EXPECT_EQ(plain.points[0].label, "square");
    EXPECT_EQ(plain.points[0].point, Vector3d(2, 0, -3));
    EXPECT_FALSE(plain.points[1].has_height);
    EXPECT_EQ(plain.points[2].point, Vector3d(6, 1, 7));
    EXPECT_EQ(plain.within, 0.05);
    EXPECT_EQ(plain.mark.line, 4);
    const auto& full = std::get<FollowStep>(steps.at(2));
    EXPECT_EQ(full.points.at(0).label, "gate");
    EXPECT_EQ(full.within, 0.3);
    EXPECT_EQ(full.timeout, 9.0);
    EXPECT_EQ(full.speed, 2.0);
    EXPECT_EQ(full.if_blocked, IfBlocked::proceed);
}

TEST_F(ReadSteps, DiagnosesFollow) {
    EXPECT_THAT(about("follow: []"), ElementsAre(says("a.walk.yaml:4:13: error bad-value", {"'follow'"})));
    EXPECT_THAT(about("follow: square"),
                ElementsAre(says("a.walk.yaml:4:13: error wrong-type", {"'follow'"})));
    EXPECT_THAT(about("follow: [sqare]"),
                ElementsAre(says("a.walk.yaml:4:14: error unknown-name", {"'sqare'", "'square'"})));
    EXPECT_THAT(about("follow: {within: 1, speed: 0}"),
                ElementsAre(says("a.walk.yaml:4:13: error missing-key", {"'follow'"}),
                            says("a.walk.yaml:4:32: error bad-value", {"'speed'", "'0'"})));
}

TEST_F(ReadSteps, ReadsJumps) {
    const auto steps = read(
        "  - spawn: gate\n  - jump:\n  - jump: 0.2\n  - jump: {height: 1, forward: 2}\n"
        "  - jump: {speed: 3}\n");
    const auto height_of = [&](std::size_t i) {
        const double speed = std::get<JumpStep>(steps.at(i)).speed;
        return speed * speed / (2.0 * 9.81);
    };
    EXPECT_NEAR(height_of(1), 0.4, 1e-12);
    EXPECT_NEAR(height_of(2), 0.2, 1e-12);
    EXPECT_NEAR(height_of(3), 1.0, 1e-12);
    EXPECT_EQ(std::get<JumpStep>(steps.at(3)).forward, 2.0);
    EXPECT_EQ(std::get<JumpStep>(steps.at(4)).speed, 3.0);
    EXPECT_EQ(std::get<JumpStep>(steps.at(4)).forward, 0.0);
}

TEST_F(ReadSteps, DiagnosesJumps) {
    EXPECT_THAT(about("jump: high"),
                ElementsAre(says("a.walk.yaml:4:11: error wrong-type", {"'jump'", "'high'"})));
    EXPECT_THAT(about("jump: 0"), ElementsAre(says("a.walk.yaml:4:11: error bad-value", {"'jump'", "'0'"})));
    EXPECT_THAT(
        about("jump: {height: 1, speed: 2, foward: 1}"),
        ElementsAre(says("a.walk.yaml:4:30: error bad-value", {"'jump'", "'height'", "'speed'"}),
                    says("a.walk.yaml:4:33: error unknown-key", {"'foward'", "'jump'", "'forward'"})));
}

TEST_F(ReadSteps, ReadsCrouchRunAndSpeed) {
    const auto steps = read(
        "  - spawn: gate\n  - crouch: on\n  - crouch: off\n  - crouch: {height: 1}\n  - run: on\n"
        "  - run: off\n  - speed: 0.5\n");
    EXPECT_NEAR(std::get<CrouchStep>(steps.at(1)).height, 0.6 * 1.8, 1e-12);
    EXPECT_EQ(std::get<CrouchStep>(steps.at(2)).height, 1.8);
    EXPECT_EQ(std::get<CrouchStep>(steps.at(3)).height, 1.0);
    EXPECT_NEAR(std::get<SpeedStep>(steps.at(4)).speed, 2.8, 1e-12) << "twice the walking speed";
    EXPECT_EQ(std::get<SpeedStep>(steps.at(5)).speed, 1.4);
    EXPECT_EQ(std::get<SpeedStep>(steps.at(6)).speed, 0.5);
    folder_.write("a.walk.yaml",
                  "campus: a.campus.yaml\navatar: {profile: adult, run_speed: 5}\n"
                  "steps: [{spawn: gate}, {run: on}]\n");
    EXPECT_EQ(std::get<SpeedStep>(folder_.run().walk.steps.at(1)).speed, 5.0);
}

TEST_F(ReadSteps, DiagnosesCrouchRunAndSpeed) {
    EXPECT_THAT(about("crouch: down"),
                ElementsAre(says("a.walk.yaml:4:13: error bad-value", {"'crouch'", "'down'"})));
    EXPECT_THAT(about("crouch: {height: 0.5}"),
                ElementsAre(says("a.walk.yaml:4:22: error bad-value", {"'height'"})));
    EXPECT_THAT(about("run: fast"),
                ElementsAre(says("a.walk.yaml:4:10: error bad-value", {"'run'", "'fast'"})));
    EXPECT_THAT(about("speed: 0"),
                ElementsAre(says("a.walk.yaml:4:12: error bad-value", {"'speed'", "'0'"})));
}

// ---- waiting and changing the campus --------------------------------------------------------------------

TEST_F(ReadSteps, ReadsWaitUntil) {
    const auto steps = read(
        "  - spawn: gate\n  - wait_until: popup.open hut\n"
        "  - wait_until: {event: avatar.landed, timeout: 4}\n");
    const auto& plain = std::get<WaitUntilStep>(steps.at(1));
    EXPECT_EQ(plain.event.kind, "popup.open");
    EXPECT_EQ(plain.event.object, "hut");
    EXPECT_EQ(plain.timeout, 30.0);
    const auto& full = std::get<WaitUntilStep>(steps.at(2));
    EXPECT_EQ(full.event.kind, "avatar.landed");
    EXPECT_EQ(full.event.object, "*");
    EXPECT_EQ(full.timeout, 4.0);
}

TEST_F(ReadSteps, DiagnosesWaitUntil) {
    EXPECT_THAT(about("wait_until: popup.opne"),
                ElementsAre(says("a.walk.yaml:4:17: error unknown-name", {"'popup.opne'", "'popup.open'"})));
    EXPECT_THAT(about("wait_until: {timeout: 0}"),
                ElementsAre(says("a.walk.yaml:4:17: error missing-key", {"'wait_until'"}),
                            says("a.walk.yaml:4:27: error bad-value", {"'timeout'", "'0'"})));
}

TEST_F(ReadSteps, ReadsEnableAndDisable) {
    const auto steps = read("  - spawn: gate\n  - disable: hut/door\n  - enable: [\"hut/*\", ground]\n");
    const auto& off = std::get<EnableStep>(steps.at(1));
    EXPECT_FALSE(off.enabled);
    ASSERT_EQ(off.objects.size(), 1U);
    EXPECT_EQ(off.objects[0].glob, "hut/door");
    const auto& on = std::get<EnableStep>(steps.at(2));
    EXPECT_TRUE(on.enabled);
    ASSERT_EQ(on.objects.size(), 2U);
    EXPECT_EQ(on.objects[1].glob, "ground");
    EXPECT_EQ(on.objects[1].mark.column, 23);
}

TEST_F(ReadSteps, DiagnosesEnableAndDisable) {
    EXPECT_THAT(about("disable: []"), ElementsAre(says("a.walk.yaml:4:14: error bad-value", {"'disable'"})));
    EXPECT_THAT(about("enable: {id: hut}"),
                ElementsAre(says("a.walk.yaml:4:13: error wrong-type", {"'enable'"})));
}

}  // namespace
}  // namespace campuswalk::config

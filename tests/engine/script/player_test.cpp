#include "engine/script/player.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/engine/short_walk.h"
#include "tests/support/angles.h"

namespace campuswalk::engine {
namespace {

using Eigen::Vector3d;
using support::radians;

/// An avatar that moves exactly as the script intends, unless it is `stuck`.
class Puppet {
public:
    explicit Puppet(const Walk& walk) : player(walk) { tick(); }  // the spawn

    void tick() {
        intent = player.intend(avatar);
        if (intent.placement) {
            avatar.position = intent.placement->foot;
            avatar.grounded = true;
        } else if (!stuck) {
            avatar.position += intent.move;
        }
        avatar.yaw = intent.yaw;
        avatar.pitch = intent.pitch;
        effects.clear();
        player.on_events(events);
        end = player.settle(avatar, effects);
        ++ticks;
    }
    /// Plays until a step ends; the number of ticks, or -1 if there is no end within `most`.
    int ticks_until_end(int most = 2000) {
        for (int i = 1; i <= most; ++i) {
            tick();
            if (end || player.finished()) {
                return i;
            }
        }
        return -1;
    }

    ScriptPlayer player;
    AvatarState avatar;
    Intent intent;
    std::vector<Event> events;  ///< of the current tick
    std::vector<const Step*> effects;
    std::optional<StepEnd> end;
    bool stuck = false;
    int ticks = 0;
};

TEST(ScriptPlayer, PlacesTheAvatarInTheFirstTick) {
    const Walk walk = walk_of({spawn_at({1, 2, 3}, radians(-90), "gate"), wait_for(1.0)});
    const Puppet puppet(walk);
    ASSERT_TRUE(puppet.intent.placement);
    EXPECT_EQ(*puppet.intent.placement->label, "gate");
    EXPECT_EQ(puppet.intent.placement->foot, Vector3d(1, 2, 3));
    EXPECT_EQ(puppet.intent.placement->kind, EventKind::avatar_spawn);
    EXPECT_NEAR(puppet.avatar.yaw, radians(-90), 1e-15);
    EXPECT_EQ(puppet.avatar.pitch, 0.0);
    EXPECT_FALSE(puppet.end) << "the end of a spawn is no event";
}

TEST(ScriptPlayer, WalksStraightAtTheAvatarsSpeed) {
    const Walk walk = walk_of({spawn_at({0, 0, 0}), walk_to(3, -4)});
    Puppet puppet(walk);
    puppet.tick();
    // 1.4 m/s for a sixtieth of a second, along (3, -4) / 5.
    EXPECT_NEAR(puppet.intent.move.x(), 0.6 * 1.4 / 60.0, 1e-15);
    EXPECT_EQ(puppet.intent.move.y(), 0.0);
    EXPECT_NEAR(puppet.intent.move.z(), -0.8 * 1.4 / 60.0, 1e-15);
    // 4.95 m are left to walk: 212.1 ticks of 0.02333 m.
    EXPECT_EQ(puppet.ticks_until_end(), 213 - 1);
    EXPECT_EQ(puppet.end->kind, EventKind::avatar_arrive);
    EXPECT_EQ(puppet.end->target->label, "goal");
    EXPECT_FALSE(puppet.end->fatal);
}

TEST(ScriptPlayer, NeverWalksPastItsTarget) {
    WalkToStep step = walk_to(0, -0.05);
    step.within = 0.0;
    const Walk walk = walk_of({spawn_at({0, 0, 0}), step});
    Puppet puppet(walk);
    EXPECT_EQ(puppet.ticks_until_end(), 3);  // 0.0233, 0.0467, 0.05
    EXPECT_NEAR(puppet.avatar.position.z(), -0.05, 1e-15);
    EXPECT_EQ(puppet.end->kind, EventKind::avatar_arrive);
}

TEST(ScriptPlayer, UsesTheStepsOwnSpeed) {
    WalkToStep step = walk_to(0, -10);
    step.speed = 3.0;
    const Walk walk = walk_of({spawn_at({0, 0, 0}), step});
    Puppet puppet(walk);
    puppet.tick();
    EXPECT_NEAR(puppet.intent.move.z(), -3.0 / 60.0, 1e-15);
}

TEST(ScriptPlayer, ArrivesOnlyAtTheTargetsHeightIfItHasOne) {
    WalkToStep step = walk_to(0, -1);
    step.target = {"roof", {0, 5, -1}, true};
    Walk walk = walk_of({spawn_at({0, 0, 0}), step});
    Puppet below(walk);
    ASSERT_GT(below.ticks_until_end(), 0);
    EXPECT_EQ(below.end->kind, EventKind::avatar_blocked) << "it is under the roof, not on it";
    std::get<WalkToStep>(walk.steps[1]).target.point.y() = 0.5;
    Puppet near(walk);
    ASSERT_GT(near.ticks_until_end(), 0);
    EXPECT_EQ(near.end->kind, EventKind::avatar_arrive) << "half a metre is level enough";
}

TEST(ScriptPlayer, GivesUpAfterASecondAndAHalfWithoutProgress) {
    const Walk walk = walk_of({spawn_at({0, 0, 0}), walk_to(0, -10), wait_for(1.0)});
    Puppet puppet(walk);
    puppet.stuck = true;
    EXPECT_EQ(puppet.ticks_until_end(), 1 + 90) << "the last progress is that of the first tick";
    EXPECT_EQ(puppet.end->kind, EventKind::avatar_blocked);
    EXPECT_TRUE(puppet.end->fatal);
}

TEST(ScriptPlayer, ContinuesWhenBlockedIfConfiguredTo) {
    WalkToStep step = walk_to(0, -10);
    step.if_blocked = IfBlocked::proceed;
    const Walk walk = walk_of({spawn_at({0, 0, 0}), step, wait_for(1.0)});
    Puppet puppet(walk);
    puppet.stuck = true;
    puppet.ticks_until_end();
    EXPECT_EQ(puppet.end->kind, EventKind::avatar_blocked);
    EXPECT_FALSE(puppet.end->fatal);
    EXPECT_FALSE(puppet.player.finished());
}

TEST(ScriptPlayer, DoesNotGiveUpOnASlowAvatar) {
    Walk walk = walk_of({spawn_at({0, 0, 0}), walk_to(0, -0.1)});
    walk.avatar.speed = 0.01;
    Puppet puppet(walk);
    // 0.05 m at 0.01 m/s: 5 s at 60 ticks per second, give or take one tick of rounding.
    EXPECT_NEAR(puppet.ticks_until_end(), 300, 1);
    EXPECT_EQ(puppet.end->kind, EventKind::avatar_arrive);
}

TEST(ScriptPlayer, GivesUpAtItsTimeout) {
    WalkToStep step = walk_to(0, -10);
    step.timeout = 2.0;
    const Walk walk = walk_of({spawn_at({0, 0, 0}), step});
    Puppet puppet(walk);
    EXPECT_NEAR(puppet.ticks_until_end(), 120, 1);
    EXPECT_EQ(puppet.end->kind, EventKind::avatar_blocked);
}

TEST(ScriptPlayer, TimesOutAfterTwiceTheStraightTimePlusFiveSecondsByDefault) {
    // A little nearer every tick, but too slow to arrive in time.
    const Walk walk = walk_of({spawn_at({0, 0, 0}), walk_to(0, -1.4)});
    Puppet puppet(walk);
    int ticks = 0;
    do {
        puppet.tick();
        ++ticks;
        puppet.avatar.position.z() = -0.002 * ticks;  // 0.12 m/s
    } while (!puppet.end && ticks < 2000);
    EXPECT_NEAR(ticks, (2.0 * 1.0 + 5.0) * 60, 1);
    EXPECT_EQ(puppet.end->kind, EventKind::avatar_blocked);
}

TEST(ScriptPlayer, TurnsTowardsItsTargetByTheSmallerAngleWhileWalking) {
    const Walk walk = walk_of({spawn_at({0, 0, 0}, radians(170)), walk_to(10, 0)});  // towards -90
    Puppet puppet(walk);
    // 100 degrees through 180, at 3 per tick.
    for (int i = 1; i <= 33; ++i) {
        puppet.tick();
        const double expected = 170.0 + 3.0 * i;
        ASSERT_NEAR(puppet.avatar.yaw, radians(expected > 180.0 ? expected - 360.0 : expected), 1e-12) << i;
    }
    puppet.tick();
    EXPECT_NEAR(puppet.avatar.yaw, radians(-90), 1e-12);
}

TEST(ScriptPlayer, WaitsForTheGivenTime) {
    const Walk walk = walk_of({spawn_at({0, 0, 0}), wait_for(2.0)});
    Puppet puppet(walk);
    EXPECT_EQ(puppet.ticks_until_end(), 120);
    EXPECT_EQ(puppet.avatar.position, Vector3d(0, 0, 0));
    EXPECT_FALSE(puppet.end);
}

TEST(ScriptPlayer, WaitsAWholeNumberOfTicks) {
    Walk walk = walk_of({spawn_at({0, 0, 0}), wait_for(0.101)});
    walk.sim.ticks_per_second = 100;
    Puppet puppet(walk);
    EXPECT_EQ(puppet.ticks_until_end(), 11);
}

// ---- turning --------------------------------------------------------------------------------------------

/// The yaw in degrees after every tick of the second step.
std::vector<double> yaws(double from_deg, const TurnStep& step) {
    const Walk walk = walk_of({spawn_at({0, 0, 0}, radians(from_deg)), step});
    Puppet puppet(walk);
    std::vector<double> seen;
    while (!puppet.player.finished() && seen.size() < 1000) {
        puppet.tick();
        seen.push_back(puppet.avatar.yaw / radians(1.0));
    }
    return seen;
}

void expect_steady(const std::vector<double>& seen, double from, double by, double rate) {
    ASSERT_EQ(static_cast<double>(seen.size()), std::ceil(std::abs(by / rate) - 1e-9));
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const double turned = std::min(rate * static_cast<double>(i + 1), std::abs(by));
        const double expected = from + (by < 0 ? -turned : turned);
        EXPECT_NEAR(std::remainder(seen[i] - expected, 360.0), 0.0, 1e-9) << "tick " << i + 1;
    }
}

TEST(ScriptPlayer, TurnsByAnAngleAtItsTurnSpeed) {
    expect_steady(yaws(0, turn_by(90)), 0, 90, 3);
    expect_steady(yaws(0, turn_by(-91)), 0, -91, 3);
    expect_steady(yaws(150, turn_by(100)), 150, 100, 3);
}

TEST(ScriptPlayer, TurnsByMoreThanHalfATurnInTheGivenDirection) {
    expect_steady(yaws(0, turn_by(270)), 0, 270, 3);
    expect_steady(yaws(10, turn_by(-720)), 10, -720, 3);
}

TEST(ScriptPlayer, TurnsToAnAngleByTheSmallerAngle) {
    expect_steady(yaws(-170, turn_to(170)), -170, -20, 3);
    expect_steady(yaws(170, turn_to(-170)), 170, 20, 3);
    expect_steady(yaws(20, turn_to(380 + 30)), 20, 30, 3);
    expect_steady(yaws(0, turn_to(-90)), 0, -90, 3);
}

TEST(ScriptPlayer, FinishesInOneTickIfThereIsNothingToTurn) {
    EXPECT_EQ(yaws(40, turn_by(0)).size(), 1U);
    EXPECT_EQ(yaws(40, turn_to(40)).size(), 1U);
}

TEST(ScriptPlayer, TurnsAtTheAvatarsTurnSpeed) {
    Walk walk = walk_of({spawn_at({0, 0, 0}), turn_by(90)});
    walk.avatar.turn_speed = radians(45);
    Puppet puppet(walk);
    EXPECT_EQ(puppet.ticks_until_end(), 120);
}

// ---- looking --------------------------------------------------------------------------------------------

AvatarState look(const Target& target, int* ticks = nullptr) {
    const Walk walk = walk_of({spawn_at({1, 0, 2}), look_at(target)});
    Puppet puppet(walk);
    const int taken = puppet.ticks_until_end();
    if (ticks != nullptr) {
        *ticks = taken;
    }
    return puppet.avatar;
}

TEST(ScriptPlayer, LooksAtAPointFromItsEyes) {
    // Eyes at (1, 1.65, 2). Two metres up over two metres away: 45 degrees; to the right: -90.
    const AvatarState up = look({"lamp", {3, 3.65, 2}, true});
    EXPECT_NEAR(up.yaw, radians(-90), 1e-12);
    EXPECT_NEAR(up.pitch, radians(45), 1e-12);
    const AvatarState down = look({"kerb", {1, 0, 2 - 1.65}, true});
    EXPECT_NEAR(down.yaw, 0.0, 1e-12);
    EXPECT_NEAR(down.pitch, radians(-45), 1e-12);
}

TEST(ScriptPlayer, LooksLevelAtAPointWithoutAHeight) {
    const AvatarState level = look({"1,12", {1, 0, 12}, false});
    EXPECT_NEAR(std::abs(level.yaw), std::numbers::pi, 1e-12) << "straight behind";
    EXPECT_EQ(level.pitch, 0.0);
}

TEST(ScriptPlayer, LooksStraightUpWithoutTurning) {
    int ticks = 0;
    const AvatarState up = look({"sky", {1, 50, 2}, true}, &ticks);
    EXPECT_EQ(up.yaw, 0.0);
    EXPECT_NEAR(up.pitch, radians(90), 1e-12);
    EXPECT_EQ(ticks, 30) << "3 degrees per tick";
}

TEST(ScriptPlayer, LevelsItsGazeWhileWalking) {
    const Walk walk = walk_of({spawn_at({0, 0, 0}), look_at({"sky", {0, 50, -20}, true}), walk_to(0, -5)});
    Puppet puppet(walk);
    while (puppet.avatar.position.z() == 0.0) {
        puppet.tick();
    }
    const double pitch = std::atan2(50 - 1.65, 20);
    EXPECT_NEAR(puppet.avatar.pitch, pitch - radians(3), 1e-12);
    puppet.ticks_until_end();
    EXPECT_EQ(puppet.avatar.pitch, 0.0);
}

// ---- placement and snapshots -----------------------------------------------------------------------------

TEST(ScriptPlayer, KeepsItsYawOnATeleportUnlessOneIsGiven) {
    const Walk walk = walk_of({spawn_at({0, 0, 0}, radians(30)), teleport_to({5, 0, 5}),
                               teleport_to({6, 0, 6}, radians(-200), "yard")});
    Puppet puppet(walk);
    puppet.tick();
    ASSERT_TRUE(puppet.intent.placement);
    EXPECT_EQ(puppet.intent.placement->kind, EventKind::avatar_teleport);
    EXPECT_EQ(puppet.avatar.position, Vector3d(5, 0, 5));
    EXPECT_NEAR(puppet.avatar.yaw, radians(30), 1e-12);
    puppet.tick();
    EXPECT_EQ(*puppet.intent.placement->label, "yard");
    EXPECT_NEAR(puppet.avatar.yaw, radians(160), 1e-12);
    EXPECT_TRUE(puppet.player.finished());
}

std::vector<std::string> names_of(const std::vector<const Step*>& effects) {
    std::vector<std::string> names;
    names.reserve(effects.size());
    for (const Step* step : effects) {
        names.push_back(std::get<SnapshotStep>(*step).name);
    }
    return names;
}

using Names = std::vector<std::string>;

TEST(ScriptPlayer, TakesSnapshotsAtTheEndOfTheStepBefore) {
    const Walk walk = walk_of(
        {spawn_at({0, 0, 0}), snapshot("a"), wait_for(0.05), snapshot("b"), snapshot("c"), wait_for(0.05)});
    Puppet puppet(walk);
    EXPECT_EQ(names_of(puppet.effects), Names({"a"}));
    puppet.tick();
    puppet.tick();
    EXPECT_EQ(names_of(puppet.effects), Names());
    puppet.tick();
    EXPECT_EQ(names_of(puppet.effects), Names({"b", "c"}));
    EXPECT_FALSE(puppet.player.finished());
    EXPECT_EQ(puppet.ticks_until_end(), 3);
}

TEST(ScriptPlayer, TakesNoSnapshotAfterAFatalBlock) {
    const Walk walk = walk_of({spawn_at({0, 0, 0}), walk_to(0, -10), snapshot("never")});
    Puppet puppet(walk);
    puppet.stuck = true;
    puppet.ticks_until_end();
    EXPECT_TRUE(puppet.end->fatal);
    EXPECT_EQ(names_of(puppet.effects), Names());
}

TEST(ScriptPlayer, ReportsTheLineOfTheCurrentStep) {
    WaitStep wait = wait_for(0.1);
    wait.mark = {"a.walk.yaml", 5, 3};
    const Walk walk = walk_of({spawn_at({0, 0, 0}), wait});
    Puppet puppet(walk);
    ASSERT_NE(puppet.player.mark(), nullptr);
    EXPECT_EQ(puppet.player.mark()->line, 5);
    puppet.ticks_until_end();
    EXPECT_EQ(puppet.player.mark(), nullptr);
}

/// Finds nothing, for the reason that it was given.
struct NoRoutes final : RoutePlanner {
    PlannedRoute plan(const GoToStep& /*step*/, double /*speed*/) override {
        return {{}, Reason{.kind = incomplete ? ReasonKind::unsearched : ReasonKind::falls_out}};
    }
    bool incomplete = false;
};

TEST(ScriptPlayer, TellsNoRouteFromASearchThatWasCut) {
    GoToStep step;
    step.target.label = "desk";
    const Walk walk = walk_of({spawn_at({0, 0, 0}), step});
    NoRoutes routes;
    const auto end = [&] {
        ScriptPlayer player(walk, &routes);
        std::vector<const Step*> instant;
        player.intend({});
        player.settle({}, instant);  // the spawn
        player.intend({});
        return *player.settle({}, instant);
    };
    EXPECT_EQ(end().code, "unreachable");
    EXPECT_EQ(end().message, "go_to desk can't be reached");
    EXPECT_EQ(end().reason->kind, ReasonKind::falls_out);
    routes.incomplete = true;
    EXPECT_EQ(end().code, kRouteUnknown);
    EXPECT_TRUE(end().fatal);
    EXPECT_EQ(end().message, "go_to desk: it isn't known whether a route leads there");
    EXPECT_EQ(end().reason->kind, ReasonKind::unsearched);
}

}  // namespace
}  // namespace campuswalk::engine

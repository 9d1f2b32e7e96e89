#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/simulation/check_walk.h"
#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"

namespace campuswalk::engine {
namespace {

GoToStep go_to(double x, double z, std::optional<double> y = {}) {
    GoToStep step;
    step.target = {"goal", {x, y.value_or(0.0), z}, y.has_value()};
    return step;
}

/// A yard of 10 m by 10 m behind walls of 4 m, with a gate of 1.2 m in its south side at z = 5.
scene::Campus yard() {
    scene::Campus campus = level_campus(15.0);
    add_box(campus, "north", {-5, 0, -5.2}, {5, 4, -5});
    add_box(campus, "west", {-5.2, 0, -5.2}, {-5, 4, 5.2});
    add_box(campus, "east", {5, 0, -5.2}, {5.2, 4, 5.2});
    add_box(campus, "south-west", {-5, 0, 5}, {-0.6, 4, 5.2});
    add_box(campus, "south-east", {0.6, 0, 5}, {5, 4, 5.2});
    add_box(campus, "gate", {-0.6, 0, 5.05}, {0.6, 4, 5.15});
    return campus;
}

TEST(GoTo, ArrivesWithOneEvent) {
    const scene::Campus campus = yard();
    const RecordedRun result = run(campus, walk_of({spawn_at({3, 0, 8}), go_to(-8, -8, 0.0)}));
    EXPECT_TRUE(result.summary.passed);
    EXPECT_EQ(result.recorder.events("avatar.arrive *").size(), 1U);
    EXPECT_EQ(result.recorder.events("avatar.arrive goal").size(), 1U);
    EXPECT_TRUE(result.recorder.events("avatar.blocked *").empty());
}

TEST(GoTo, HeedsWhatIsEnabledThen) {
    const scene::Campus campus = yard();
    const RecordedRun open =
        run(campus, walk_of({spawn_at({0, 0, 8}), disable("gate"), go_to(0, 0), enable("gate")}));
    EXPECT_TRUE(open.summary.passed);
    const RecordedRun shut = run(
        campus, walk_of({spawn_at({0, 0, 8}), disable("gate"), go_to(0, 0), enable("gate"), go_to(0, 8)}));
    ASSERT_EQ(shut.summary.failures.size(), 1U);
    EXPECT_EQ(shut.summary.failures.front().code, "unreachable");
    EXPECT_THAT(shut.summary.failures.front().message,
                testing::HasSubstr("go_to goal can't be reached: gate stands in the way"));
}

TEST(GoTo, IsTheSameWithWhatEarlierWalksRemember) {
    const scene::Campus campus = yard();
    const std::vector<Walk> walks = {
        walk_of({spawn_at({0, 0, 8}), disable("gate"), go_to(0, 0)}),
        walk_of({spawn_at({0, 0, 8}), go_to(0, 0)}),
        walk_of({spawn_at({0, 0, 8}), disable("gate"), set_height(1.1), go_to(0, 0)}),
        walk_of({spawn_at({0, 0, 8}), disable("gate"), set_speed(0.7), go_to(0, 0)}),
    };
    RouteMemory memory;
    for (int round = 0; round < 2; ++round) {
        for (const Walk& walk : walks) {
            const WalkSummary alone = run_walk(campus, walk, {});
            const WalkSummary after_others = run_walk(campus, walk, {}, &memory);
            EXPECT_EQ(after_others.hash, alone.hash);
            EXPECT_EQ(after_others.passed, alone.passed);
            ASSERT_EQ(after_others.failures.size(), alone.failures.size());
            for (std::size_t i = 0; i < alone.failures.size(); ++i) {
                EXPECT_EQ(after_others.failures[i].message, alone.failures[i].message);
            }
        }
        EXPECT_EQ(memory.planned.size(), walks.size()) << "each for itself";
    }
}

TEST(GoTo, SaysThatItIsThePlaceToGoThroughThatCantBeReached) {
    const scene::Campus campus = yard();
    GoToStep step = go_to(8, 8);
    step.through = {{"fountain", {0, 0, 0}, false}};
    const RecordedRun result = run(campus, walk_of({spawn_at({0, 0, 8}), step}));
    ASSERT_EQ(result.summary.failures.size(), 1U);
    EXPECT_THAT(result.summary.failures.front().message,
                testing::HasSubstr("go_to goal can't be reached: the way goes through fountain, and that "
                                   "can't be reached: gate stands in the way"));
}

TEST(GoTo, SaysHowHighTheRiserIsThatKeepsItAway) {
    scene::Campus campus = level_campus(10.0);
    add_box(campus, "stage", {-3, 0, -8}, {3, 0.45, -3});
    const RecordedRun result = run(campus, walk_of({spawn_at({0, 0, 4}), go_to(0, -6, 0.45)}));
    ASSERT_EQ(result.summary.failures.size(), 1U);
    EXPECT_EQ(result.summary.failures.front().code, "unreachable");
    EXPECT_THAT(result.summary.failures.front().message, testing::HasSubstr("riser of 0.45 m at stage"));
    EXPECT_THAT(result.summary.failures.front().message, testing::HasSubstr("the avatar steps 0.30 m"));
    const auto contact = result.summary.failures.front().scene.contact;
    ASSERT_TRUE(contact) << "pictures of the failure show the riser";
    EXPECT_NEAR(contact->z(), -3.0, 0.01);
    AvatarProfile climber;
    climber.step_height = 0.46;
    Walk walk = walk_of({spawn_at({0, 0, 4}), go_to(0, -6, 0.45)});
    walk.avatar = climber;
    EXPECT_TRUE(run(campus, walk).summary.passed);
}

/// The wall is 0.26 m away: nearer than the body's radius, and too far for what is certain without a search.
TEST(GoTo, SaysHowNearOneGetsToWhatIsCloseToAWall) {
    const scene::Campus campus = yard();
    const RecordedRun result = run(campus, walk_of({spawn_at({0, 0, 0}), go_to(4.74, 0.3, 0.0)}));
    ASSERT_EQ(result.summary.failures.size(), 1U);
    EXPECT_THAT(
        result.summary.failures.front().message,
        testing::HasSubstr("one gets no nearer than 0.06 m, to 4.68, 0.00, 0.30: east is in the way"));
}

TEST(GoTo, GoesUnderWhatOnlyACrouchedBodyPasses) {
    scene::Campus campus = level_campus(10.0);
    add_box(campus, "beam", {-12, 1.3, -0.2}, {12, 3, 0.2});
    EXPECT_FALSE(run(campus, walk_of({spawn_at({0, 0, 4}), go_to(0, -4)})).summary.passed);
    const Walk crouched = walk_of({spawn_at({0, 0, 4}), set_height(1.1), go_to(0, -4)});
    EXPECT_TRUE(run(campus, crouched).summary.passed);
}

TEST(GoTo, LandsFirst) {
    const scene::Campus campus = yard();
    const RecordedRun result = run(campus, walk_of({spawn_at({3, 3, 8}), go_to(-8, -8, 0.0)}));
    EXPECT_TRUE(result.summary.passed);
}

/// Over a ledge's edge a falling body passes within half a metre of places that nobody stands at.
TEST(GoTo, DoesNotArriveInTheAir) {
    scene::Campus campus = level_campus(10.0);
    add_box(campus, "terrace", {-4, 0, -4}, {4, 3, 4});
    const RecordedRun result = run(campus, walk_of({spawn_at({0, 3, 0}), go_to(0, 4.42, 3.0)}));
    ASSERT_EQ(result.summary.failures.size(), 1U);
    EXPECT_EQ(result.summary.failures.front().code, "unreachable");
    EXPECT_TRUE(run(campus, walk_of({spawn_at({0, 3, 0}), go_to(0, 4.42, 0.0)})).summary.passed)
        << "the ground below is no place in the air";
}

TEST(GoTo, FailsIfItsTimeoutIsTooShort) {
    const scene::Campus campus = yard();
    GoToStep step = go_to(-8, -8);
    step.timeout = 2.0;
    const RecordedRun result = run(campus, walk_of({spawn_at({3, 0, 8}), step}));
    ASSERT_EQ(result.summary.failures.size(), 1U);
    EXPECT_EQ(result.summary.failures.front().code, "timeout");
    EXPECT_EQ(result.summary.ticks, 120);
}

TEST(GoTo, TakesItsOwnSpeed) {
    const scene::Campus campus = yard();
    GoToStep fast = go_to(-8, -8);
    fast.speed = 2.8;
    const Tick slow_ticks = run(campus, walk_of({spawn_at({3, 0, 8}), go_to(-8, -8)})).summary.ticks;
    const Tick fast_ticks = run(campus, walk_of({spawn_at({3, 0, 8}), fast})).summary.ticks;
    EXPECT_NEAR(static_cast<double>(fast_ticks), 0.5 * static_cast<double>(slow_ticks), 10.0);
}

TEST(GoTo, KeepsAwayFromWhatItAvoids) {
    scene::Campus campus = level_campus(10.0);
    add_box(campus, "lawn", {-3, 0, -3}, {3, 0.3, 3}, {collision::Detection::trigger, "", true, ""});
    GoToStep step = go_to(0, -6);
    step.avoid.push_back({NamePattern{{}, "lawn"}, {}, 0.0});
    const Walk around = walk_of({spawn_at({0, 0, 6}), step});
    const RecordedRun result = run(campus, around);
    EXPECT_TRUE(result.summary.passed);
    EXPECT_TRUE(result.recorder.events("trigger.enter lawn").empty());
    EXPECT_FALSE(run(campus, walk_of({spawn_at({0, 0, 6}), go_to(0, -6)}))
                     .recorder.events("trigger.enter lawn")
                     .empty());
    step.avoid.push_back({std::nullopt, {"goal", {0, 0, -6}, true}, 1.0});
    const RecordedRun none = run(campus, walk_of({spawn_at({0, 0, 6}), step}));
    ASSERT_EQ(none.summary.failures.size(), 1U);
    EXPECT_THAT(
        none.summary.failures.front().message,
        testing::EndsWith("every way leads through what is to be avoided: the circle of 1.00 m around "
                          "goal"))
        << "and not through the lawn";
}

TEST(GoTo, NamesTheAvoidedThatCloseEveryPath) {
    scene::Campus campus = level_campus(10.0);
    const ObjectTraits trigger{collision::Detection::trigger, "", true, ""};
    add_box(campus, "lawn/west", {-10, 0, -1}, {1, 0.3, 1}, trigger);
    add_box(campus, "lawn/pond", {7, 0, 5}, {8, 0.3, 6}, trigger);
    add_box(campus, "street", {-1, 0, -1}, {10, 0.3, 1}, trigger);
    GoToStep step = go_to(0, -6);
    for (const char* glob : {"street", "lawn/pond", "lawn/*"}) {
        step.avoid.push_back({NamePattern{{}, glob}, {}, 0.0});
    }
    const RecordedRun none = run(campus, walk_of({spawn_at({0, 0, 6}), step}));
    ASSERT_EQ(none.summary.failures.size(), 1U);
    EXPECT_THAT(none.summary.failures.front().message,
                testing::EndsWith(
                    "every way leads through what is to be avoided: object 'street' or objects 'lawn/*'"));
    step.avoid.pop_back();
    EXPECT_TRUE(run(campus, walk_of({spawn_at({0, 0, 6}), step})).summary.passed);
}

TEST(GoTo, ToAvoidAnObjectThatIsNotThereIsAnError) {
    const scene::Campus campus = yard();
    GoToStep step = go_to(0, -6);
    step.avoid.push_back({NamePattern{{}, "gates"}, {}, 0.0});
    const auto diagnostics = check_walk(campus, walk_of({spawn_at({0, 0, 6}), step}));
    ASSERT_EQ(diagnostics.size(), 1U);
    EXPECT_EQ(diagnostics.front().code.text(), "unknown-name");
}

}  // namespace
}  // namespace campuswalk::engine

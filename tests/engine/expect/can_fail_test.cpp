#include "engine/expect/can_fail.h"

#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/engine/expect/single_evaluator.h"
#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"
#include "tests/support/dice.h"

namespace campuswalk::engine {
namespace {

/// A floor of 20 m x 20 m with a hut of a metre that has a pop-up.
const scene::Campus& hut_yard() {
    static const scene::Campus campus = [] {
        scene::Campus made = level_campus(10.0);
        add_building(made, "hut", "The Hut");
        ObjectTraits of_hut;
        of_hut.building = "hut";
        add_box(made, "hut/wall", {3, 0, 3}, {4, 1, 4}, of_hut);
        return made;
    }();
    return campus;
}

/// Ten seconds at most, from the origin.
Walk ten_seconds() {
    Walk walk = walk_of({spawn_at({0, 0, 0}), walk_to(5, 5), snapshot("view")});
    walk.sim.ticks_per_second = 10;
    walk.timeout = 10.0;
    return walk;
}

bool can_fail(Expectation expected, Walk walk = ten_seconds()) {
    walk.expectations = {std::move(expected)};
    return vacuous_expectations(hut_yard(), walk).empty();
}

bool can_fail_in_step(Expectation expected) {
    Walk walk = ten_seconds();
    walk.steps.emplace_back(ExpectStep{{}, {std::move(expected)}});
    return vacuous_expectations(hut_yard(), walk).empty();
}

Target place(double x, double z) {
    return {"place", {x, 0, z}, false};
}

Expectation count(const std::string& words, const Limits<int>& times) {
    ExpectCount expected;
    expected.event = pattern(words);
    expected.times = times;
    return PlainExpectation(expected);
}

Expectation sequence(const std::vector<std::string>& words) {
    ExpectSequence expected;
    for (const std::string& each : words) {
        expected.events.push_back(pattern(each));
    }
    return PlainExpectation(expected);
}

Expectation never(const std::string& words) {
    return PlainExpectation(ExpectNever{{}, pattern(words)});
}

Expectation within(const std::string& after, const std::string& event, double seconds) {
    return PlainExpectation(ExpectWithin{{}, pattern(after), pattern(event), seconds});
}

Expectation popup(const std::string& title, const Limits<int>& times = {std::nullopt, 1, std::nullopt}) {
    return PlainExpectation(ExpectPopup{{}, {{}, "hut"}, title, "*", times});
}

Expectation visits(double ratio) {
    return PlainExpectation(ExpectVisits{{}, {{{}, "*"}}, ratio});
}

Expectation near(const Target& target, double distance, const std::string& at = "") {
    ExpectNear expected{{}, target, distance, std::nullopt};
    if (!at.empty()) {
        expected.at = pattern(at);
    }
    return PlainExpectation(expected);
}

Expectation reaches(const Target& target, double distance) {
    return PlainExpectation(ExpectReaches{{}, target, distance});
}

Expectation duration(const Limits<double>& seconds) {
    return PlainExpectation(ExpectDuration{{}, seconds});
}

Expectation distance(const Limits<double>& metres) {
    return PlainExpectation(ExpectDistance{{}, metres});
}

Expectation denied(const Expectation& expected) {
    return ExpectNot{{}, std::get<PlainExpectation>(expected)};
}

constexpr std::nullopt_t kNone = std::nullopt;

/// What can't fail, and the nearest that can.
struct Pair {
    std::string name;
    Expectation vacuous;
    Expectation not_vacuous;
};

std::vector<Pair> pairs() {
    const double radius = AvatarProfile().radius;
    return {
        {"sequence of the start", sequence({"walk.start"}), sequence({"popup.open hut"})},
        {"sequence of start and end", sequence({"walk.*", "walk.end"}),
         sequence({"walk.start", "popup.open", "walk.end"})},
        {"not sequence against the order", denied(sequence({"popup.open", "walk.start"})),
         denied(sequence({"walk.start", "popup.open"}))},
        {"not never of what comes", denied(never("walk.*")), denied(never("popup.*"))},
        {"never, of nothing", never("none.*"), never("popup.*")},
        {"count at least 0", count("avatar.fell", {kNone, 0, kNone}),
         count("avatar.fell", {kNone, 1, kNone})},
        {"count of the start", count("walk.start", {1, kNone, kNone}),
         count("walk.start", {2, kNone, kNone})},
        {"count at most a billion", count("popup.open", {kNone, 0, 1'000'000'000}),
         count("popup.open", {kNone, 0, 2})},
        {"not count out of reach", denied(count("walk.end", {kNone, 2, kNone})),
         denied(count("popup.open", {kNone, 2, kNone}))},
        {"within the whole walk", within("walk.start", "walk.end", 11.0),
         within("walk.start", "walk.end", 3.0)},
        {"popup any number of times", popup("*", {kNone, 0, kNone}), popup("*", {kNone, 1, kNone})},
        {"not a title that nothing has", denied(popup("Library")), denied(popup("The *"))},
        {"visits of none", visits(0.0), visits(0.5)},
        {"near anywhere", near(place(0, 0), 15.0), near(place(0, 0), 13.0)},
        {"near at the start", near(place(1, 0), 1.6, "walk.start"), near(place(1, 0), 1.6, "popup.open")},
        {"not near what is elsewhere", denied(near(place(99, 0), 80.0)), denied(near(place(99, 0), 90.0))},
        {"reaches where it starts", reaches(place(1, 0), 1.6), reaches(place(3, 0), 1.6)},
        {"not reaches what is elsewhere", denied(reaches(place(99, 0), 80.0)),
         denied(reaches(place(9, 0), 1.0))},
        {"duration at least 0", duration({kNone, 0.0, kNone}), duration({kNone, 5.0, kNone})},
        {"duration at most the timeout", duration({kNone, kNone, 10.1}), duration({kNone, kNone, 5.0})},
        {"not duration beyond it", denied(duration({kNone, 10.2, kNone})),
         denied(duration({kNone, 2.0, kNone}))},
        {"distance at least 0", distance({kNone, 0.0, kNone}), distance({kNone, 1.0, kNone})},
        {"distance at most a thousand kilometres", distance({kNone, kNone, 1e6}),
         distance({kNone, kNone, 5.0})},
        {"no penetration of the whole body", PlainExpectation(ExpectNoPenetration{{}, radius}),
         PlainExpectation(ExpectNoPenetration{{}, 0.9 * radius})},
        {"grounded never", PlainExpectation(ExpectGrounded{{}, 0.0}),
         PlainExpectation(ExpectGrounded{{}, 0.5})},
    };
}

/// A walk of which anything may be true: events in any order between start and end, positions on the floor,
/// in the air or not.
std::optional<Failure> outcome_of_random_record(const Expectation& expected, support::Dice& dice) {
    SingleEvaluator evaluator(expected, hut_yard());
    TickFeed feed(evaluator);
    const std::vector<std::string> any = {"popup.open hut", "popup.close hut", "collision.enter hut/wall",
                                          "avatar.fell stroll", "avatar.landed stroll"};
    const int ticks = 1 + dice.below(100);
    const double speed = dice.between(0.0, 3.0);
    const int most_airborne = dice.below(3);
    for (int tick = 0; tick < ticks; ++tick) {
        std::vector<Event> events;
        if (tick == 0) {
            events.push_back(made_event("walk.start stroll"));
        }
        while (dice.below(4) == 0) {
            Event event = made_event(any[static_cast<std::size_t>(dice.below(static_cast<int>(any.size())))]);
            if (event.kind == EventKind::popup_open) {
                event.fields = {{"title", Text{"The Hut"}}, {"body", Text{""}}};
            }
            events.push_back(event);
        }
        if (tick + 1 == ticks) {
            events.push_back(made_event("walk.end stroll"));
        }
        const Eigen::Vector3d at(dice.between(-10, 10), 0.0, dice.between(-10, 10));
        feed.in_the_air(dice.below(2) < most_airborne)
            .after_metres(speed * tick)
            .with(std::move(events), tick == 0 ? Eigen::Vector3d(0.1, 0, 0) : at);
    }
    return evaluator.failure();
}

TEST(CanFail, TellsWhatCantFromTheNearestThatCan) {
    for (const Pair& pair : pairs()) {
        EXPECT_FALSE(can_fail(pair.vacuous)) << pair.name;
        EXPECT_TRUE(can_fail(pair.not_vacuous)) << pair.name;
    }
}

TEST(CanFail, NoRecordFailsWhatCant) {
    support::Dice dice(11);
    for (const Pair& pair : pairs()) {
        for (int i = 0; i < 300; ++i) {
            EXPECT_FALSE(outcome_of_random_record(pair.vacuous, dice)) << pair.name;
        }
    }
}

TEST(CanFail, SomeRecordFailsWhatCan) {
    support::Dice dice(12);
    for (const Pair& pair : pairs()) {
        bool fails = false;
        for (int i = 0; i < 3000 && !fails; ++i) {
            fails = outcome_of_random_record(pair.not_vacuous, dice).has_value();
        }
        EXPECT_TRUE(fails) << pair.name;
    }
}

TEST(CanFail, WhatHappensToTheBodyCan) {
    for (const PlainExpectation& expected :
         {PlainExpectation(ExpectFell{}), PlainExpectation(ExpectStuck{}),
          PlainExpectation(ExpectBlockedBy{{}, {{}, "hut/wall"}}), PlainExpectation(ExpectReachable{}),
          PlainExpectation(ExpectRoute{})}) {
        EXPECT_TRUE(can_fail(expected));
        EXPECT_TRUE(can_fail(ExpectNot{{}, expected}));
    }
}

TEST(CanFail, WhoNeverMovesIsNeverBlocked) {
    const Walk idle = walk_of({spawn_at({0, 0, 0}), wait_for(1)});
    EXPECT_FALSE(can_fail(ExpectNot{{}, ExpectStuck{}}, idle));
    EXPECT_FALSE(can_fail(ExpectNot{{}, ExpectBlockedBy{{}, {{}, "hut/wall"}}}, idle));
    EXPECT_TRUE(can_fail(PlainExpectation(ExpectStuck{}), idle));
    EXPECT_FALSE(can_fail(duration({kNone, kNone, 1.2}), idle)) << "its steps take no longer";
    EXPECT_TRUE(can_fail(duration({kNone, kNone, 0.9}), idle));
}

TEST(CanFail, ARouteIsNoShorterThanTheStraightLine) {
    ExpectRoute route;
    route.from = place(0, 0);
    route.to = place(9, 0);
    route.max_length = 7.0;
    EXPECT_FALSE(can_fail(ExpectNot{{}, route}));
    route.max_length = 8.5;
    EXPECT_TRUE(can_fail(ExpectNot{{}, route}));
}

TEST(CanFail, LogsAndImagesCanUnlessTheyAskForNothing) {
    EXPECT_TRUE(can_fail(ExpectLog{{}, true}));
    EXPECT_FALSE(can_fail(ExpectLog{{}, false}));
    EXPECT_TRUE(can_fail(ExpectSnapshot{{}, "view", {}}));
    ExpectVisible visible{{}, {{}, "hut"}, {}, "view", 1, kNone, false};
    EXPECT_TRUE(can_fail(visible));
    visible.min_pixels = 0;
    EXPECT_FALSE(can_fail(visible));
    visible.min_ratio = 0.1;
    EXPECT_TRUE(can_fail(visible));
    ExpectVisible hidden{{}, {{}, "hut"}, {}, "view", 1280 * 720, kNone, true};
    EXPECT_TRUE(can_fail(hidden));
    hidden.min_pixels += 1;
    EXPECT_FALSE(can_fail(hidden));
}

Walk xfail(Walk walk, const std::vector<std::string>& codes) {
    walk.status.kind = WalkStatus::Kind::xfail;
    walk.status.codes = codes;
    return walk;
}

/// Each step but the first logs an event by itself.
Walk busy_walk() {
    Walk walk = walk_of({spawn_at({0, 0, 0}), JumpStep{{}, 3.0, 0.0}, teleport_to({2, 0, 2}),
                         snapshot("view"), EnableStep{{}, {{{}, "hut/*"}}, false}, wait_for(5)});
    walk.timeout = 60.0;
    return walk;
}

TEST(CanFail, WhatStepsCauseByThemselvesIsCertain) {
    for (const char* event :
         {"avatar.jump", "avatar.teleport", "snapshot.take view", "object.disable hut/wall"}) {
        EXPECT_FALSE(can_fail(sequence({event}), busy_walk())) << event;
        EXPECT_FALSE(can_fail(count(event, {1, kNone, kNone}), busy_walk())) << event;
        EXPECT_FALSE(can_fail(denied(never(event)), busy_walk())) << event;
        EXPECT_FALSE(can_fail(never(event), xfail(busy_walk(), {"never"}))) << event;
        EXPECT_TRUE(can_fail(sequence({event, "popup.open"}), busy_walk())) << event;
    }
    EXPECT_FALSE(
        can_fail(sequence({"walk.start", "avatar.jump", "object.disable", "walk.end"}), busy_walk()));
    EXPECT_TRUE(can_fail(sequence({"object.disable", "avatar.jump"}), busy_walk()));
    EXPECT_FALSE(can_fail(duration({kNone, 3.0, kNone}), busy_walk())) << "it waits for longer";
    EXPECT_TRUE(can_fail(duration({kNone, 5.0, kNone}), busy_walk()));
}

TEST(CanFail, WhatNoStepCausesNeverComes) {
    for (const char* event : {"avatar.jump", "avatar.spawn", "avatar.crouch", "avatar.stand", "object.*",
                              "expect.fail", "avatar.teleport"}) {
        EXPECT_FALSE(can_fail(never(event))) << event;
        EXPECT_FALSE(can_fail(count(event, {0, kNone, kNone}))) << event;
        EXPECT_FALSE(can_fail(denied(sequence({"walk.start", event})))) << event;
    }
    EXPECT_TRUE(can_fail(never("avatar.arrive"))) << "the visitor may get there";
    EXPECT_TRUE(can_fail(count("avatar.arrive", {1, kNone, kNone}))) << "or may not";
    EXPECT_TRUE(can_fail(never("avatar.*")));
    EXPECT_FALSE(can_fail(count("avatar.jump", {kNone, kNone, 1}), busy_walk()));
    EXPECT_FALSE(can_fail(never("object.enable"), busy_walk()));
    EXPECT_FALSE(can_fail(never("expect.fail"), xfail(ten_seconds(), {"never"})));
}

TEST(CanFail, AStepKnowsWhatStepsBeforeItCause) {
    Walk walk = busy_walk();
    const auto can_fail_before = [&](std::ptrdiff_t step, Expectation expected) {
        Walk with = walk;
        with.steps.insert(with.steps.begin() + step, ExpectStep{{}, {std::move(expected)}});
        return vacuous_expectations(hut_yard(), with).empty();
    };
    EXPECT_FALSE(can_fail_before(2, sequence({"avatar.jump"})));
    EXPECT_FALSE(can_fail_before(1, never("avatar.jump")));
    EXPECT_FALSE(can_fail_before(1, denied(sequence({"avatar.jump"}))));
    EXPECT_FALSE(can_fail_before(6, duration({kNone, 4.0, kNone})));
    EXPECT_TRUE(can_fail_before(6, duration({kNone, 5.0, kNone})));
    EXPECT_TRUE(can_fail_before(2, never("popup.open")));
    EXPECT_FALSE(can_fail_before(2, ExpectNot{{}, ExpectFell{}})) << "a fall would have stopped the walk";
    EXPECT_FALSE(can_fail_before(2, never("avatar.fell")));
    walk = walk_of({spawn_at({0, 0, 0}), wait_for(1), wait_for(100), walk_to(5, 5)});
    EXPECT_FALSE(can_fail_before(2, duration({kNone, kNone, 50.0}))) << "what follows takes longer";
    EXPECT_FALSE(can_fail_before(2, ExpectNot{{}, ExpectBlockedBy{{}, {{}, "hut/wall"}}}));
    EXPECT_TRUE(can_fail_before(4, ExpectNot{{}, ExpectBlockedBy{{}, {{}, "hut/wall"}}}));
}

TEST(CanFail, StepsCauseEventsInTheirOrderAndNoMoreOften) {
    const auto can_hold = [](const std::vector<std::string>& events, Walk walk) {
        return can_fail(denied(sequence(events)), std::move(walk));
    };
    EXPECT_TRUE(can_hold({"avatar.jump", "popup.open", "object.disable"}, xfail(busy_walk(), {})));
    EXPECT_FALSE(can_hold({"object.disable", "avatar.jump"}, busy_walk()));
    EXPECT_FALSE(can_hold({"popup.open", "object.disable", "popup.open", "avatar.jump"}, busy_walk()));
    EXPECT_FALSE(can_hold({"avatar.jump", "avatar.jump"}, busy_walk()));
    EXPECT_FALSE(can_hold({"avatar.arrive", "avatar.arrive"}, ten_seconds()));
    EXPECT_TRUE(can_hold({"avatar.arrive", "popup.open"}, ten_seconds()));
    EXPECT_FALSE(can_fail(sequence({"object.disable", "avatar.jump"}), xfail(busy_walk(), {"sequence"})));
}

TEST(CanFail, AWalkToTakesNoLongerThanItsOwnTimeout) {
    const Walk walk = walk_of({spawn_at({0, 0, 0}), walk_to(5, 5)});
    EXPECT_FALSE(can_fail(duration({kNone, kNone, 86400.0}), walk));
    EXPECT_FALSE(can_fail(distance({kNone, kNone, 1e6}), walk));
    EXPECT_TRUE(can_fail(duration({kNone, kNone, 10.0}), walk));
}

TEST(CanFail, AJumpLeadsAboveTheCampus) {
    const Expectation up = denied(reaches({"up", {0, 18, 0}, true}, 1.0));
    EXPECT_FALSE(can_fail(up));
    EXPECT_TRUE(can_fail(up, walk_of({spawn_at({0, 0, 0}), JumpStep{{}, 19.8, 0.0}})));
}

TEST(CanFail, WhatTheAvatarDetectsNothingOfNeverComes) {
    scene::Campus campus = level_campus(10.0);
    ObjectTraits glass;
    glass.layer = "glass";
    glass.detection = collision::Detection::solid | collision::Detection::ray;
    add_box(campus, "pane", {3, 0, 3}, {4, 2, 3.1}, glass);
    const auto can_fail_there = [&](Expectation expected, const std::function<void(Walk&)>& change) {
        Walk walk = ten_seconds();
        walk.expectations = {std::move(expected)};
        change(walk);
        return vacuous_expectations(campus, walk).empty();
    };
    const auto nothing = [](Walk&) {};
    const auto ignoring = [](Walk& walk) { walk.avatar.ignore_layers = {"glass"}; };
    const Expectation blocked = ExpectNot{{}, ExpectBlockedBy{{}, {{}, "pane"}}};
    const Expectation stuck = ExpectNot{{}, ExpectStuck{{}, {{}, "pane"}}};
    for (const Expectation& expected : {never("collision.enter pane"), blocked, stuck}) {
        EXPECT_TRUE(can_fail_there(expected, nothing));
        EXPECT_FALSE(can_fail_there(expected, ignoring));
    }
    EXPECT_TRUE(can_fail_there(never("collision.enter"), ignoring)) << "of the floor";
    EXPECT_FALSE(can_fail_there(never("trigger.enter"), nothing)) << "there is none";
    EXPECT_TRUE(can_fail_there(never("ray.enter"), nothing));
    EXPECT_FALSE(can_fail_there(never("ray.enter"), [](Walk& walk) { walk.avatar.look_distance = 0.0; }));
}

TEST(CanFail, APopUpShowsWhatItsBuildingSays) {
    const auto shows = [](const char* body) {
        return PlainExpectation(ExpectPopup{{}, {{}, "hut"}, "*", body, {kNone, 1, kNone}});
    };
    EXPECT_FALSE(can_fail(ExpectNot{{}, shows("no such text")}));
    EXPECT_TRUE(can_fail(ExpectNot{{}, shows("*")}));
}

TEST(CanFail, LittleFollowsAFall) {
    EXPECT_FALSE(can_fail(denied(sequence({"avatar.fell", "avatar.arrive"}))));
    EXPECT_FALSE(can_fail(denied(sequence({"avatar.fell", "popup.open"}))));
    EXPECT_TRUE(can_fail(denied(sequence({"avatar.fell", "popup.close"})))) << "as all contacts end";
    EXPECT_TRUE(can_fail(denied(sequence({"avatar.fell", "walk.end"}))));
    EXPECT_TRUE(can_fail(denied(sequence({"avatar.*", "popup.open"}))));
}

TEST(CanFail, AnXfailMustBeAbleToHold) {
    const std::vector<std::pair<Expectation, Expectation>> certain_and_not = {
        {reaches(place(5000, 5000), 1.0), reaches(place(5, 5), 1.0)},
        {count("walk.end", {2, kNone, kNone}), count("popup.open", {2, kNone, kNone})},
        {sequence({"walk.end", "walk.start"}), sequence({"walk.start", "popup.open"})},
        {never("walk.start"), never("popup.open")}};
    for (const auto& [certain, open] : certain_and_not) {
        EXPECT_TRUE(can_fail(certain)) << "which a walk that must pass may well say";
        EXPECT_FALSE(can_fail(certain, xfail(ten_seconds(), {"reaches"})));
        EXPECT_TRUE(can_fail(open, xfail(ten_seconds(), {"reaches"})));
    }
}

TEST(CanFail, AnXfailIsNotOfTimesThatAreTooShort) {
    const auto in_time = [](Walk walk) {
        return vacuous_expectations(hut_yard(), xfail(std::move(walk), {"timeout", "blocked"})).empty();
    };
    Walk walk = walk_of({spawn_at({0, 0, 0}), wait_for(2), walk_to(8, 0)});
    walk.avatar.speed = 1.0;
    walk.timeout =
        9.5;  // 2 s, and 8 m without the 0.5 m that a spawn may be moved, and the 0.05 m that count as there
    EXPECT_TRUE(in_time(walk));
    walk.timeout = 9.4;
    EXPECT_FALSE(in_time(walk));
    walk.timeout = 60.0;
    auto& step = std::get<WalkToStep>(walk.steps.back());
    step.timeout = 7.5;
    EXPECT_TRUE(in_time(walk));
    step.timeout = 7.4;
    EXPECT_FALSE(in_time(walk));
    EXPECT_TRUE(vacuous_expectations(hut_yard(), xfail(walk, {"unreachable"})).empty()) << "another failure";
    step.if_blocked = IfBlocked::proceed;
    EXPECT_TRUE(in_time(walk)) << "the walk goes on";
    step.if_blocked = IfBlocked::fail;
    step.timeout.reset();
    walk.steps.insert(walk.steps.end() - 1, teleport_to({8, 0, 0}));
    walk.timeout = 2.5;
    EXPECT_TRUE(in_time(walk)) << "from there it isn't far";
    WalkToStep late = walk_to(8, 0);
    late.timeout = 0.5;
    WalkToStep fast = walk_to(0, 0);
    fast.speed = 100.0;
    EXPECT_FALSE(in_time(walk_of({spawn_at({0, 0, 0}), late, fast}))) << "only a later step is so fast";
    EXPECT_FALSE(in_time(walk_of({spawn_at({0, 0, 0}), JumpStep{{}, 1.0, 0.0}, late})));
    FollowStep round = follow({{0, 0, 9}, {0, 0, 0.2}});
    round.timeout = 1.0;
    EXPECT_FALSE(in_time(walk_of({spawn_at({0, 0, 0}), round}))) << "there and back";
    Walk turning = walk_of({spawn_at({0, 0, 0}), turn_to(170)});
    turning.timeout = 0.1;
    EXPECT_FALSE(in_time(turning));
    turning.steps.insert(turning.steps.end() - 1, walk_to_or_proceed(0, 1));
    turning.timeout = 5.0;
    EXPECT_TRUE(in_time(turning));
}

TEST(CanFail, NothingFollowsTheEnd) {
    const auto not_within = [](const char* after, const char* event) {
        return denied(within(after, event, 1.0));
    };
    EXPECT_FALSE(can_fail(not_within("walk.start", "walk.start")));
    EXPECT_FALSE(can_fail(not_within("walk.end", "*")));
    EXPECT_FALSE(can_fail(not_within("walk.*", "walk.start")));
    EXPECT_FALSE(can_fail(not_within("*", "*"))) << "walk.end is one, too";
    EXPECT_TRUE(can_fail(not_within("walk.start", "walk.*")));
    EXPECT_TRUE(can_fail(not_within("popup.open", "popup.close")));
}

TEST(CanFail, WaitingForWhatStepsCauseExpectsNothing) {
    const auto expects_by_waiting = [](const char* event) {
        return expects_something(walk_of({spawn_at({0, 0, 0}), wait_until(event)}));
    };
    for (const char* event :
         {"*", "object.disable", "object.*", "snapshot.take", "avatar.*", "avatar.arrive", "*.enable hut"}) {
        EXPECT_FALSE(expects_by_waiting(event)) << event;
    }
    for (const char* event : {"popup.open hut", "trigger.*", "avatar.landed", "collision.enter"}) {
        EXPECT_TRUE(expects_by_waiting(event)) << event;
    }
}

TEST(CanFail, StepsExpectWhatHasHappenedSoFar) {
    EXPECT_FALSE(can_fail_in_step(sequence({"walk.start"})));
    EXPECT_TRUE(can_fail_in_step(sequence({"popup.open"})));
    EXPECT_FALSE(can_fail_in_step(never("walk.end"))) << "it hasn't ended yet";
    EXPECT_FALSE(can_fail_in_step(within("walk.start", "popup.open", 11.0))) << "it may still come";
    EXPECT_TRUE(can_fail_in_step(within("walk.start", "popup.open", 1.0)));
    EXPECT_TRUE(can_fail_in_step(within("popup.open", "popup.close", 11.0)));
}

}  // namespace
}  // namespace campuswalk::engine

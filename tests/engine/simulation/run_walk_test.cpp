#include "engine/simulation/run_walk.h"

#include <array>
#include <cmath>
#include <set>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/observers/text_log.h"
#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"

namespace campuswalk::engine {
namespace {

using collision::Detection;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using Lines = std::vector<std::string>;

scene::Campus hall_campus(const std::string& title = "Hall", double door = -3.5) {
    scene::Campus campus = level_campus();
    add_building(campus, "hall", title);
    add_box(campus, "hall/door", {-1, 0, door}, {1, 2, -2.5}, {Detection::trigger, "hall", true, ""});
    return campus;
}

Walk stroll_walk() {
    return walk_of({spawn_at({0, 0, 0}), walk_to(0, -8)});
}

std::uint64_t hash_of(const scene::Campus& campus, const Walk& walk) {
    return run_walk(campus, walk, {}).hash;
}

// ---- observers ------------------------------------------------------------------------------------------

TEST(RunWalk, NotifiesObserversOfBeginEveryTickAndEnd) {
    const RecordedRun result = run(hall_campus(), stroll_walk());
    const std::vector<Recorder::TickState>& states = result.recorder.states();
    // 7.95 m: 340.7 ticks; the spawn before and the closing events after.
    ASSERT_EQ(states.size(), 1 + 341 + 1U);
    Lines calls(states.size() + 2, "tick");
    calls.front() = "begin";
    calls.back() = "end";
    EXPECT_EQ(result.recorder.calls(), calls);
    for (std::size_t i = 0; i + 1 < states.size(); ++i) {
        ASSERT_EQ(states[i].tick, static_cast<Tick>(i));
    }
    EXPECT_EQ(states.back().tick, 341);
    EXPECT_TRUE(states.back().open_popups.empty());
    EXPECT_EQ(result.summary.ticks, 341);
}

/// Appends its calls to a list that several observers share.
class CallNotes final : public Observer {
public:
    CallNotes(std::string name, Lines& notes) : name_(std::move(name)), notes_(notes) {}
    void begin(const Walk& walk) override { notes_.push_back(name_ + " begin " + walk.name); }
    void on_tick(const TickRecord& record) override {
        notes_.push_back(name_ + " tick " + std::to_string(record.tick));
    }
    void end() override { notes_.push_back(name_ + " end"); }

private:
    std::string name_;
    Lines& notes_;
};

TEST(RunWalk, NotifiesObserversInTheirOrder) {
    Lines notes;
    CallNotes a("a", notes);
    CallNotes b("b", notes);
    const std::array<Observer*, 2> observers = {&a, &b};
    run_walk(level_campus(), walk_of({spawn_at({0, 0, 0})}), observers);
    EXPECT_EQ(notes, Lines({"a begin stroll", "b begin stroll", "a tick 0", "b tick 0", "a tick 0",
                            "b tick 0", "a end", "b end"}));
}

/// Throws in tick 5.
class Thrower final : public Observer {
public:
    void on_tick(const TickRecord& record) override {
        if (record.tick == 5) {
            throw std::runtime_error("disk full");
        }
    }
};

TEST(RunWalk, PropagatesAnObserversException) {
    Recorder before;
    Thrower thrower;
    Recorder after;
    const std::array<Observer*, 3> observers = {&before, &thrower, &after};
    try {
        run_walk(hall_campus(), stroll_walk(), observers);
        FAIL() << "the exception was swallowed";
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "disk full");
    }
    EXPECT_EQ(before.states().size(), 6U);
    EXPECT_EQ(after.states().size(), 5U);
    EXPECT_EQ(before.calls().back(), "tick") << "end() isn't called";
}

TEST(RunWalk, DoesNotDependOnItsObservers) {
    const WalkSummary alone = run_walk(hall_campus(), stroll_walk(), {});
    const RecordedRun watched = run(hall_campus(), stroll_walk());
    EXPECT_EQ(alone.hash, watched.summary.hash);
    EXPECT_EQ(alone.events, watched.summary.events);
}

// ---- the summary and the last lines ---------------------------------------------------------------------

TEST(RunWalk, EndsWithItsVerdict) {
    const RecordedRun result = run(hall_campus(), stroll_walk());
    EXPECT_TRUE(result.summary.passed);
    EXPECT_TRUE(result.summary.failures.empty());
    const Event& end = result.recorder.events().back();
    EXPECT_EQ(event_line(end), "walk.end stroll");
    EXPECT_EQ(end.tick, 341);
    EXPECT_EQ(field<std::string>(end, "result"), "pass");
    EXPECT_EQ(field<std::int64_t>(end, "events"), 6) << "enter, open, stay, close, exit, arrive";
    EXPECT_EQ(result.summary.events, 6);
    EXPECT_NEAR(field<Decimal>(end, "dist").value, 341 * 1.4 / 60, 1e-6)
        << "the foot rises slightly at first";
    const std::string& hash = field<std::string>(end, "hash");
    EXPECT_EQ(hash.size(), 16U);
    EXPECT_EQ(hash.find_first_not_of("0123456789abcdef"), std::string::npos);
    EXPECT_EQ(std::stoull(hash, nullptr, 16), result.summary.hash);
}

TEST(RunWalk, PrintsLeadingZerosOfItsHash) {
    // One walk in sixteen has one; the hash includes the walk's name.
    const scene::Campus campus = level_campus();
    Walk walk = walk_of({spawn_at({0, 0, 0})});
    for (int i = 0; i < 300; ++i) {
        walk.name = "walk-" + std::to_string(i);
        const RecordedRun result = run(campus, walk);
        if (result.summary.hash >> 60U == 0) {
            const std::string hash = field<std::string>(result.recorder.events().back(), "hash");
            EXPECT_EQ(hash.size(), 16U);
            EXPECT_EQ(hash.front(), '0');
            EXPECT_EQ(std::stoull(hash, nullptr, 16), result.summary.hash);
            return;
        }
    }
    FAIL() << "none of 300 hashes begins with a zero";
}

TEST(RunWalk, CountsTheEventsBetweenStartAndEnd) {
    Walk walk = walk_of({spawn_at({0, 0, -3}), wait_for(2.5)});
    walk.expectations = {expect_never("trigger.stay", 5), expect_count("popup.open", 2, {}, {}, 6)};
    const RecordedRun result = run(hall_campus(), walk);
    EXPECT_EQ(result.recorder.event_lines(),
              Lines({"trigger.enter hall/door", "popup.open hall", "trigger.stay hall/door",
                     "trigger.stay hall/door", "popup.close hall", "trigger.exit hall/door",
                     "expect.fail never", "expect.fail count"}));
    EXPECT_EQ(result.summary.events, 8);
    EXPECT_EQ(result.summary.events, static_cast<std::int64_t>(result.recorder.event_lines().size()));
}

TEST(RunWalk, LogsFailuresBeforeTheEnd) {
    Walk walk = walk_of({spawn_at({0, 0, 0}), wait_for(0.1)});
    walk.expectations = {expect_sequence({"walk.start", "trigger.enter hall/door"}, 20),
                         expect_reaches({"square", {0, 0, -10}, true}, 1.0, 30)};
    Lines lines;
    TextLog log([&](std::string_view line) { lines.emplace_back(line); });
    const std::array<Observer*, 1> observers = {&log};
    const WalkSummary summary = run_walk(hall_campus(), walk, observers);
    EXPECT_FALSE(summary.passed);
    ASSERT_EQ(summary.failures.size(), 2U);
    ASSERT_EQ(lines.size(), 5U);
    EXPECT_THAT(lines[2],
                AllOf(StartsWith("000006    0.100000 expect.fail      sequence          line=22 message=\""),
                      HasSubstr("'trigger.enter hall/door'"), HasSubstr("walk.start stroll at 0.000 s")));
    EXPECT_THAT(lines[3],
                AllOf(StartsWith("000006    0.100000 expect.fail      reaches           line=30 message=\""),
                      HasSubstr("square"), HasSubstr("10.000 m at 0.000 s"), HasSubstr("1.000 m")));
    EXPECT_THAT(lines[4],
                StartsWith("000006    0.100000 walk.end         stroll            result=fail events=2 "
                           "dist=0.000 hash="));
}

TEST(RunWalk, EvaluatesExpectationsOverTheWholeWalk) {
    Walk walk = walk_of({spawn_at({0, 0, -3}), wait_for(0.1)});
    walk.expectations = {expect_sequence({"walk.start stroll", "trigger.enter hall/door", "popup.open hall",
                                          "popup.close hall", "trigger.exit hall/door", "walk.end stroll"}),
                         expect_count("walk.*", 2), expect_count("popup.*", 2), expect_never("expect.fail")};
    const WalkSummary summary = run_walk(hall_campus(), walk, {});
    EXPECT_TRUE(summary.passed) << summary.failures.at(0).message;
}

/// A stroll that ends at a wall.
WalkSummary stopped_stroll(std::vector<Expectation> expectations) {
    scene::Campus campus = level_campus();
    add_box(campus, "wall", {-5, 0, -4}, {5, 3, -3});
    Walk walk = stroll_walk();
    walk.expectations = std::move(expectations);
    return run_walk(campus, walk, {});
}

TEST(RunWalk, ReportsTheStopBeforeExpectationsThatHaveFailed) {
    const WalkSummary summary =
        stopped_stroll({expect_never("walk.start", 5), expect_never("collision.enter nothing", 6)});
    ASSERT_EQ(summary.failures.size(), 2U);
    EXPECT_EQ(summary.failures[0].code, "blocked");
    EXPECT_THAT(summary.failures[0].message, Not(HasSubstr("line"))) << "both expectations were evaluated";
    EXPECT_EQ(summary.failures[1].code, "never");
}

TEST(RunWalk, ListsTheLinesOfExpectationsThatAStopLeavesOpen) {
    const ExpectReaches goal = expect_reaches({"goal", {0, 0, -8}, false}, 0.5, 9);
    const auto message_of = [](const WalkSummary& summary) {
        EXPECT_EQ(summary.failures.size(), 1U);
        return summary.failures.at(0).message;
    };
    const std::string plain = message_of(stopped_stroll({}));
    EXPECT_THAT(message_of(stopped_stroll({goal})), AllOf(StartsWith(plain), HasSubstr("line 9")));
    EXPECT_THAT(message_of(stopped_stroll(
                    {goal, expect_sequence({"popup.open"}, 10), expect_count("popup.open", 1, {}, {}, 12)})),
                AllOf(StartsWith(plain), HasSubstr("lines 9, 11 and 12")));
    EXPECT_EQ(message_of(stopped_stroll({goal, goal})), message_of(stopped_stroll({goal})))
        << "each line once";
    std::vector<Expectation> many;
    for (int line = 11; line < 21; ++line) {
        many.emplace_back(expect_reaches({"goal", {0, 0, -8}, false}, 0.5, line));
    }
    EXPECT_THAT(message_of(stopped_stroll(many)),
                AllOf(StartsWith(plain), HasSubstr("lines 11, 12, 13, 14, 15, 16, 17, 18, …")));
}

// ---- the hash -------------------------------------------------------------------------------------------

TEST(WalkHash, IsTheSameForTheSameWalk) {
    EXPECT_EQ(hash_of(hall_campus(), stroll_walk()), hash_of(hall_campus(), stroll_walk()));
}

TEST(WalkHash, DoesNotDependOnExpectations) {
    Walk walk = stroll_walk();
    const std::uint64_t plain = hash_of(hall_campus(), walk);
    walk.expectations = {expect_never("popup.open")};
    const WalkSummary failed = run_walk(hall_campus(), walk, {});
    EXPECT_FALSE(failed.passed);
    EXPECT_EQ(failed.hash, plain);
}

TEST(WalkHash, DiffersForDifferentWalks) {
    std::set<std::uint64_t> hashes;
    const auto add = [&](const scene::Campus& campus, const Walk& walk) {
        hashes.insert(hash_of(campus, walk));
        return hashes.size();
    };
    EXPECT_EQ(add(hall_campus(), stroll_walk()), 1U);
    EXPECT_EQ(add(hall_campus(), walk_of({spawn_at({0, 0, 0}), walk_to(0.01, -8)})), 2U);
    EXPECT_EQ(add(hall_campus(), walk_of({spawn_at({1e-15, 0, 0}), walk_to(0, -8)})), 3U)
        << "a difference that no log shows";
    EXPECT_EQ(add(hall_campus("Great Hall"), stroll_walk()), 4U) << "the path is the same, an event is not";
    EXPECT_EQ(add(hall_campus("Hall", -3.5000001), stroll_walk()), 5U) << "nor is the time of an event";
    EXPECT_EQ(add(level_campus(), stroll_walk()), 6U) << "without the events";
    EXPECT_EQ(add(hall_campus(), walk_of({spawn_at({0, 0, 0}), walk_to(0, -8), wait_for(0)})), 7U)
        << "a tick longer";
    EXPECT_EQ(add(hall_campus(), walk_of({spawn_at({0, 0, 0}), snapshot("x"), walk_to(0, -8)})), 8U);
}

// ---- the whole walk's timeout ---------------------------------------------------------------------------

TEST(RunWalk, EndsAtItsTimeout) {
    Walk walk = walk_of({spawn_at({0, 0, 0}), wait_for(1.0), wait_for(60.0)});
    std::get<WaitStep>(walk.steps[2]).mark = {"a.walk.yaml", 6, 5};
    walk.timeout = 1.5;
    const WalkSummary summary = run_walk(level_campus(), walk, {});
    ASSERT_EQ(summary.failures.size(), 1U);
    EXPECT_EQ(summary.failures[0].code, "timeout");
    EXPECT_EQ(summary.failures[0].mark.line, 6);
    EXPECT_THAT(summary.failures[0].message, HasSubstr("1.500 s"));
    EXPECT_EQ(summary.ticks, 90);
}

TEST(RunWalk, EndsAtTheMostTicksThatArePlayed) {
    Walk walk = walk_of({spawn_at({0, 0, 0}), wait_for(1.0), wait_for(60.0)});
    walk.sim.max_ticks = 100;
    const WalkSummary summary = run_walk(level_campus(), walk, {});
    ASSERT_EQ(summary.failures.size(), 1U);
    EXPECT_EQ(summary.failures[0].code, "timeout");
    EXPECT_THAT(summary.failures[0].message, HasSubstr("after 100 ticks"));
    EXPECT_EQ(summary.ticks, 100);
    walk.sim.max_ticks = 3660;  // 61 s
    EXPECT_TRUE(run_walk(level_campus(), walk, {}).passed);
}

TEST(RunWalk, MayEndInTheTickOfItsTimeout) {
    Walk walk = walk_of({spawn_at({0, 0, 0}), wait_for(1.0)});
    walk.timeout = 1.0;
    EXPECT_TRUE(run_walk(level_campus(), walk, {}).passed);
}

}  // namespace
}  // namespace campuswalk::engine

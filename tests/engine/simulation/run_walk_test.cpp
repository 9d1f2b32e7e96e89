#include "engine/simulation/run_walk.h"

#include <array>
#include <cmath>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include "engine/observers/text_log.h"
#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"

namespace campuswalk::engine {
namespace {

using collision::Detection;
using Story = std::vector<std::string>;

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

TEST(RunWalk, ShowsBeginEveryFrameAndEnd) {
    const Outing outing = run(hall_campus(), stroll_walk());
    const std::vector<Recorder::Frame>& frames = outing.recorder.frames();
    // 7.95 m: 340.7 ticks; the spawn before and the closing events after.
    ASSERT_EQ(frames.size(), 1 + 341 + 1U);
    Story calls(frames.size() + 2, "frame");
    calls.front() = "begin";
    calls.back() = "end";
    EXPECT_EQ(outing.recorder.calls(), calls);
    for (std::size_t i = 0; i + 1 < frames.size(); ++i) {
        ASSERT_EQ(frames[i].tick, static_cast<Tick>(i));
    }
    EXPECT_EQ(frames.back().tick, 341);
    EXPECT_TRUE(frames.back().open_popups.empty());
    EXPECT_EQ(outing.summary.ticks, 341);
}

/// Notes its calls in a list that several share.
class Noter final : public Observer {
public:
    Noter(std::string name, Story& notes) : name_(std::move(name)), notes_(notes) {}
    void begin(const Walk& walk) override { notes_.push_back(name_ + " begin " + walk.name); }
    void frame(const TickRecord& record) override {
        notes_.push_back(name_ + " frame " + std::to_string(record.tick));
    }
    void end() override { notes_.push_back(name_ + " end"); }

private:
    std::string name_;
    Story& notes_;
};

TEST(RunWalk, ShowsTheObserversInTheirOrder) {
    Story notes;
    Noter a("a", notes);
    Noter b("b", notes);
    const std::array<Observer*, 2> observers = {&a, &b};
    run_walk(level_campus(), walk_of({spawn_at({0, 0, 0})}), observers);
    EXPECT_EQ(notes, Story({"a begin stroll", "b begin stroll", "a frame 0", "b frame 0", "a frame 0",
                            "b frame 0", "a end", "b end"}));
}

/// Throws at a tick.
class Thrower final : public Observer {
public:
    void frame(const TickRecord& record) override {
        if (record.tick == 5) {
            throw std::runtime_error("disk full");
        }
    }
};

TEST(RunWalk, LetsAnObserversFailureOut) {
    Recorder before;
    Thrower thrower;
    Recorder after;
    const std::array<Observer*, 3> observers = {&before, &thrower, &after};
    try {
        run_walk(hall_campus(), stroll_walk(), observers);
        FAIL() << "the failure was swallowed";
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "disk full");
    }
    EXPECT_EQ(before.frames().size(), 6U);
    EXPECT_EQ(after.frames().size(), 5U);
    EXPECT_EQ(before.calls().back(), "frame") << "nobody is told that all is well";
}

TEST(RunWalk, IsTheSameWhoeverLooksOn) {
    const WalkSummary alone = run_walk(hall_campus(), stroll_walk(), {});
    const Outing watched = run(hall_campus(), stroll_walk());
    EXPECT_EQ(alone.hash, watched.summary.hash);
    EXPECT_EQ(alone.events, watched.summary.events);
}

// ---- the summary and the last lines ---------------------------------------------------------------------

TEST(RunWalk, EndsWithItsVerdict) {
    const Outing outing = run(hall_campus(), stroll_walk());
    EXPECT_TRUE(outing.summary.passed);
    EXPECT_TRUE(outing.summary.failures.empty());
    const Event& end = outing.recorder.events().back();
    EXPECT_EQ(told(end), "walk.end stroll");
    EXPECT_EQ(end.tick, 341);
    EXPECT_EQ(field<std::string>(end, "result"), "pass");
    EXPECT_EQ(field<std::int64_t>(end, "events"), 6) << "enter, open, stay, close, exit, arrive";
    EXPECT_EQ(outing.summary.events, 6);
    EXPECT_NEAR(field<Decimal>(end, "dist").value, 341 * 1.4 / 60, 1e-6)
        << "the foot rises by a hair at first";
    const std::string& hash = field<std::string>(end, "hash");
    EXPECT_EQ(hash.size(), 16U);
    EXPECT_EQ(hash.find_first_not_of("0123456789abcdef"), std::string::npos);
    EXPECT_EQ(std::stoull(hash, nullptr, 16), outing.summary.hash);
}

TEST(RunWalk, PrintsLeadingZerosOfItsHash) {
    // One walk in sixteen has some; the name is part of the first event.
    const scene::Campus campus = level_campus();
    Walk walk = walk_of({spawn_at({0, 0, 0})});
    for (int i = 0; i < 300; ++i) {
        walk.name = "walk-" + std::to_string(i);
        const Outing outing = run(campus, walk);
        if (outing.summary.hash >> 60U == 0) {
            const std::string hash = field<std::string>(outing.recorder.events().back(), "hash");
            EXPECT_EQ(hash.size(), 16U);
            EXPECT_EQ(hash.front(), '0');
            EXPECT_EQ(std::stoull(hash, nullptr, 16), outing.summary.hash);
            return;
        }
    }
    FAIL() << "a hash of 300 that never begins with a zero is none";
}

TEST(RunWalk, CountsTheEventsBetweenStartAndEnd) {
    Walk walk = walk_of({spawn_at({0, 0, -3}), wait_for(2.5)});
    walk.expectations = {expect_never("trigger.stay", 5), expect_count("popup.open", 2, {}, {}, 6)};
    const Outing outing = run(hall_campus(), walk);
    EXPECT_EQ(outing.recorder.story(),
              Story({"trigger.enter hall/door", "popup.open hall", "trigger.stay hall/door",
                     "trigger.stay hall/door", "popup.close hall", "trigger.exit hall/door",
                     "expect.fail never", "expect.fail count"}));
    EXPECT_EQ(outing.summary.events, 8);
    EXPECT_EQ(outing.summary.events, static_cast<std::int64_t>(outing.recorder.story().size()));
}

TEST(RunWalk, PrintsFailuresBeforeTheEnd) {
    Walk walk = walk_of({spawn_at({0, 0, 0}), wait_for(0.1)});
    walk.expectations = {expect_sequence({"walk.start", "trigger.enter hall/door"}, 20),
                         expect_reaches({"square", {0, 0, -10}, true}, 1.0, 30)};
    Story lines;
    TextLog log([&](std::string_view line) { lines.emplace_back(line); });
    const std::array<Observer*, 1> observers = {&log};
    const WalkSummary summary = run_walk(hall_campus(), walk, observers);
    EXPECT_FALSE(summary.passed);
    ASSERT_EQ(summary.failures.size(), 2U);
    ASSERT_EQ(lines.size(), 5U);
    EXPECT_EQ(
        lines[2],
        "000006    0.100000 expect.fail      sequence          line=22 message=\"'trigger.enter hall/door' "
        "never came after walk.start stroll at 0.000 s\"");
    EXPECT_EQ(
        lines[3],
        "000006    0.100000 expect.fail      reaches           line=30 message=\"square was not reached: "
        "the avatar came within 10.000 m at 0.000 s, expected 1.000 m\"");
    EXPECT_TRUE(lines[4].starts_with(
        "000006    0.100000 walk.end         stroll            result=fail events=2 dist=0.000 hash="))
        << lines[4];
}

TEST(RunWalk, LetsExpectationsSeeTheWholeWalk) {
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

TEST(RunWalk, PutsTheStopBeforeWhatNothingCouldMend) {
    const WalkSummary summary =
        stopped_stroll({expect_never("walk.start"), expect_never("collision.enter nothing")});
    ASSERT_EQ(summary.failures.size(), 2U);
    EXPECT_EQ(summary.failures[0].code, "blocked");
    EXPECT_EQ(summary.failures[0].message.find("isn't judged"), std::string::npos);
    EXPECT_EQ(summary.failures[1].code, "never");
}

TEST(RunWalk, SaysWhatAStopLeavesOpen) {
    const ExpectReaches goal = expect_reaches({"goal", {0, 0, -8}, false}, 0.5, 9);
    const auto told = [](const WalkSummary& summary) {
        EXPECT_EQ(summary.failures.size(), 1U);
        return summary.failures.at(0).message;
    };
    const std::string plain = told(stopped_stroll({}));
    EXPECT_EQ(told(stopped_stroll({goal})),
              plain + "; the walk stops here, so what line 9 expects isn't judged");
    EXPECT_EQ(told(stopped_stroll(
                  {goal, expect_sequence({"popup.open"}, 10), expect_count("popup.open", 1, {}, {}, 12)})),
              plain + "; the walk stops here, so what lines 9, 11 and 12 expect isn't judged");
    EXPECT_EQ(told(stopped_stroll({goal, goal})),
              plain + "; the walk stops here, so what line 9 expects isn't judged");
    std::vector<Expectation> many;
    for (int line = 11; line < 21; ++line) {
        many.emplace_back(expect_reaches({"goal", {0, 0, -8}, false}, 0.5, line));
    }
    EXPECT_EQ(
        told(stopped_stroll(many)),
        plain + "; the walk stops here, so what lines 11, 12, 13, 14, 15, 16, 17, 18, … expect isn't judged");
}

// ---- the hash -------------------------------------------------------------------------------------------

TEST(WalkHash, IsTheSameForTheSameWalk) {
    EXPECT_EQ(hash_of(hall_campus(), stroll_walk()), hash_of(hall_campus(), stroll_walk()));
}

TEST(WalkHash, DoesNotDependOnWhatIsExpected) {
    Walk walk = stroll_walk();
    const std::uint64_t plain = hash_of(hall_campus(), walk);
    walk.expectations = {expect_never("popup.open")};
    const WalkSummary failed = run_walk(hall_campus(), walk, {});
    EXPECT_FALSE(failed.passed);
    EXPECT_EQ(failed.hash, plain);
}

TEST(WalkHash, IsAnotherForAnotherWalk) {
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
    EXPECT_EQ(add(hall_campus("Hall", -3.5000001), stroll_walk()), 5U) << "nor is a moment";
    EXPECT_EQ(add(level_campus(), stroll_walk()), 6U) << "without events";
    EXPECT_EQ(add(hall_campus(), walk_of({spawn_at({0, 0, 0}), walk_to(0, -8), wait_for(0)})), 7U)
        << "a tick longer";
    EXPECT_EQ(add(hall_campus(), walk_of({spawn_at({0, 0, 0}), snapshot("x"), walk_to(0, -8)})), 8U);
}

// ---- the whole walk's time-out ---------------------------------------------------------------------------

TEST(RunWalk, EndsAtItsTimeOut) {
    Walk walk = walk_of({spawn_at({0, 0, 0}), wait_for(1.0), wait_for(60.0)});
    std::get<WaitStep>(walk.steps[2]).mark = {"a.walk.yaml", 6, 5};
    walk.timeout = 1.5;
    const WalkSummary summary = run_walk(level_campus(), walk, {});
    ASSERT_EQ(summary.failures.size(), 1U);
    EXPECT_EQ(summary.failures[0].code, "timeout");
    EXPECT_EQ(summary.failures[0].mark.line, 6);
    EXPECT_EQ(summary.failures[0].message, "the walk was still in this step after 1.500 s, its time-out");
    EXPECT_EQ(summary.ticks, 90);
}

TEST(RunWalk, MayEndInTheTickOfItsTimeOut) {
    Walk walk = walk_of({spawn_at({0, 0, 0}), wait_for(1.0)});
    walk.timeout = 1.0;
    EXPECT_TRUE(run_walk(level_campus(), walk, {}).passed);
}

}  // namespace
}  // namespace campuswalk::engine

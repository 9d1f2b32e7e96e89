#include "engine/events/contact_tracker.h"

#include <algorithm>
#include <ostream>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/dice.h"
#include "tests/support/effort.h"

namespace campuswalk::engine {

bool operator==(const Transition& a, const Transition& b) {
    return a.object == b.object && a.phase == b.phase && a.at == b.at && a.ticks == b.ticks;
}
std::ostream& operator<<(std::ostream& out, const Transition& t) {
    constexpr const char* kNames[] = {"exit", "enter", "stay"};
    return out << kNames[static_cast<int>(t.phase)] << " " << collision::index_of(t.object) << " at " << t.at
               << " after " << t.ticks;
}

namespace {

using collision::ObjectId;
using Transitions = std::vector<Transition>;

constexpr ObjectId kA{3};
constexpr ObjectId kB{5};

Transitions update(ContactTracker& tracker, Tick tick, const std::vector<ObjectOverlap>& seen) {
    Transitions out;
    tracker.update(tick, seen, out);
    return out;
}

TEST(ContactTracker, ReportsEnterStayAndExit) {
    ContactTracker tracker(2);
    EXPECT_FALSE(tracker.active(kA));
    EXPECT_EQ(update(tracker, 10, {{kA, true, true, 0.25, 1.0}}), Transitions({{kA, Phase::enter, 0.25, 0}}));
    EXPECT_TRUE(tracker.active(kA));
    EXPECT_FALSE(tracker.active(kB));
    EXPECT_EQ(update(tracker, 11, {{kA}}), Transitions());
    EXPECT_EQ(update(tracker, 12, {{kA}}), Transitions({{kA, Phase::stay, 1.0, 2}}));
    EXPECT_EQ(update(tracker, 13, {{kA}}), Transitions());
    EXPECT_EQ(update(tracker, 14, {{kA}}), Transitions({{kA, Phase::stay, 1.0, 4}}));
    EXPECT_EQ(update(tracker, 15, {{kA, false, true, 0.0, 0.5}}), Transitions({{kA, Phase::exit, 0.5, 5}}));
    EXPECT_FALSE(tracker.active(kA));
    EXPECT_EQ(update(tracker, 16, {}), Transitions());
}

TEST(ContactTracker, ReportsAStayEveryTickAtAnIntervalOfOneTick) {
    ContactTracker tracker(1);
    update(tracker, 0, {{kA}});
    for (Tick tick = 1; tick < 5; ++tick) {
        EXPECT_EQ(update(tracker, tick, {{kA}}), Transitions({{kA, Phase::stay, 1.0, tick}}));
    }
}

TEST(ContactTracker, EndsAbsentContactsAtTheEndOfTheTick) {
    ContactTracker tracker(60);
    update(tracker, 0, {{kA}, {kB}});
    EXPECT_EQ(update(tracker, 7, {{kB}}), Transitions({{kA, Phase::exit, 1.0, 7}}));
    EXPECT_EQ(update(tracker, 8, {}), Transitions({{kB, Phase::exit, 1.0, 8}}));
}

TEST(ContactTracker, ReportsEnterAndExitWithinOneTick) {
    ContactTracker tracker(60);
    EXPECT_EQ(update(tracker, 4, {{kA, false, true, 0.25, 0.75}}),
              Transitions({{kA, Phase::enter, 0.25, 0}, {kA, Phase::exit, 0.75, 0}}));
    EXPECT_FALSE(tracker.active(kA));
}

TEST(ContactTracker, IgnoresOverlapsOfZeroDuration) {
    ContactTracker tracker(60);
    EXPECT_EQ(update(tracker, 4, {{kA, false, true, 0.5, 0.5}}), Transitions());
}

TEST(ContactTracker, ExitsAllContactsAtOnce) {
    ContactTracker tracker(60);
    update(tracker, 1, {{kB}});
    update(tracker, 3, {{kA}, {kB}});
    Transitions out;
    tracker.leave_all(9, out);
    EXPECT_EQ(out, Transitions({{kA, Phase::exit, 1.0, 6}, {kB, Phase::exit, 1.0, 8}}));
    out.clear();
    tracker.leave_all(10, out);
    EXPECT_TRUE(out.empty());
}

/// One object's contact as an automaton of two states, derived from the event grammar only.
class Automaton {
public:
    explicit Automaton(Tick stay_ticks) : stay_ticks_(stay_ticks) {}

    /// The transitions that one object's overlap must cause; null: no overlap was reported.
    Transitions expected(ObjectId object, Tick tick, const ObjectOverlap* s) {
        const bool now = s != nullptr && s->present;
        if (!inside_) {
            if (now) {
                inside_ = true;
                since_ = tick;
                return {{object, Phase::enter, s->enter_at, 0}};
            }
            const bool transit = s != nullptr && s->touched && s->enter_at < s->exit_at;
            return transit ? Transitions{{object, Phase::enter, s->enter_at, 0},
                                         {object, Phase::exit, s->exit_at, 0}}
                           : Transitions{};
        }
        if (now) {
            const bool due = (tick - since_) % stay_ticks_ == 0;
            return due ? Transitions{{object, Phase::stay, 1.0, tick - since_}} : Transitions{};
        }
        inside_ = false;
        return {{object, Phase::exit, s == nullptr ? 1.0 : s->exit_at, tick - since_}};
    }
    bool inside() const { return inside_; }

private:
    Tick stay_ticks_;
    bool inside_ = false;
    Tick since_ = 0;
};

ObjectOverlap random_overlap(support::Dice& dice, ObjectId object) {
    const double enter = 0.1 * dice.below(11);
    const double exit = dice.chance(0.2) ? enter : enter + (1.0 - enter) * dice.between(0.0, 1.0);
    const bool present = dice.chance(0.6);
    return {object, present, present || dice.chance(0.7), enter, exit};
}

TEST(ContactTracker, AgreesWithAnAutomatonPerObjectOnRandomOverlaps) {
    constexpr int kObjects = 6;
    for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(support::repeats(200)); ++seed) {
        support::Dice dice(seed);
        const Tick stay_ticks = 1 + dice.below(5);
        ContactTracker tracker(stay_ticks);
        std::vector<Automaton> automata(kObjects, Automaton(stay_ticks));
        for (Tick tick = 0; tick < 150; ++tick) {
            std::vector<ObjectOverlap> seen;
            Transitions expected;
            for (std::uint32_t i = 0; i < kObjects; ++i) {
                const bool reported = dice.chance(0.7);
                const ObjectOverlap overlap = random_overlap(dice, ObjectId{i});
                if (reported) {
                    seen.push_back(overlap);
                }
                for (const Transition& t :
                     automata[i].expected(ObjectId{i}, tick, reported ? &overlap : nullptr)) {
                    expected.push_back(t);
                }
            }
            ASSERT_EQ(update(tracker, tick, seen), expected) << "seed " << seed << ", tick " << tick;
            for (std::uint32_t i = 0; i < kObjects; ++i) {
                ASSERT_EQ(tracker.active(ObjectId{i}), automata[i].inside());
            }
        }
        Transitions out;
        tracker.leave_all(150, out);
        const auto inside = std::ranges::count_if(automata, &Automaton::inside);
        ASSERT_EQ(static_cast<std::ptrdiff_t>(out.size()), inside)
            << "an exit for every enter, seed " << seed;
    }
}

}  // namespace
}  // namespace campuswalk::engine

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"

// The same walk at 30, 60 and 120 ticks per second.

namespace campuswalk::engine {
namespace {

using collision::Detection;
using Eigen::Vector3d;

constexpr double kSpeed = 1.4;
constexpr double kWithin = 0.05;

RecordedRun run_at(int rate, const scene::Campus& campus, std::vector<Step> steps) {
    Walk walk = walk_of(std::move(steps));
    walk.sim.ticks_per_second = rate;
    return run(campus, walk);
}

double distance_to_segment(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
    const Vector3d segment = b - a;
    const double length2 = segment.squaredNorm();
    const double part = length2 > 0.0 ? std::clamp((p - a).dot(segment) / length2, 0.0, 1.0) : 0.0;
    return (a + part * segment - p).norm();
}

double distance_to_path(const Vector3d& p, const std::vector<Recorder::TickState>& states) {
    double nearest = 1e300;
    for (std::size_t i = 1; i < states.size(); ++i) {
        nearest = std::min(nearest,
                           distance_to_segment(p, states[i - 1].avatar.position, states[i].avatar.position));
    }
    return nearest;
}

TEST(TickRate, DoesNotChangeAStraightWalk) {
    const scene::Campus campus = level_campus();
    const RecordedRun slow = run_at(30, campus, {spawn_at({0, 0, 0}), walk_to(0, -10)});
    const RecordedRun fast = run_at(120, campus, {spawn_at({0, 0, 0}), walk_to(0, -10)});
    for (const Recorder::TickState& state : slow.recorder.states()) {
        if (state.tick < 200) {  // before either arrives
            const AvatarState& other = fast.recorder.at(4 * state.tick);
            ASSERT_NEAR((state.avatar.position - other.position).norm(), 0.0, 1e-9) << state.time;
        }
    }
}

TEST(TickRate, DoesNotChangeTheEventsOfATour) {
    scene::Campus campus = level_campus();
    add_building(campus, "hall");
    add_box(campus, "hall/door", {4, 0, -7}, {8, 2, -5}, {Detection::trigger, "hall", true, ""});
    add_box(campus, "hall/walls", {12, 0, 2}, {16, 4, 6},
            {Detection::solid | Detection::ray, "hall", true, ""});
    const std::vector<Step> steps = {spawn_at({0, 0, 0}), walk_to(0, -6, "a"), walk_to(9, -6, "b"),
                                     walk_to(9, 4, "c"),  turn_to(-90),        wait_for(1.0),
                                     walk_to(0, 0, "d")};
    const RecordedRun by_30 = run_at(30, campus, steps);
    const RecordedRun by_60 = run_at(60, campus, steps);
    const RecordedRun by_120 = run_at(120, campus, steps);
    EXPECT_TRUE(by_30.summary.passed);

    // Every path turns within kWithin of every corner, so two of them are at most twice that apart.
    for (const RecordedRun* other : {&by_60, &by_120}) {
        for (const Recorder::TickState& state : by_30.recorder.states()) {
            ASSERT_LE(distance_to_path(state.avatar.position, other->recorder.states()), 2.0 * kWithin);
        }
    }
    // The same contacts in the same order; how many stays there are depends on the clock.
    const auto contacts = [](const RecordedRun& result) {
        std::vector<std::string> lines = result.recorder.event_lines();
        std::erase_if(lines,
                      [](const std::string& line) { return line.find(".stay ") != std::string::npos; });
        return lines;
    };
    // Enter, open, close and exit of the door and twice of the walls (in passing while the avatar turns
    // towards its target, then on purpose), and four arrivals.
    EXPECT_EQ(contacts(by_30).size(), 16U);
    EXPECT_EQ(contacts(by_30), contacts(by_60));
    EXPECT_EQ(contacts(by_30), contacts(by_120));

    // Each of the six steps ends at the end of a tick: at most a tick of the slower rate late, and earlier or
    // later by the length of the corner that was cut.
    const double late = 6.0 * (1.0 / 30.0 + 2.0 * kWithin / kSpeed);
    const auto times = [](const RecordedRun& result, double rate) {
        std::vector<double> found;
        for (const Event& event : result.recorder.events()) {
            if (event_line(event).find(".stay ") == std::string::npos) {
                found.push_back(static_cast<double>(event.tick) / rate);
            }
        }
        return found;
    };
    const std::vector<double> times_30 = times(by_30, 30.0);
    const std::vector<double> times_120 = times(by_120, 120.0);
    ASSERT_EQ(times_30.size(), times_120.size());
    for (std::size_t i = 0; i < times_30.size(); ++i) {
        EXPECT_NEAR(times_30[i], times_120[i], late) << event_line(by_30.recorder.events()[i]);
    }
}

TEST(TickRate, DefinesTimeAsTicksOverRate) {
    for (const int rate : {30, 60, 120, 7}) {
        const RecordedRun result = run_at(rate, level_campus(), {spawn_at({0, 0, 0}), wait_for(3.0)});
        EXPECT_EQ(result.summary.ticks, 3 * rate);
        for (const Recorder::TickState& state : result.recorder.states()) {
            ASSERT_EQ(state.time, static_cast<double>(state.tick) / rate);
        }
    }
}

}  // namespace
}  // namespace campuswalk::engine

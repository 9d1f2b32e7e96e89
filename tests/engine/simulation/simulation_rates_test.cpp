#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/engine/short_walk.h"
#include "tests/engine/small_campus.h"

// The same walk at 30, 60 and 120 ticks a second.

namespace campuswalk::engine {
namespace {

using collision::Detection;
using Eigen::Vector3d;

constexpr double kSpeed = 1.4;
constexpr double kWithin = 0.05;

Outing run_at(int rate, const scene::Campus& campus, std::vector<Step> steps) {
    Walk walk = walk_of(std::move(steps));
    walk.sim.ticks_per_second = rate;
    return run(campus, walk);
}

double distance_to_segment(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
    const Vector3d way = b - a;
    const double length2 = way.squaredNorm();
    const double part = length2 > 0.0 ? std::clamp((p - a).dot(way) / length2, 0.0, 1.0) : 0.0;
    return (a + part * way - p).norm();
}

double distance_to_path(const Vector3d& p, const std::vector<Recorder::Frame>& frames) {
    double nearest = 1e300;
    for (std::size_t i = 1; i < frames.size(); ++i) {
        nearest = std::min(nearest,
                           distance_to_segment(p, frames[i - 1].avatar.position, frames[i].avatar.position));
    }
    return nearest;
}

TEST(Rates, GiveOneStraightWalk) {
    const scene::Campus campus = level_campus();
    const Outing slow = run_at(30, campus, {spawn_at({0, 0, 0}), walk_to(0, -10)});
    const Outing fast = run_at(120, campus, {spawn_at({0, 0, 0}), walk_to(0, -10)});
    for (const Recorder::Frame& frame : slow.recorder.frames()) {
        if (frame.tick < 200) {  // before either arrives
            const AvatarState& other = fast.recorder.at(4 * frame.tick);
            ASSERT_NEAR((frame.avatar.position - other.position).norm(), 0.0, 1e-9) << frame.time;
        }
    }
}

TEST(Rates, GiveOneTour) {
    scene::Campus campus = level_campus();
    add_building(campus, "hall");
    add_box(campus, "hall/door", {4, 0, -7}, {8, 2, -5}, {Detection::trigger, "hall", true, ""});
    add_box(campus, "hall/walls", {12, 0, 2}, {16, 4, 6},
            {Detection::solid | Detection::ray, "hall", true, ""});
    const std::vector<Step> steps = {spawn_at({0, 0, 0}), walk_to(0, -6, "a"), walk_to(9, -6, "b"),
                                     walk_to(9, 4, "c"),  turn_to(-90),        wait_for(1.0),
                                     walk_to(0, 0, "d")};
    const Outing by_30 = run_at(30, campus, steps);
    const Outing by_60 = run_at(60, campus, steps);
    const Outing by_120 = run_at(120, campus, steps);
    EXPECT_TRUE(by_30.summary.passed);

    // Every path turns within kWithin of every corner, so two of them are nowhere farther apart than that
    // twice.
    for (const Outing* other : {&by_60, &by_120}) {
        for (const Recorder::Frame& frame : by_30.recorder.frames()) {
            ASSERT_LE(distance_to_path(frame.avatar.position, other->recorder.frames()), 2.0 * kWithin);
        }
    }
    // One event a contact, in one order; stays are a clock's.
    const auto contacts = [](const Outing& outing) {
        std::vector<std::string> told_events = outing.recorder.story();
        std::erase_if(told_events,
                      [](const std::string& words) { return words.find(".stay ") != std::string::npos; });
        return told_events;
    };
    // Enter, open, close and exit of the door and twice of the walls (in passing while it turns into its way,
    // then on purpose), and four arrivals.
    EXPECT_EQ(contacts(by_30).size(), 16U);
    EXPECT_EQ(contacts(by_30), contacts(by_60));
    EXPECT_EQ(contacts(by_30), contacts(by_120));

    // Each of six steps ends on a tick's end: at most a tick of the slower rate late each, and as much
    // earlier or later as the corner that was cut is long.
    const double late = 6.0 * (1.0 / 30.0 + 2.0 * kWithin / kSpeed);
    const auto times = [](const Outing& outing, double rate) {
        std::vector<double> found;
        for (const Event& event : outing.recorder.events()) {
            if (told(event).find(".stay ") == std::string::npos) {
                found.push_back(static_cast<double>(event.tick) / rate);
            }
        }
        return found;
    };
    const std::vector<double> times_30 = times(by_30, 30.0);
    const std::vector<double> times_120 = times(by_120, 120.0);
    ASSERT_EQ(times_30.size(), times_120.size());
    for (std::size_t i = 0; i < times_30.size(); ++i) {
        EXPECT_NEAR(times_30[i], times_120[i], late) << told(by_30.recorder.events()[i]);
    }
}

TEST(Rates, KeepTimeAsTicksOverTheRate) {
    for (const int rate : {30, 60, 120, 7}) {
        const Outing outing = run_at(rate, level_campus(), {spawn_at({0, 0, 0}), wait_for(3.0)});
        EXPECT_EQ(outing.summary.ticks, 3 * rate);
        for (const Recorder::Frame& frame : outing.recorder.frames()) {
            ASSERT_EQ(frame.time, static_cast<double>(frame.tick) / rate);
        }
    }
}

}  // namespace
}  // namespace campuswalk::engine

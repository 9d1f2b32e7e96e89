#include "tools/campuswalk_bench/walk/walk_paths.h"

#include <cmath>

#include "tools/campuswalk_bench/measure/heap.h"
#include "tools/campuswalk_bench/measure/shuffled_runs.h"

namespace campuswalk::tools::bench {

using collision::Vec3;

namespace {

constexpr double kArrived = 0.2;    ///< metres, horizontal
constexpr double kSameFloor = 0.5;  ///< metres, vertical

/// The time limit for a goal, coming from `from`.
std::size_t ticks_allowed(const Vec3& from, const WalkGoal& goal, const WalkBody& body) {
    const double straight = (goal.at - from).norm() / body.speed;
    const double seconds = goal.forbidden ? straight + 3.0 : 1.6 * straight + 2.0;
    return static_cast<std::size_t>(std::ceil(seconds / body.tick));
}

bool is_at(const WalkGoal& goal, const Vec3& foot) {
    const Vec3 away = goal.at - foot;
    return Vec3(away.x(), 0.0, away.z()).norm() <= kArrived && std::abs(away.y()) <= kSameFloor;
}

Vec3 desired_for(const WalkGoal& goal, const Vec3& foot, const WalkBody& body) {
    const Vec3 to_goal(goal.at.x() - foot.x(), 0.0, goal.at.z() - foot.z());
    const double length = to_goal.norm();
    const double most = body.speed * body.tick;
    return length > most ? Vec3(most / length * to_goal) : to_goal;
}

}  // namespace

WalkRecord empty_record(const WalkPath& path, const WalkBody& body) {
    WalkRecord record;
    std::size_t most = 0;
    Vec3 from = path.start;
    for (const WalkGoal& goal : path.goals) {
        most += ticks_allowed(from, goal, body);
        from = goal.at;
    }
    record.ticks.reserve(most);
    record.arrived.reserve(path.goals.size());
    return record;
}

void walk_path(WalkEngine& engine, const WalkPath& path, const WalkBody& body, WalkRecord& record) {
    record.ticks.clear();
    record.arrived.clear();
    engine.place(path.start);
    record.start = engine.foot();
    const std::size_t heap_before = heap_in_use();
    Vec3 from = path.start;
    for (const WalkGoal& goal : path.goals) {
        bool arrived = false;
        for (std::size_t left = ticks_allowed(from, goal, body); left > 0 && !arrived; --left) {
            const Vec3 desired = desired_for(goal, engine.foot(), body);
            const double us = microseconds_of([&] { engine.walk(desired); });
            record.ticks.push_back({engine.foot(), us});
            arrived = is_at(goal, record.ticks.back().foot);
        }
        record.arrived.push_back(arrived ? 1 : 0);
        from = goal.at;
    }
    const std::size_t heap_after = heap_in_use();
    record.heap_growth = heap_after > heap_before ? heap_after - heap_before : 0;
}

}  // namespace campuswalk::tools::bench

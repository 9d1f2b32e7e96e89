#include "tests/engine/walkspace/barrier/explored_barrier.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "collision/world/bullet_broad_phase.h"
#include "engine/walkspace/explore/campus_settings.h"
#include "engine/walkspace/report/walk_report.h"
#include "tests/engine/short_walk.h"

namespace campuswalk::engine {

using collision::Vec3;

namespace {

WalkReport report_from_start(const scene::Campus& campus, std::size_t workers) {
    const WorkerWorlds worlds(campus.world, workers, collision::make_bullet_broad_phase);
    ExploreSettings settings = explore_settings(campus, AvatarProfile(), 60);
    settings.starts = {{0, 0, 5}};
    return report_walks(campus, AvatarProfile(), worlds, settings);
}

}  // namespace

Barrier explored_barrier(scene::Campus& campus, const Vec3& place) {
    scene::Place& goal = campus.description.places.emplace_back();
    goal.name = "goal";
    goal.position = place;
    goal.has_height = true;
    const WalkReport report = report_from_start(campus, 1);
    campus.description.places.pop_back();
    for (const SubjectReport& entry : report.subjects) {
        if (entry.subject.kind == SubjectKind::place && entry.subject.island) {
            return report.islands[*entry.subject.island].barrier.value_or(Barrier());
        }
    }
    ADD_FAILURE() << "the place is on no island";
    return {};
}

Barrier barrier_of_ground(const scene::Campus& campus, const Vec3& place, std::size_t workers) {
    const WalkReport report = report_from_start(campus, workers);
    const auto nearest = std::ranges::min_element(report.islands, {}, [&](const IslandReport& entry) {
        return (entry.island.nearest_to(place) - place).norm();
    });
    if (nearest == report.islands.end()) {
        ADD_FAILURE() << "there is no island";
        return {};
    }
    return nearest->barrier.value_or(Barrier());
}

std::string reason_to_go(const scene::Campus& campus, const Vec3& place) {
    GoToStep step;
    step.target = {"goal", place, true};
    const RecordedRun result = run(campus, walk_of({spawn_at({0, 0, 5}), step}));
    return result.summary.failures.empty() ? "" : result.summary.failures.front().message;
}

}  // namespace campuswalk::engine

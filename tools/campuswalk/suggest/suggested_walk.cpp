#include "tools/campuswalk/suggest/suggested_walk.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <thread>
#include <utility>

#include "collision/world/bullet_broad_phase.h"
#include "collision/world/cast.h"
#include "engine/record/observer.h"
#include "engine/simulation/run_walk.h"
#include "engine/walkspace/route/route_facts.h"
#include "scene/base/atomic_file.h"
#include "tools/campuswalk/base/report_diagnostics.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;
using Eigen::Vector3d;

namespace {

/// Keeps where the feet are, by the step of the walk.
class Footprints : public engine::Observer {
public:
    void on_tick(const engine::TickRecord& record) override {
        const std::size_t visit = std::max<std::size_t>(record.steps_over, 1) - 1;  // the first is the spawn
        if (visit >= paths.size()) {
            paths.resize(visit + 1);
        }
        paths[visit].push_back(record.avatar.position);
    }

    std::vector<std::vector<Vector3d>> paths;
};

/// The part of a way on which it comes into the building: from beside its walls to inside.
std::vector<Vector3d> entry_of(const std::vector<Vector3d>& path, const scene::SuggestedBuilding& building) {
    constexpr double kBeside = 0.5;  // metres before the walls
    const auto depth_at = [&](const Vector3d& foot) {
        return building.box.depth_of(foot + kWaist * Vector3d::UnitY());
    };
    const std::optional<scene::UprightBox> inside = trigger_inside(building);
    const auto last = std::ranges::find_if(path, [&](const Vector3d& foot) {
        return inside && inside->depth_of(foot + kWaist * Vector3d::UnitY()) >= 0.0;
    });
    if (last == path.end()) {
        return {};
    }
    auto first = last;
    while (first != path.begin() && depth_at(*first) > -kBeside) {
        --first;
    }
    return std::vector<Vector3d>(first, last + 1);
}

/// Where a visitor passes from one side to the other.
struct Passage {
    Vector3d foot;
    double width = 0.0;  ///< metres
    Vector3d ahead;      ///< level, of length 1
};

constexpr double kWidestDoorway = 2.5;  // metres: a double door

/// The direction in which the way passes there, level.
Vector3d direction_at(const std::vector<Vector3d>& path, const Vector3d& place) {
    constexpr double kAround = 0.2;  // metres
    const auto nearest = std::ranges::min_element(
        path, {}, [&](const Vector3d& foot) { return (foot - place).squaredNorm(); });
    auto before = nearest;
    auto behind = nearest;
    while (before != path.begin() && (*before - *nearest).norm() < kAround) {
        --before;
    }
    while (behind + 1 != path.end() && (*behind - *nearest).norm() < kAround) {
        ++behind;
    }
    Vector3d ahead = *behind - *before;
    ahead.y() = 0.0;
    return ahead.isZero(0.0) ? Vector3d::UnitZ().eval() : ahead.normalized();
}

/// The narrowest place of a way, if that is narrow enough for a doorway.
std::optional<Passage> doorway_on(const std::vector<Vector3d>& path, const scene::Campus& campus,
                                  const engine::ExploreSettings& settings) {
    if (path.size() < 2) {
        return std::nullopt;
    }
    engine::Route route;
    route.path = path;
    const auto narrowest =
        engine::facts_of(route, campus.world, settings.strides.body, settings.solids).narrowest;
    return narrowest && narrowest->value < kWidestDoorway
               ? std::optional(Passage{narrowest->at, narrowest->value, direction_at(path, narrowest->at)})
               : std::nullopt;
}

/// The opening of the wall where the entry passes it, by rays along the wall: an entry that passes obliquely
/// has no jambs to its left and right.
std::optional<Passage> opening_of(const std::vector<Vector3d>& entry,
                                  const scene::SuggestedBuilding& building, const scene::Campus& campus) {
    constexpr double kDeepest = 0.6;  // metres behind the wall's face
    constexpr double kStep = 0.1;     // metres
    const scene::UprightBox& box = building.box;
    const auto passes = std::ranges::find_if(
        entry, [&](const Vector3d& foot) { return box.depth_of(foot + kWaist * Vector3d::UnitY()) >= 0.0; });
    if (passes == entry.end()) {
        return std::nullopt;
    }
    const Vector3d from_center = *passes - box.center;
    const double beside = 0.5 * box.size.x() - std::abs(from_center.dot(box.along));
    const double before = 0.5 * box.size.z() - std::abs(from_center.dot(box.across()));
    const Vector3d axis = beside < before ? box.along : box.across();
    const Vector3d ahead = from_center.dot(axis) > 0.0 ? Vector3d(-axis) : axis;
    const Vector3d sideways(ahead.z(), 0.0, -ahead.x());
    std::optional<Passage> narrowest;
    for (double deep = 0.0; deep <= kDeepest; deep += kStep) {
        const Vector3d foot = *passes + deep * ahead;
        const Vector3d waist = foot + kWaist * Vector3d::UnitY();
        const auto free = [&](const Vector3d& side) {
            const auto hit = collision::cast(campus.world, {}, {waist, waist + kWidestDoorway * side},
                                             collision::Detection::solid);
            return kWidestDoorway * (hit ? hit->fraction : 1.0);
        };
        const double left = free(sideways);
        const double right = free(-sideways);
        if (left + right < (narrowest ? narrowest->width : kWidestDoorway)) {
            narrowest = Passage{foot + 0.5 * (left - right) * sideways, left + right, ahead};
        }
    }
    return narrowest;
}

/// Whether a visitor gets there although nobody stands in the doorway.
bool is_reached_otherwise(const engine::WorkerWorlds& worlds, engine::ExploreSettings settings,
                          const Vector3d& goal, const Passage& doorway) {
    constexpr double kHalfDepth = 0.45;  // metres: more than a stride of the exploration
    constexpr double kJambs = 0.3;       // metres on either side
    constexpr double kHeight = 2.0;      // metres, up and down
    constexpr double kNear = 0.6;        // metres from the goal
    const Vector3d across(doorway.ahead.z(), 0.0, -doorway.ahead.x());
    settings.keep_out = [&, is_left_out = settings.keep_out](const Vector3d& foot) {
        const Vector3d there = foot - doorway.foot;
        return (is_left_out && is_left_out(foot)) ||
               (std::abs(there.dot(doorway.ahead)) < kHalfDepth && std::abs(there.y()) < kHeight &&
                std::abs(there.dot(across)) < doorway.width + kJambs);
    };
    const engine::WalkGrid grid = settings.grid.value();
    const engine::UntilCell there{[&](const engine::GridCell& cell, double y) {
        Vector3d foot = grid.center(cell);
        foot.y() = y;
        return (foot - goal).norm() < kNear;
    }};
    return engine::explore(worlds, settings, there).goal.has_value();
}

/// The building that the visit leads into, or whose room it leads to.
const scene::SuggestedBuilding* entered_by(const SuggestedVisit& visit, const SuggestedCampus& campus) {
    const auto found = std::ranges::find_if(campus.buildings, [&](const scene::SuggestedBuilding& building) {
        return visit.trigger.starts_with(building.id + "/") && !visit.trigger.ends_with(kAroundTrigger);
    });
    return found == campus.buildings.end() ? nullptr : &*found;
}

}  // namespace

PlayedWalk play_visits(const SuggestedCampus& campus, const fs::path& campus_file, const fs::path& walk_file,
                       WalkLoader& loader) {
    for (std::size_t visits = campus.visits.size();; --visits) {
        scene::write_file_atomically(walk_file, walk_yaml(campus, campus_file.filename().string(), visits));
        const LoadedWalk loaded = loader.load_walk(walk_file);
        Footprints feet;
        engine::Observer* const observers[] = {&feet};
        const engine::WalkSummary summary = engine::run_walk(*loaded.campus, loaded.walk, observers);
        if (summary.passed) {
            feet.paths.resize(visits);
            const double seconds = static_cast<double>(summary.ticks) / loaded.walk.sim.ticks_per_second;
            return {visits, seconds, std::move(feet.paths), loaded.campus};
        }
        if (visits == 0) {
            throw error_about(campus.scene.file, "no-ground",
                              "no place was found where a visitor stays standing");
        }
    }
}

std::vector<SuggestedDoorway> try_doorways(const PlayedWalk& walk, const SuggestedCampus& campus,
                                           const engine::ExploreSettings& settings) {
    const engine::WorkerWorlds worlds(walk.campus->world, std::max(1U, std::thread::hardware_concurrency()),
                                      collision::make_bullet_broad_phase);
    std::vector<SuggestedDoorway> doorways;
    for (std::size_t v = 0; v < walk.visits; ++v) {
        const SuggestedVisit& visit = campus.visits[v];
        const scene::SuggestedBuilding* building = entered_by(visit, campus);
        if (building == nullptr) {
            continue;
        }
        const bool enters = visit.trigger.ends_with(kInsideTrigger);
        const std::vector<Vector3d> entry = enters ? entry_of(walk.paths[v], *building) : walk.paths[v];
        std::optional<Passage> doorway = doorway_on(entry, *walk.campus, settings);
        if (!doorway && enters) {
            doorway = opening_of(entry, *building, *walk.campus);
        }
        if (doorway) {
            const bool is_other = is_reached_otherwise(worlds, settings, visit.to, *doorway);
            doorways.push_back({v, doorway->foot, doorway->width, !is_other});
        }
    }
    return doorways;
}

}  // namespace campuswalk::tools

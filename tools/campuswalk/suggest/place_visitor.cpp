#include "tools/campuswalk/suggest/place_visitor.h"

#include <algorithm>
#include <memory>
#include <thread>
#include <vector>

#include "collision/world/bullet_broad_phase.h"
#include "engine/events/decimals.h"
#include "engine/script/walk.h"
#include "engine/walkspace/explore/campus_settings.h"
#include "engine/walkspace/report/crowded_places.h"
#include "engine/walkspace/report/start_place.h"
#include "engine/walkspace/report/walk_report.h"
#include "scene/suggest/first_view.h"
#include "tools/campuswalk/suggest/interiors.h"
#include "tools/campuswalk/suggest/plan_visits.h"

namespace campuswalk::tools {

using Eigen::Vector3d;

namespace {

constexpr double kMinGround = 4.0;  // m²
/// Less ground that isn't reached from the spawn has no spawn of its own.
constexpr double kMinOther = 10.0;  // m²
/// Without a building or a place to go to, visits are as near as that, metres.
constexpr double kFarthestStroll = 8.0;
/// A spawn is at least this far outside of the buildings' triggers, if possible.
constexpr double kOutside = 0.5;  // metres

const scene::SuggestedBuilding* nearest_building(const std::vector<scene::SuggestedBuilding>& buildings,
                                                 const Vector3d& place) {
    const auto nearest = std::ranges::min_element(
        buildings, {}, [&](const scene::SuggestedBuilding& b) { return (b.box.center - place).norm(); });
    return nearest == buildings.end() ? nullptr : &*nearest;
}

/// A place for the visitor is looked for this far around the middle.
constexpr double kHalfExtent = 75.0;  // metres

engine::ExploreSettings settings_around(const scene::Campus& campus, const Vector3d& middle) {
    engine::ExploreSettings settings =
        engine::explore_settings(campus, engine::AvatarProfile(), engine::SimSettings().ticks_per_second);
    settings.within = campus.world.bounds().grown(1.0);
    settings.within.min = settings.within.min.cwiseMax(
        Vector3d(middle.x() - kHalfExtent, settings.within.min.y(), middle.z() - kHalfExtent));
    settings.within.max = settings.within.max.cwiseMin(
        Vector3d(middle.x() + kHalfExtent, settings.within.max.y(), middle.z() + kHalfExtent));
    return settings;
}

std::vector<engine::KnownDoor> doors_in(const scene::ModelReport& report) {
    std::vector<engine::KnownDoor> doors;
    for (const scene::Door& door : report.doors) {
        doors.push_back({door.foot, door.width});
    }
    return doors;
}

/// Whether the place is on the roof of one of several buildings, which may have no bottom, and no ground
/// below.
bool is_on_top(const std::vector<scene::SuggestedBuilding>& buildings, const scene::Bounds& all,
               const Vector3d& foot) {
    constexpr double kMost = 0.5;    // of the plan: what is larger is the place itself
    constexpr double kTop = 0.8;     // of its height
    constexpr double kLowest = 2.0;  // metres: what is lower is a step or a stage
    return std::ranges::any_of(buildings, [&](const scene::SuggestedBuilding& building) {
        const scene::UprightBox& box = building.box;
        const double height = foot.y() - (box.center.y() - 0.5 * box.size.y());
        const Vector3d size = all.max - all.min;
        return box.footprint() < kMost * size.x() * size.z() &&
               height > std::max(kLowest, kTop * box.size.y()) &&
               box.depth_of({foot.x(), box.center.y(), foot.z()}) >= 0.0;
    });
}

/// Whether somebody gets to the place or close to it.
bool is_reached(const engine::WalkSpace& reached, const Vector3d& foot) {
    const Vector3d near(0.5, 0.5, 0.5);  // metres
    return !reached.nodes_in({foot - near, foot + near}).empty();
}

SuggestedInterior as_written(const Interior& interior) {
    SuggestedInterior written{interior.place.has_value(), {}};
    for (const SuggestedRoom& room : interior.rooms) {
        written.rooms.push_back(room.box);
    }
    return written;
}

}  // namespace

std::optional<engine::ExploreSettings> place_visitor(const scene::ModelReport& report,
                                                     const scene::Campus& solid, SuggestedCampus& campus) {
    Vector3d middle = report.bounds.center();
    if (const auto* building = nearest_building(campus.buildings, middle)) {
        middle = building->box.center;
    }
    engine::ExploreSettings settings = settings_around(solid, middle);
    const engine::WorkerWorlds worlds(solid.world, std::max(1U, std::thread::hardware_concurrency()),
                                      collision::make_bullet_broad_phase);
    const auto crowded = std::make_shared<const engine::CrowdedPlaces>(solid.world, settings);
    if (crowded->limit()) {
        settings.keep_out = [crowded](const Vector3d& foot) { return crowded->contains(foot); };
    }
    campus.most_triangles = crowded->limit();
    const auto is_inside = [&](const Vector3d& foot) {
        return std::ranges::any_of(campus.buildings, [&](const scene::SuggestedBuilding& building) {
            return trigger_about(building).depth_of(foot) > -kOutside;
        });
    };
    const std::vector<engine::StartPlace> starts = engine::best_starts(worlds, settings, {middle, is_inside});
    if (starts.empty()) {
        return std::nullopt;
    }
    const engine::StartPlace& spawn = starts.front();
    settings.starts = {spawn.foot};
    settings.steer_falls = false;  // visitors don't jump off roofs
    const bool has_goals = !campus.buildings.empty() || campus.places.has_value();
    const double far = has_goals ? kFarthestVisit : kFarthestStroll;
    settings.max_ticks =
        static_cast<std::uint32_t>(far / settings.strides.walk_speed / settings.strides.seconds);
    const engine::WalkSpace reached = engine::explore(worlds, settings);
    if (reached.area() < kMinGround) {
        return std::nullopt;
    }
    settings.grid = reached.grid;
    const auto is_aside = [&](const engine::StartPlace& start) {
        return start.is_aside || is_on_top(campus.buildings, report.bounds, start.foot);
    };
    const auto yaw_deg_at = [&](const Vector3d& foot) {
        const auto* target = nearest_building(campus.buildings, foot);
        return engine::degrees(
            scene::first_view(solid.world, foot, target == nullptr ? middle : target->box.center));
    };
    campus.spawn = spawn.foot;
    campus.starts_aside = is_aside(spawn);
    campus.yaw_deg = yaw_deg_at(spawn.foot);
    campus.more_spawns.clear();
    for (const engine::StartPlace& other : starts) {
        if (other.area >= kMinOther && !is_aside(other) && !is_reached(reached, other.foot)) {
            campus.more_spawns.push_back({other.foot, yaw_deg_at(other.foot), other.area});
        }
    }
    engine::Strider strider(worlds[0], settings.strides, settings.solids);
    const auto interiors = find_interiors(solid, reached, campus.buildings, doors_in(report));
    for (std::size_t b = 0; b < interiors.size(); ++b) {
        campus.interiors[b] = as_written(interiors[b]);
    }
    campus.visits = plan_visits(reached, strider, campus.spawn, campus.buildings, interiors);
    add_place_visits(reached, strider, campus.spawn, solid.description.places, campus.visits);
    return settings;
}

}  // namespace campuswalk::tools

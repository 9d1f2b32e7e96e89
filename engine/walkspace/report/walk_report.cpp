#include "engine/walkspace/report/walk_report.h"

#include <algorithm>
#include <utility>

#include "engine/walkspace/barrier/hollows.h"
#include "engine/walkspace/barrier/island_barriers.h"
#include "engine/walkspace/stride/removable_nodes.h"
#include "engine/walkspace/stride/worker_threads.h"

namespace campuswalk::engine {

namespace {

/// None if whatever could be said of it would be a guess: there is more to explore, or too much to look at.
std::vector<Island> unreached_ground(const WorkerWorlds& worlds, const ExploreSettings& settings,
                                     WalkSpace& reached) {
    if (reached.is_cut_by(Bound::nodes)) {
        return {};
    }
    auto islands =
        find_unreached_ground(worlds, settings, reached, 0.0, std::min(kMostUnreached, settings.max_nodes));
    if (!islands) {
        reached.bounds.push_back(Bound::islands);
    }
    return std::move(islands).value_or(std::vector<Island>());
}

/// The most islands that are explained: those that are worth a line or that a subject is on.
std::size_t explained(const std::vector<Island>& islands, const std::vector<Subject>& subjects,
                      const WalkGrid& grid) {
    std::size_t count = 0;
    while (count < islands.size() && islands[count].area(grid) > kNotableIsland) {
        ++count;
    }
    for (const Subject& subject : subjects) {
        count = std::max(count, subject.island ? *subject.island + 1 : 0);  // a door's counts already
    }
    return count;
}

/// By island: whether somebody wants to get there.
std::vector<bool> wanted(const std::vector<Island>& islands, const std::vector<Subject>& subjects) {
    std::vector<bool> is_wanted(islands.size(), false);
    for (const Subject& subject : subjects) {
        if (subject.island && is_destination(subject.kind)) {
            is_wanted[*subject.island] = true;
        }
    }
    return is_wanted;
}

/// An object that is no larger may be a door, metres.
constexpr double kLargestDoor = 5.0;

/// Seen from above.
bool surrounds(const collision::Aabb& shell, const Island& island) {
    const collision::Aabb& inside = island.bounds;
    return shell.min.x() <= inside.min.x() && shell.max.x() >= inside.max.x() &&
           shell.min.z() <= inside.min.z() && shell.max.z() >= inside.max.z();
}

/// Of a barrier that is a node.
bool is_wall(const collision::World& world, const scene::NodeTriangles& nodes, const Barrier& barrier) {
    const auto triangles = nodes.of_same_node(*barrier.object, barrier.triangle);
    if (!triangles) {
        return false;
    }
    const collision::Aabb bounds = bounds_of(world, *barrier.object, *triangles);
    return (bounds.max - bounds.min).norm() > kSmallNode;
}

/// Whether the barrier may be the shell of a hollow: nothing helps, or only to take away a whole wall, or all
/// of an object that surrounds the island. A room whose door stands in the way is none.
bool may_be_shell(const collision::World& world, const scene::NodeTriangles& nodes, const Barrier& barrier,
                  const Island& island) {
    switch (barrier.kind) {
        case ReasonKind::solid:
        case ReasonKind::ledge:
            return true;
        case ReasonKind::object:
            return barrier.is_node ? is_wall(world, nodes, barrier)
                                   : surrounds(world.bounds(*barrier.object), island);
        case ReasonKind::sequence:
            return std::ranges::any_of(
                barrier.parts, [&](const Barrier& part) { return may_be_shell(world, nodes, part, island); });
        default:
            return false;
    }
}

/// By object: what is disabled, and all that may be a door's leaf or stand in a doorway. Objects that
/// surround the island stay.
std::vector<bool> disabled_or_door(const collision::World& world, const ExploreSettings& settings,
                                   const Island& island) {
    std::vector<bool> disabled(world.size(), false);
    for (std::size_t i = 0; i < world.size(); ++i) {
        const collision::Aabb& box = world.bounds(static_cast<collision::ObjectId>(i));
        const bool is_small = (box.max - box.min).maxCoeff() <= kLargestDoor;
        disabled[i] = (settings.solids.disabled != nullptr && (*settings.solids.disabled)[i]) ||
                      (is_small && !surrounds(box, island));
    }
    return disabled;
}

/// A room is no hollow though its door has two leaves, or leads to another room that is closed.
bool is_hollow(const collision::World& world, ExploreSettings settings, const WalkSpace& reached,
               const scene::NodeTriangles& nodes, const IslandReport& entry) {
    if (entry.barrier && !may_be_shell(world, nodes, *entry.barrier, entry.island)) {
        return false;
    }
    const std::vector<bool> disabled = disabled_or_door(world, settings, entry.island);
    settings.solids.disabled = &disabled;
    return is_enclosed(world, settings, reached, entry.island);
}

void find_hollows(const WorkerWorlds& worlds, const ExploreSettings& settings,
                  const scene::NodeTriangles& nodes, WalkReport& report) {
    for_each_item(report.islands.size(), worlds.size(), [&](std::size_t worker, std::size_t i) {
        IslandReport& entry = report.islands[i];
        entry.hollow = entry.island.area(report.space.grid) > kNotableIsland &&
                       is_hollow(worlds[worker], settings, report.space, nodes, entry);
    });
}

void report_subjects(const WorkerWorlds& worlds, const ExploreSettings& settings,
                     const std::vector<Subject>& subjects, WalkReport& report) {
    for (const Subject& subject : subjects) {
        report.subjects.push_back({subject, std::nullopt});
    }
    std::vector<Strider> striders;
    for (std::size_t i = 0; i < worlds.size(); ++i) {
        striders.emplace_back(worlds[i], settings.strides, settings.solids);
    }
    for_each_item(subjects.size(), worlds.size(), [&](std::size_t worker, std::size_t i) {
        if (subjects[i].node && subjects[i].kind != SubjectKind::solid) {
            report.subjects[i].distance = length_of(report.space.chain(*subjects[i].node, striders[worker]));
        }
    });
}

}  // namespace

WalkReport report_walks(const scene::Campus& campus, const AvatarProfile& avatar, const WorkerWorlds& worlds,
                        ExploreSettings settings, double min_width,
                        const std::function<void(const ReportStage&)>& on_stage) {
    const bool looks_for_narrow = min_width > 2.0 * settings.strides.body.radius;
    ReportStage stage{.number = 0, .count = looks_for_narrow ? 6 : 5, .text = {}};
    const auto tell = [&](std::string text) {
        ++stage.number;
        stage.text = std::move(text);
        if (on_stage) {
            on_stage(stage);
        }
    };
    settings.keep_rim = true;
    tell("exploring");
    WalkReport report{explore(worlds, settings)};
    tell("looking for ground that isn't reached");
    report.storeys = find_storeys(report.space);
    std::vector<Island> islands = unreached_ground(worlds, settings, report.space);
    const std::vector<Subject> subjects =
        find_subjects({campus, avatar, worlds, settings, report.space, islands});
    const scene::NodeTriangles nodes(campus, campus.world.bounds());
    const std::size_t asked = explained(islands, subjects, report.space.grid);
    tell("finding out why ground isn't reached (islands: " + std::to_string(asked) + ")");
    std::vector<std::optional<Barrier>> barriers = find_island_barriers(
        worlds, settings, report.space, islands, asked, &nodes, wanted(islands, subjects));
    barriers.resize(islands.size());
    for (std::size_t i = 0; i < islands.size(); ++i) {
        report.islands.push_back({std::move(islands[i]), std::move(barriers[i])});
    }
    find_hollows(worlds, settings, nodes, report);
    report_subjects(worlds, settings, subjects, report);
    tell("looking for traps");
    report.traps = find_traps(worlds, settings, report.space);
    find_trap_barriers(worlds, settings, report.space, nodes, report.traps);
    tell("looking at triggers, and for hot spots");
    report.holes = find_holes(report.space);
    report.overhangs = find_trigger_overhangs(campus, worlds, settings, report.space, report.storeys);
    report.hot_spots = find_hot_spots(worlds, settings, report.space);
    report.separate = find_separate_grounds(report.space, settings.strides.body.step_height);
    if (looks_for_narrow) {
        tell("looking for narrow passages");
        report.narrow = find_narrow_passages(worlds, settings, report.space, min_width, &nodes);
        report.bottlenecks = find_bottlenecks(worlds, settings, report.space, min_width);
    }
    return report;
}

}  // namespace campuswalk::engine

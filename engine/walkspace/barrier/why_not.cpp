#include "engine/walkspace/barrier/why_not.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "engine/walkspace/barrier/ability_meter.h"
#include "engine/walkspace/barrier/obstacle_remover.h"
#include "engine/walkspace/barrier/passage_probe.h"
#include "engine/walkspace/barrier/smallest_change.h"
#include "engine/walkspace/stride/removable_nodes.h"

namespace campuswalk::engine {

namespace {

Barrier closed_off(const PassageQuery& query) {
    Barrier barrier;
    barrier.from = query.from.empty() ? collision::Vec3(collision::Vec3::Zero()) : query.from.front().foot;
    barrier.at = barrier.from;
    return barrier;
}

/// Only the body changes.
std::vector<Change> changes_of_body(PassageProbe& probe, bool only_climbs) {
    AbilityMeter meter(probe);
    std::vector<Barrier> helping = meter.measure_each(climbs_of(probe.body()));
    if (!only_climbs) {
        std::ranges::move(meter.measure_each(sizes_of(probe.body())), std::back_inserter(helping));
    }
    std::vector<Change> changes;
    for (Barrier& barrier : helping) {
        changes.push_back({std::move(barrier)});
    }
    return changes;
}

/// `touched` is what the body as it is touched.
std::vector<Change> single_changes(PassageProbe& probe, ObstacleRemover& remover,
                                   std::vector<collision::ObjectId> touched) {
    AbilityMeter meter(probe);
    std::vector<Change> found;
    // Where there is another way and a body as slim and as low as can be doesn't get there, neither is tried
    // by itself. It might be enough, as a slim body falls into gaps that others walk over.
    std::optional<bool> fits_nowhere;
    for (const Ability& ability : abilities_of(probe.body())) {
        if (is_about_size(ability) && !found.empty()) {
            if (!fits_nowhere) {
                const collision::MoverSettings smallest = easiest_of(probe.body(), sizes_of(probe.body()));
                fits_nowhere = !probe.is_exhausted() && !probe.find_path(smallest);
            }
            if (*fits_nowhere) {
                continue;
            }
        }
        if (auto barrier = meter.measure(ability)) {
            found.push_back({std::move(*barrier)});
        }
    }
    remover.try_objects(std::move(touched), found);
    if (std::ranges::none_of(found, is_small_climb)) {
        remover.try_nodes(kSmallNode, found);
    }
    return found;
}

/// Where no single change is enough.
std::optional<Barrier> several_changes(PassageProbe& probe) {
    const std::function<bool()>& is_enclosed = probe.query().is_enclosed;
    if (probe.is_exhausted() || (is_enclosed && is_enclosed())) {
        return std::nullopt;
    }
    return AbilityMeter(probe).measure_together(abilities_of(probe.body()));
}

}  // namespace

bool is_one_change(ReasonKind kind) {
    switch (kind) {
        case ReasonKind::riser:
        case ReasonKind::slope:
        case ReasonKind::opening:
        case ReasonKind::headroom:
        case ReasonKind::object:
            return true;
        default:
            return false;
    }
}

WhyNot why_not(const WorkerWorlds& worlds, const ExploreSettings& settings, const PassageQuery& query) {
    PassageProbe probe(worlds, settings, query);
    if (probe.find_path_as_it_is()) {
        return Passable();
    }
    const bool only_climbs = query.changes == Changes::climbs;
    ObstacleRemover remover(probe);
    std::vector<Change> found = only_climbs || query.changes == Changes::body
                                    ? changes_of_body(probe, only_climbs)
                                    : single_changes(probe, remover, probe.touched());
    if (found.empty() && query.changes == Changes::any) {
        if (auto several = several_changes(probe)) {
            return std::move(*several);
        }
        remover.try_nodes(std::numeric_limits<double>::infinity(),
                          found);  // whole walls, if nothing else helps
    }
    if (found.empty()) {
        return only_climbs ? WhyNot(Unexplained()) : closed_off(query);
    }
    return smallest_of(std::move(found));
}

std::optional<Barrier> barrier_in(WhyNot answer) {
    auto* barrier = std::get_if<Barrier>(&answer);
    return barrier != nullptr ? std::optional(std::move(*barrier)) : std::nullopt;
}

}  // namespace campuswalk::engine

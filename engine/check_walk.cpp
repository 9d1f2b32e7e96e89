#include "engine/check_walk.h"

#include <algorithm>
#include <optional>
#include <string>

#include "collision/placement.h"
#include "engine/decimals.h"
#include "engine/events/event.h"
#include "engine/expect/event_subjects.h"
#include "engine/simulation.h"

namespace campuswalk::engine {

using Eigen::Vector3d;
using scene::Diagnostic;

namespace {

/// The complaint about a place where the avatar can't stand, if it can't.
std::optional<Diagnostic> check_place(const scene::Campus& campus, const Walk& walk, const SourceMark& mark,
                                      const std::string& label, const Vector3d& foot) {
    const AvatarProfile& a = walk.avatar;
    const collision::QueryFilter solids{collision::Detection::solid, ignored_layers(campus, a)};
    collision::QueryCounters counters;
    if (collision::free_place(campus.world, solids, foot, a.radius, a.height, kPlacementSearch, counters)) {
        return std::nullopt;
    }
    const auto object = collision::obstruction(campus.world, solids, foot, a.radius, a.height, counters);
    const std::string where = object ? "inside " + campus.objects[index_of(*object)].id : "not free";
    return Diagnostic{scene::Severity::error, mark, "spawn-blocked",
                      label + " at " + fixed(foot) + " is " + where + ": put it where a capsule of " +
                          fixed(a.radius, 2) + " m radius and " + fixed(a.height, 2) + " m height fits"};
}

std::vector<const EventPattern*> patterns_of(const Expectation& expectation) {
    std::vector<const EventPattern*> patterns;
    if (const auto* sequence = std::get_if<ExpectSequence>(&expectation)) {
        for (const EventPattern& event : sequence->events) {
            patterns.push_back(&event);
        }
    } else if (const auto* never = std::get_if<ExpectNever>(&expectation)) {
        patterns.push_back(&never->event);
    } else if (const auto* count = std::get_if<ExpectCount>(&expectation)) {
        patterns.push_back(&count->event);
    }
    return patterns;
}

/// A `never` on a mistyped name would pass for ever.
std::optional<Diagnostic> check_pattern(const EventSubjects& subjects, const EventPattern& pattern) {
    if (subjects.can_happen(pattern)) {
        return std::nullopt;
    }
    return Diagnostic{scene::Severity::error, pattern.mark, "unknown-name",
                      "'" + pattern.kind + " " + pattern.object +
                          "' can't happen: nothing of that name has such events" +
                          scene::did_you_mean(pattern.object, subjects.names(pattern))};
}

}  // namespace

std::vector<Diagnostic> check_walk(const scene::Campus& campus, const Walk& walk) {
    std::vector<Diagnostic> complaints;
    const auto add = [&](std::optional<Diagnostic> complaint) {
        if (complaint) {
            complaints.push_back(std::move(*complaint));
        }
    };
    for (const Step& step : walk.steps) {
        if (const auto* spawn = std::get_if<SpawnStep>(&step)) {
            add(check_place(campus, walk, spawn->mark, spawn->label, spawn->position));
        } else if (const auto* teleport = std::get_if<TeleportStep>(&step)) {
            add(check_place(campus, walk, teleport->mark, teleport->label, teleport->position));
        }
    }
    const EventSubjects subjects(campus, walk);
    for (const Expectation& expectation : walk.expectations) {
        for (const EventPattern* pattern : patterns_of(expectation)) {
            add(check_pattern(subjects, *pattern));
        }
    }
    return complaints;
}

}  // namespace campuswalk::engine

#include "engine/simulation/check_walk.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <variant>

#include "collision/world/placement.h"
#include "engine/events/decimals.h"
#include "engine/expect/event_subjects.h"
#include "engine/script/avatar_body.h"
#include "engine/simulation/spawn_fall.h"
#include "scene/base/diagnostic.h"
#include "scene/base/glob.h"
#include "scene/base/texts_of.h"

namespace campuswalk::engine {

using scene::Diagnostic;

namespace {

/// Finds names in steps and expectations that the campus and the walk don't have: a `never` with a mistyped
/// name would always pass. Its diagnostics are `unknown-name`.
class NameCheck {
public:
    /// All must outlive it.
    NameCheck(const scene::Campus& campus, const Walk& walk, std::vector<scene::Diagnostic>& diagnostics);

    /// Reports the mentioned events that can't happen.
    void check_events(const std::vector<Mention>& mentions) const;
    /// Reports snapshots that no step takes, and buildings that have no nodes to be seen.
    void check_images(const std::vector<Expectation>& expectations) const;

private:
    EventSubjects subjects_;
    std::vector<std::string> snapshots_;
    std::vector<std::string> visible_buildings_;
    std::vector<scene::Diagnostic>& diagnostics_;
};

void report(std::vector<scene::Diagnostic>& diagnostics, const SourceMark& mark, const std::string& message,
            const std::string& name, const std::vector<std::string>& known) {
    diagnostics.push_back(
        {scene::Severity::error, mark, "unknown-name", message + scene::did_you_mean(name, known)});
}

/// What each kind of expectation names of images.
struct ImageNames {
    const std::vector<std::string>& snapshots;
    const std::vector<std::string>& buildings;
    std::vector<scene::Diagnostic>& diagnostics;

    void operator()(const PlainExpectation&) const {}
    void operator()(const ExpectNot&) const {}
    void operator()(const ExpectLog&) const {}
    void operator()(const ExpectSnapshot& expected) const { check_snapshot(expected.name, expected.mark); }
    void operator()(const ExpectVisible& expected) const {
        check_snapshot(expected.snapshot, expected.snapshot_mark);
        const std::string& glob = expected.building.glob;
        if (std::ranges::none_of(buildings, [&](const auto& id) { return scene::glob_matches(glob, id); })) {
            report(diagnostics, expected.building.mark,
                   "no building '" + glob + "' has nodes that could be seen", glob, buildings);
        }
    }

private:
    void check_snapshot(const std::string& name, const SourceMark& mark) const {
        if (std::ranges::find(snapshots, name) == snapshots.end()) {
            report(diagnostics, mark, "no step takes a snapshot '" + name + "'", name, snapshots);
        }
    }
};

NameCheck::NameCheck(const scene::Campus& campus, const Walk& walk,
                     std::vector<scene::Diagnostic>& diagnostics)
    : subjects_(campus, walk), diagnostics_(diagnostics) {
    for (const Step& step : walk.steps) {
        if (const auto* snapshot = std::get_if<SnapshotStep>(&step)) {
            snapshots_.push_back(snapshot->name);
        }
    }
    for (const scene::Building& building : campus.description.buildings) {
        if (!building.nodes.empty()) {
            visible_buildings_.push_back(building.id);
        }
    }
}

void NameCheck::check_events(const std::vector<Mention>& mentions) const {
    for (const auto& [event, if_unknown] : mentions) {
        if (!subjects_.can_happen(event)) {
            report(diagnostics_, event.mark,
                   !if_unknown.empty() ? if_unknown
                                       : "'" + event.kind + " " + event.object +
                                             "' can't happen: nothing of that name has such events",
                   event.object, subjects_.names(event));
        }
    }
}

void NameCheck::check_images(const std::vector<Expectation>& expectations) const {
    const ImageNames names{snapshots_, visible_buildings_, diagnostics_};
    for (const Expectation& expectation : expectations) {
        std::visit(names, expectation);
    }
}

/// Follows the steps in their order: the avatar's height and the disabled objects before each of them.
class StepCheck {
public:
    StepCheck(const scene::Campus& campus, const Walk& walk)
        : campus_(campus),
          avatar_(walk.avatar),
          height_(walk.avatar.height),
          disabled_(campus.objects.size(), false),
          solids_{collision::Detection::solid, ignored_layers(campus, walk.avatar), &disabled_} {}

    /// Appends the diagnostics about the next step.
    void check(const StepPreview& step, const SourceMark& mark, std::vector<Diagnostic>& diagnostics) {
        if (step.place) {
            check_place(mark, *step.place, diagnostics);
        }
        height_ = step.height.value_or(height_);
        if (step.switched) {
            for (const NamePattern& pattern : step.switched->objects) {
                switch_objects(pattern, step.switched->enabled, diagnostics);
            }
        }
        for (const NamePattern& pattern : step.objects) {
            if (std::ranges::none_of(campus_.objects, [&](const scene::CampusObject& object) {
                    return scene::glob_matches(pattern.glob, object.id);
                })) {
                diagnose_unknown(pattern, diagnostics);
            }
        }
    }

private:
    void check_place(const SourceMark& mark, const StepPreview::Place& place,
                     std::vector<Diagnostic>& diagnostics) {
        const auto& [label, foot] = place;
        if (collision::nearest_free_placement(campus_.world, solids_, foot, avatar_.radius, height_,
                                              kPlacementSearch)) {
            return;
        }
        const auto object = collision::obstruction(campus_.world, solids_, foot, avatar_.radius, height_);
        const std::string where = object ? "inside " + campus_.objects[index_of(*object)].id : "not free";
        diagnostics.push_back({scene::Severity::error, mark, "spawn-blocked",
                               label + " at " + fixed(foot) + " is " + where +
                                   ": put it where a capsule of " + fixed(avatar_.radius, 2) +
                                   " m radius and " + fixed(height_, 2) + " m height fits"});
    }

    void switch_objects(const NamePattern& pattern, bool enabled, std::vector<Diagnostic>& diagnostics) {
        bool known = false;
        for (std::size_t i = 0; i < campus_.objects.size(); ++i) {
            if (scene::glob_matches(pattern.glob, campus_.objects[i].id)) {
                disabled_[i] = !enabled;
                known = true;
            }
        }
        if (!known) {
            diagnose_unknown(pattern, diagnostics);
        }
    }

    void diagnose_unknown(const NamePattern& pattern, std::vector<Diagnostic>& diagnostics) const {
        diagnostics.push_back(
            {scene::Severity::error, pattern.mark, "unknown-name",
             "the campus has no object '" + pattern.glob + "'" +
                 scene::did_you_mean(pattern.glob,
                                     scene::texts_of(campus_.objects, &scene::CampusObject::id))});
    }

    const scene::Campus& campus_;
    const AvatarProfile& avatar_;
    double height_;
    std::vector<bool> disabled_;
    collision::QueryFilter solids_;
};

/// Whether a visitor who is put there falls, unless the walk says so.
void check_ground(const scene::Campus& campus, const Walk& walk, const SpawnStep& spawn,
                  std::vector<Diagnostic>& diagnostics) {
    if (spawn.fall) {
        return;
    }
    const SpawnFall fall = fall_at_spawn(campus, walk);
    if (fall.lands && fall.height <= kSpawnFall) {
        return;
    }
    const std::string what = fall.lands ? fixed(fall.height, 2) + " m above the ground"
                                        : "over nothing that carries the visitor, who falls from there";
    const bool is_name = spawn.label.find(',') == std::string::npos;
    diagnostics.push_back({scene::Severity::error, spawn.mark, "spawn-in-air",
                           spawn.label + " at " + fixed(spawn.position) + " is " + what +
                               "; put it on the ground, or write 'spawn: {at: " +
                               (is_name ? spawn.label : "[" + spawn.label + "]") +
                               ", fall: true}' if that is meant"});
}

/// The steps of a `repeat` are checked once per round.
void drop_repeated(std::vector<Diagnostic>& diagnostics) {
    std::set<std::pair<scene::SourceMark, std::string>> seen;
    std::erase_if(diagnostics,
                  [&](const Diagnostic& each) { return !seen.emplace(each.mark, each.message).second; });
}

}  // namespace

std::vector<Diagnostic> check_walk(const scene::Campus& campus, const Walk& walk) {
    std::vector<Diagnostic> diagnostics;
    const NameCheck names(campus, walk, diagnostics);
    StepCheck steps(campus, walk);
    for (const Step& step : walk.steps) {
        const StepPreview preview = preview_of(step);
        const std::size_t before = diagnostics.size();
        steps.check(preview, mark_of(step), diagnostics);
        const auto* spawn = std::get_if<SpawnStep>(&step);
        if (spawn != nullptr && &step == &walk.steps.front() && diagnostics.size() == before) {
            check_ground(campus, walk, *spawn, diagnostics);
        }
        names.check_events(preview.mentions);
    }
    names.check_events(mentions_of(walk.expectations));
    names.check_images(walk.expectations);
    drop_repeated(diagnostics);
    return diagnostics;
}

}  // namespace campuswalk::engine

#include "engine/expect/name_check.h"

#include <algorithm>

#include "scene/base/glob.h"

namespace campuswalk::engine {

namespace {

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

}  // namespace

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

}  // namespace campuswalk::engine

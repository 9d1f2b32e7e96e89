#include "engine/expect/image_names.h"

#include <algorithm>
#include <string>

#include "scene/base/glob.h"

namespace campuswalk::engine {

using scene::Diagnostic;

namespace {

class ImageNames {
public:
    ImageNames(const scene::Campus& campus, const Walk& walk, std::vector<Diagnostic>& diagnostics)
        : diagnostics_(diagnostics) {
        for (const Step& step : walk.steps) {
            if (const auto* snapshot = std::get_if<SnapshotStep>(&step)) {
                snapshots_.push_back(snapshot->name);
            }
        }
        for (const scene::Building& building : campus.description.buildings) {
            if (!building.nodes.empty()) {
                buildings_.push_back(building.id);
            }
        }
    }

    void check_snapshot(const std::string& name, const SourceMark& mark) const {
        if (std::ranges::find(snapshots_, name) == snapshots_.end()) {
            diagnose(mark, "no step takes a snapshot '" + name + "'" + scene::did_you_mean(name, snapshots_));
        }
    }

    void check_building(const NamePattern& building) const {
        if (std::ranges::none_of(
                buildings_, [&](const std::string& id) { return scene::glob_matches(building.glob, id); })) {
            diagnose(building.mark, "no building '" + building.glob + "' has nodes that could be seen" +
                                        scene::did_you_mean(building.glob, buildings_));
        }
    }

private:
    void diagnose(const SourceMark& mark, const std::string& message) const {
        diagnostics_.push_back({scene::Severity::error, mark, "unknown-name", message});
    }

    std::vector<std::string> snapshots_;
    std::vector<std::string> buildings_;
    std::vector<Diagnostic>& diagnostics_;
};

}  // namespace

void check_image_names(const scene::Campus& campus, const Walk& walk, std::vector<Diagnostic>& diagnostics) {
    const ImageNames names(campus, walk, diagnostics);
    for (const Expectation& expectation : walk.expectations) {
        if (const auto* snapshot = std::get_if<ExpectSnapshot>(&expectation)) {
            names.check_snapshot(snapshot->name, snapshot->mark);
        } else if (const auto* visible = std::get_if<ExpectVisible>(&expectation)) {
            names.check_snapshot(visible->snapshot, visible->snapshot_mark);
            names.check_building(visible->building);
        }
    }
}

}  // namespace campuswalk::engine

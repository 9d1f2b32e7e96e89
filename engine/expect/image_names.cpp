#include "engine/expect/image_names.h"

#include <algorithm>
#include <string>

#include "scene/base/glob.h"

namespace campuswalk::engine {

using scene::Diagnostic;

namespace {

class PictureNames {
public:
    PictureNames(const scene::Campus& campus, const Walk& walk, std::vector<Diagnostic>& complaints)
        : complaints_(complaints) {
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
            complain(mark, "no step takes a snapshot '" + name + "'" + scene::did_you_mean(name, snapshots_));
        }
    }

    void check_building(const NamePattern& building) const {
        if (std::ranges::none_of(
                buildings_, [&](const std::string& id) { return scene::glob_matches(building.glob, id); })) {
            complain(building.mark, "no building '" + building.glob + "' has nodes that could be seen" +
                                        scene::did_you_mean(building.glob, buildings_));
        }
    }

private:
    void complain(const SourceMark& mark, const std::string& message) const {
        complaints_.push_back({scene::Severity::error, mark, "unknown-name", message});
    }

    std::vector<std::string> snapshots_;
    std::vector<std::string> buildings_;
    std::vector<Diagnostic>& complaints_;
};

}  // namespace

void check_picture_names(const scene::Campus& campus, const Walk& walk, std::vector<Diagnostic>& complaints) {
    const PictureNames names(campus, walk, complaints);
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

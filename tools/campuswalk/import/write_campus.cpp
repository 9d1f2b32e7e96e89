#include "tools/campuswalk/import/write_campus.h"

#include <algorithm>
#include <cmath>
#include <system_error>
#include <utility>
#include <vector>

#include "engine/events/decimals.h"
#include "engine/simulation/run_walk.h"
#include "scene/base/atomic_file.h"
#include "tools/campuswalk/base/json_text.h"
#include "tools/campuswalk/loading/walk_loader.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

using scene::osm::DraftPlace;
using scene::osm::MapFiles;

constexpr std::size_t kMaxVisits = 3;
constexpr double kFarthest = 200.0;  // metres from one visit to the next

/// Removes the files that were new, unless all were written.
class NewFiles {
public:
    NewFiles() = default;
    NewFiles(const NewFiles&) = delete;
    NewFiles& operator=(const NewFiles&) = delete;
    ~NewFiles() {
        std::error_code ignored;
        for (const fs::path& file : files_) {
            fs::remove(file, ignored);
        }
    }
    void write(const fs::path& file, std::string_view contents) {
        std::error_code ignored;
        const bool is_new = !fs::exists(file, ignored);
        scene::write_file_atomically(file, contents);
        if (is_new) {
            files_.push_back(file);
        }
    }
    void finish() { files_.clear(); }

private:
    std::vector<fs::path> files_;
};

std::string visit_yaml(const std::vector<const DraftPlace*>& visits, const std::string& campus_file) {
    std::string steps = "  - spawn: start\n";
    std::string expect = "  - never: \"avatar.fell *\"\n";
    for (const DraftPlace* visit : visits) {
        steps += "  - go_to: " + visit->name + "\n";
        expect += "  - sequence: [" + json_text("trigger.enter " + visit->trigger) + "]\n";
    }
    return "# Visits doors near the start; by `campuswalk import osm`.\ncampus: " + json_text(campus_file) +
           "\navatar: adult\nsteps:\n" + steps + (visits.empty() ? "  - wait: 1\n" : "") + "expect:\n" +
           expect;
}

/// The places to visit from `here`, the most telling and nearest first.
std::vector<const DraftPlace*> nearby(const std::vector<DraftPlace>& places, const Eigen::Vector3d& here) {
    std::vector<std::pair<double, const DraftPlace*>> found;
    for (const DraftPlace& place : places) {
        const double distance = (place.at - here).norm();
        if (!place.trigger.empty() && distance <= kFarthest) {
            constexpr double kWorth = 25.0;  // metres of detour
            found.emplace_back(distance - kWorth * place.importance, &place);
        }
    }
    std::ranges::stable_sort(found, {}, &std::pair<double, const DraftPlace*>::first);
    std::vector<const DraftPlace*> nearest;
    for (const auto& [cost, place] : found) {
        nearest.push_back(place);
    }
    return nearest;
}

bool passes(const fs::path& walk_file, WalkLoader& loader) {
    const LoadedWalk loaded = loader.load_walk(walk_file);
    return engine::run_walk(*loaded.campus, loaded.walk, {}, loaded.routes.get()).passed;
}

/// Adds visits one by one, each played with those before it.
std::vector<const DraftPlace*> playable_visits(const MapFiles& contents, const CampusFiles& files,
                                               WalkLoader& loader, NewFiles& written) {
    constexpr std::size_t kMaxTries = 8;
    std::vector<const DraftPlace*> visits;
    Eigen::Vector3d here = Eigen::Vector3d::Zero();
    for (const scene::osm::DraftSpawn& spawn : contents.spawns) {
        here = spawn.name == "start" ? spawn.at : here;
    }
    std::size_t tries = 0;
    while (visits.size() < kMaxVisits && tries < kMaxTries) {
        const std::size_t before = visits.size();
        for (const DraftPlace* place : nearby(contents.places, here)) {
            if (std::ranges::find(visits, place) != visits.end()) {
                continue;
            }
            visits.push_back(place);
            written.write(files.walk, visit_yaml(visits, files.campus.filename().string()));
            ++tries;
            if (passes(files.walk, loader)) {
                here = place->at;
                break;
            }
            visits.pop_back();
            if (tries >= kMaxTries) {
                break;
            }
        }
        if (visits.size() == before) {
            break;
        }
    }
    return visits;
}

}  // namespace

CampusFiles campus_files_in(const fs::path& folder, const std::string& name) {
    return {folder / "campus.glb", folder / (name + ".campus.yaml"), folder / (name + ".walk.yaml"),
            folder / "ATTRIBUTION.md"};
}

std::size_t write_campus_files(const MapFiles& contents, const CampusFiles& files) {
    NewFiles written;
    written.write(files.model, contents.glb);
    written.write(files.campus, contents.campus_yaml);
    written.write(files.attribution, contents.attribution);
    config::SearchPaths search = search_paths();
    search.roots.push_back(fs::absolute(files.campus).parent_path());
    WalkLoader loader([](const std::vector<scene::Diagnostic>&) {}, std::move(search));
    const std::vector<const DraftPlace*> visits = playable_visits(contents, files, loader, written);
    written.write(files.walk, visit_yaml(visits, files.campus.filename().string()));
    if (!passes(files.walk, loader)) {
        throw std::runtime_error("the walk of the imported campus doesn't pass; please report this map");
    }
    written.finish();
    return visits.size();
}

}  // namespace campuswalk::tools

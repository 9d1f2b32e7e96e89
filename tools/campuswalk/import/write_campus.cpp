#include "tools/campuswalk/import/write_campus.h"

#include <algorithm>
#include <cmath>
#include <system_error>
#include <utility>
#include <vector>

#include <unistd.h>

#include "config/loader/yaml/source_text.h"
#include "engine/simulation/run_walk.h"
#include "scene/base/atomic_file.h"
#include "tools/campuswalk/base/json_text.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/base/schema_line.h"
#include "tools/campuswalk/base/yaml_text.h"
#include "tools/campuswalk/import/draft_text.h"
#include "tools/campuswalk/loading/walk_loader.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

using scene::osm::CampusDraft;
using scene::osm::DraftPlace;
using scene::osm::MapFiles;

constexpr std::size_t kMaxVisits = 3;
constexpr double kFarthest = 200.0;  // metres from one visit to the next

/// A folder beside the files to write, which goes away with everything in it.
class Workshop {
public:
    explicit Workshop(const fs::path& folder)
        : made_folder_(!fs::exists(folder)),
          folder_(folder),
          path_(folder / (".import-" + std::to_string(getpid()))) {
        fs::create_directories(path_);
    }
    Workshop(const Workshop&) = delete;
    Workshop& operator=(const Workshop&) = delete;
    ~Workshop() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
        if (made_folder_) {
            fs::remove(folder_, ignored);  // only if nothing is in it
        }
    }
    const fs::path& path() const { return path_; }

private:
    bool made_folder_;
    fs::path folder_;
    fs::path path_;
};

std::string visit_yaml(const CampusDraft& draft, const std::vector<const DraftPlace*>& visits,
                       const std::string& campus_file) {
    std::string steps = "  - spawn: start\n";
    std::string expect = "  - never: \"avatar.fell *\"\n";
    for (const DraftPlace* visit : visits) {
        steps += "  - go_to: " + visit->name + yaml_comment(building_title(draft, *visit)) + "\n";
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
        const Eigen::Vector3d d = place.at - here;
        const double distance = std::sqrt(d.x() * d.x() + d.y() * d.y() + d.z() * d.z());
        if (!place.trigger.empty() && distance <= kFarthest) {
            constexpr double kWorth = 25.0;  // metres of detour
            found.emplace_back(distance - kWorth * place.importance, &place);
        }
    }
    std::ranges::stable_sort(found, {}, &std::pair<double, const DraftPlace*>::first);
    std::vector<const DraftPlace*> nearest;
    nearest.reserve(found.size());
    for (const auto& [cost, place] : found) {
        nearest.push_back(place);
    }
    return nearest;
}

/// A second door of a building says less than the first of another.
void put_visited_last(std::vector<const DraftPlace*>& places, const std::vector<const DraftPlace*>& visited) {
    // Not std::ranges::stable_partition: its result is a subrange, which clang 14 can't compile with
    // libstdc++ 12.
    std::stable_partition(places.begin(), places.end(), [&](const DraftPlace* place) {
        return std::ranges::find(visited, building_of(*place), [](const DraftPlace* other) {
                   return building_of(*other);
               }) == visited.end();
    });
}

/// Why the walk fails; empty if it passes.
std::string failure_of(const fs::path& walk_file, WalkLoader& loader) {
    const LoadedWalk loaded = loader.load_walk(walk_file);
    const engine::WalkSummary summary =
        engine::run_walk(*loaded.campus, loaded.walk, {}, loaded.routes.get());
    if (summary.passed) {
        return "";
    }
    const std::string message =
        summary.failures.empty() ? "the walk there fails" : summary.failures.front().message;
    return message.substr(0, message.find("; the walk stops"));  // nobody keeps this walk
}

/// Doors to visit one after the other.
struct Visits {
    std::vector<const DraftPlace*> places;
    std::string obstacle;  ///< why the first door that was tried can't be visited; empty if it can
};

/// Adds visits one by one, each played with those before it.
Visits playable_visits(const MapFiles& contents, const CampusFiles& files, WalkLoader& loader) {
    constexpr std::size_t kMaxTries = 8;
    Visits visits;
    Eigen::Vector3d here = Eigen::Vector3d::Zero();
    for (const scene::osm::DraftSpawn& spawn : contents.draft.spawns) {
        here = spawn.name == "start" ? spawn.at : here;
    }
    std::size_t tries = 0;
    while (visits.places.size() < kMaxVisits && tries < kMaxTries) {
        const std::size_t before = visits.places.size();
        std::vector<const DraftPlace*> next = nearby(contents.draft.places, here);
        put_visited_last(next, visits.places);
        for (const DraftPlace* place : next) {
            if (std::ranges::find(visits.places, place) != visits.places.end()) {
                continue;
            }
            visits.places.push_back(place);
            scene::write_file_atomically(
                files.walk, visit_yaml(contents.draft, visits.places, files.campus.filename().string()));
            ++tries;
            const std::string failure = failure_of(files.walk, loader);
            if (failure.empty()) {
                here = place->at;
                break;
            }
            visits.obstacle = visits.obstacle.empty() ? failure : visits.obstacle;
            visits.places.pop_back();
            if (tries >= kMaxTries) {
                break;
            }
        }
        if (visits.places.size() == before) {
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

WrittenWalk write_campus_files(const MapFiles& contents, const CampusFiles& files, const fs::path& map) {
    const std::string map_name = map.filename().string();
    const std::string campus_yaml =
        schema_line(files.campus, kCampusSchema) + draft_yaml(contents.draft, map_name);
    if (campus_yaml.size() > config::kMaxSourceBytes) {
        throw error_about(map, "too-large",
                          "its names and doors make a campus file of " + std::to_string(campus_yaml.size()) +
                              " bytes, and the limit is " + std::to_string(config::kMaxSourceBytes) +
                              "; choose a part of the map with --bbox or --center");
    }
    const Workshop workshop(files.campus.parent_path());
    const auto inside = [&](const fs::path& file) { return workshop.path() / file.filename(); };
    const CampusFiles drafts{inside(files.model), inside(files.campus), inside(files.walk),
                             inside(files.attribution)};
    scene::write_file_atomically(drafts.model, contents.glb);
    scene::write_file_atomically(drafts.campus, campus_yaml);
    scene::write_file_atomically(drafts.attribution, attribution_text(map_name));
    config::SearchPaths search = search_paths();
    search.roots.push_back(fs::absolute(workshop.path()));
    WalkLoader loader([](const std::vector<scene::Diagnostic>&) {}, std::move(search));
    WrittenWalk written;
    try {
        const Visits visits = playable_visits(contents, drafts, loader);
        scene::write_file_atomically(
            drafts.walk, schema_line(files.walk, kWalkSchema) +
                             visit_yaml(contents.draft, visits.places, files.campus.filename().string()));
        if (!failure_of(drafts.walk, loader).empty()) {
            throw std::runtime_error("the walk of the imported campus doesn't pass; please report this map");
        }
        written = {visits.places.size(), visits.obstacle};
    } catch (const scene::InputError& error) {  // about files that the user has never seen
        throw std::runtime_error("the imported campus isn't valid; please report this map: " +
                                 std::string(error.what()));
    }
    for (const auto& [draft, file] : {std::pair(drafts.model, files.model),
                                      {drafts.campus, files.campus},
                                      {drafts.attribution, files.attribution},
                                      {drafts.walk, files.walk}}) {
        fs::rename(draft, file);
    }
    return written;
}

}  // namespace campuswalk::tools

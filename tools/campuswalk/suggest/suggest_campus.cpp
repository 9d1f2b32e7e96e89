#include "tools/campuswalk/suggest/suggest_campus.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "config/loader/search_paths.h"
#include "engine/simulation/run_walk.h"
#include "scene/base/atomic_file.h"
#include "scene/base/glob.h"
#include "scene/lint/model_report.h"
#include "scene/lint/wording.h"
#include "scene/model/projection.h"
#include "scene/suggest/suggested_buildings.h"
#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/base/text.h"
#include "tools/campuswalk/base/writable_path.h"
#include "tools/campuswalk/loading/walk_loader.h"
#include "tools/campuswalk/suggest/campus_text.h"
#include "tools/campuswalk/suggest/frame_text.h"
#include "tools/campuswalk/suggest/ground_lint.h"
#include "tools/campuswalk/suggest/lint_text.h"
#include "tools/campuswalk/suggest/place_visitor.h"
#include "tools/campuswalk/suggest/read_places.h"
#include "tools/campuswalk/suggest/upright_model.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;
using Eigen::Vector3d;

namespace {

/// The height of the lowest of a building's doors, or of its bottom if it has none.
double threshold_of(const scene::SuggestedBuilding& building, const std::vector<scene::Door>& doors) {
    constexpr double kBeside = 0.5;    // metres from a door to the walls of its building
    constexpr double kLeafGap = 0.05;  // metres below a leaf
    const double bottom = building.box.center.y() - 0.5 * building.box.size.y();
    double lowest = 1e300;
    for (const scene::Door& door : doors) {
        const bool is_its = building.box.depth_of(door.foot + kWaist * Vector3d::UnitY()) >= -kBeside;
        lowest = is_its ? std::min(lowest, door.foot.y()) : lowest;
    }
    return lowest > bottom + kLeafGap && lowest < 1e300 ? lowest : bottom;
}

/// A box below the whole model and its surroundings. Its top is at the median of the buildings' thresholds,
/// as the missing ground may be a slope.
scene::Bounds substitute_ground(const scene::ModelReport& report,
                                const std::vector<scene::SuggestedBuilding>& buildings) {
    constexpr double kMargin = 20.0;    // metres
    constexpr double kThickness = 0.5;  // metres
    const scene::Bounds& model = report.bounds;
    std::vector<double> bottoms;
    bottoms.reserve(buildings.size());
    for (const scene::SuggestedBuilding& building : buildings) {
        bottoms.push_back(threshold_of(building, report.doors));
    }
    std::sort(bottoms.begin(), bottoms.end());
    const Vector3d around(kMargin, 0.0, kMargin);
    scene::Bounds ground{model.min - around, model.max + around};
    ground.max.y() = bottoms.empty() ? model.min.y() : bottoms[bottoms.size() / 2];
    ground.min.y() = ground.max.y() - kThickness;
    return ground;
}

/// The walk file beside a campus file. Throws if one of them must not be written.
fs::path walk_beside(const fs::path& campus_file, bool overwrite) {
    const std::string file_name = campus_file.filename().string();
    const std::string name = without_ending(file_name, ".campus.yaml");
    if (name == file_name) {
        throw error_about(campus_file, "file-name", "a campus file is called NAME.campus.yaml");
    }
    fs::path walk = campus_file;
    walk.replace_filename(name + ".walk.yaml");
    for (const fs::path& file : {campus_file, walk}) {
        if (!overwrite && fs::exists(file)) {
            throw error_about(file, "file-exists", "the file exists; name another, or pass --overwrite");
        }
    }
    return walk;
}

/// Globs of the doors that are nodes of the building.
std::vector<std::string> doors_of(const scene::Model& model, const scene::SuggestedBuilding& building,
                                  const std::vector<std::string>& doors) {
    std::vector<std::string> globs;
    for (const std::string& glob : building.globs) {
        for (const std::size_t node : scene::match_nodes(model, glob)) {
            const std::string& name = model.nodes[node].name;
            const std::string door = scene::glob_for(name);
            if (std::ranges::find(doors, name) != doors.end() &&
                std::ranges::find(globs, door) == globs.end()) {
                globs.push_back(door);
            }
        }
    }
    return globs;
}

/// The file as a campus refers to it.
std::string seen_from(const fs::path& campus_file, const fs::path& file) {
    return fs::absolute(file)
        .lexically_normal()
        .lexically_relative(fs::absolute(campus_file).lexically_normal().parent_path())
        .generic_string();
}

/// Where the campus's [0, 0, 0] is on the Earth, if that is known.
std::optional<scene::GeographicPlace> origin_on_earth(const UprightModel& model,
                                                      const SuggestRequest& request) {
    if (request.on_earth || !model.report.geographic) {
        return request.on_earth;
    }
    const Vector3d map = scene::MapFrame(*model.report.geographic).to_map(Vector3d::Zero());
    return scene::GeographicPlace{map.y(), map.x(), map.z()};
}

/// Everything but the spawn and the visits. `origin`: what was subtracted from the model's coordinates.
SuggestedCampus without_visitor(const UprightModel& model, const Vector3d& origin,
                                const SuggestRequest& request) {
    SuggestedCampus campus;
    campus.scene = model.file;
    campus.origin = origin;
    campus.model = seen_from(request.campus_file, model.file.path);
    if (request.places) {
        campus.places = *request.places;
        campus.places->path = seen_from(request.campus_file, request.places->path);
        campus.on_earth = origin_on_earth(model, request);
        read_places(*request.places,
                    campus.on_earth);  // an error in the file is about that, not about a draft
    }
    campus.buildings = scene::suggest_buildings(model.model, model.report);
    campus.interiors.assign(campus.buildings.size(), SuggestedInterior{true, {}});  // as far as is known
    const std::vector<std::string> doors = closed_door_names(model.report);
    for (const scene::SuggestedBuilding& building : campus.buildings) {
        campus.doors_of.push_back(doors_of(model.model, building, doors));
    }
    campus.solids = scene::solid_parts(model.model, campus.buildings, doors);
    for (const std::string& name : doors) {
        campus.doors.emplace_back().pattern = scene::glob_for(name);
    }
    return campus;
}

/// Reads the model and the places wherever they are: the user named them.
WalkLoader quiet_loader(const UprightModel& model, const SuggestRequest& request) {
    config::SearchPaths search = search_paths();
    search.roots.push_back(fs::absolute(model.file.path).parent_path());
    if (request.places) {
        search.roots.push_back(fs::absolute(request.places->path).parent_path());
    }
    return WalkLoader([](const std::vector<scene::Diagnostic>&) {}, std::move(search));
}

/// Places the visitor and writes the campus. As a large model's tree takes seconds to build, the visitor is
/// placed on the campus in `loader`, which the walk then uses unless triggers of rooms were found.
void write_campus(const UprightModel& model, const SuggestRequest& request, const fs::path& campus_file,
                  SuggestedCampus& campus, WalkLoader& loader) {
    const bool tiny = (model.report.bounds.max - model.report.bounds.min).maxCoeff() < 1.0;
    bool placed = false;
    if (!tiny && !has_lint(model.report, "no-ground")) {
        scene::write_file_atomically(campus_file, campus_yaml(campus));  // its spawn isn't known yet
        placed = place_visitor(model.report, *loader.load_campus(campus_file), campus);
    }
    if (!placed && !tiny) {
        loader = quiet_loader(model, request);  // without the campus that lacks the ground
        campus.ground = substitute_ground(model.report, campus.buildings);
        scene::write_file_atomically(campus_file, campus_yaml(campus));
        placed = place_visitor(model.report, *loader.load_campus(campus_file), campus);
    }
    if (!placed) {
        throw error_about(
            model.file.file, "no-ground",
            "there is no place to stand near its middle; check its size and axes with `campuswalk info`, "
            "then pass --scale or --up");
    }
    scene::write_file_atomically(campus_file, campus_yaml(campus));
    if (std::ranges::any_of(campus.interiors, [](const SuggestedInterior& i) { return !i.rooms.empty(); })) {
        loader = quiet_loader(model, request);
    }
}

/// Writes a walk with as many of the planned visits as pass.
std::size_t write_walk(const SuggestedCampus& campus, const fs::path& campus_file, const fs::path& walk_file,
                       WalkLoader& loader) {
    for (std::size_t visits = campus.visits.size();; --visits) {
        scene::write_file_atomically(walk_file, walk_yaml(campus, campus_file.filename().string(), visits));
        const LoadedWalk loaded = loader.load_walk(walk_file);
        if (engine::run_walk(*loaded.campus, loaded.walk, {}).passed) {
            return visits;
        }
        if (visits == 0) {
            throw error_about(campus.scene.file, "no-ground",
                              "no place was found where a visitor stays standing");
        }
    }
}

/// The lints of the model that still hold for the campus.
struct RemainingLints {
    std::vector<scene::ModelLint> lints;
    std::size_t opened = 0;  ///< doors that the campus leaves out, so that they close nothing
};

RemainingLints remaining_lints(const UprightModel& model) {
    const std::vector<std::string> open = closed_door_names(model.report);
    RemainingLints left;
    for (const scene::ModelLint& lint : model.report.warnings) {
        if (lint.code != "solid-door") {
            left.lints.push_back(lint);
            continue;
        }
        std::vector<scene::ModelLint::Place> closed = lint.places;
        left.opened += std::erase_if(closed, [&](const scene::ModelLint::Place& place) {
            return std::ranges::find(open, place.node) != open.end();
        });
        if (!closed.empty()) {
            left.lints.push_back(scene::solid_doors(std::move(closed)));
        }
    }
    return left;
}

/// Files in which a campus and its walk are tried, so that existing files aren't touched until there is
/// something better. They are in the same folder, as the campus refers to its model from there.
struct Drafts {
    explicit Drafts(const fs::path& campus_file)
        : campus(beside(campus_file, ".campus.yaml")), walk(beside(campus_file, ".walk.yaml")) {}
    Drafts(const Drafts&) = delete;
    Drafts& operator=(const Drafts&) = delete;
    ~Drafts() {
        std::error_code ignored;
        fs::remove(campus, ignored);
        fs::remove(walk, ignored);
    }

    fs::path campus;
    fs::path walk;

private:
    static fs::path beside(const fs::path& campus_file, const std::string& ending) {
        std::string name = campus_file.stem().stem().string() + "-draft";
        while (fs::exists(campus_file.parent_path() / (name + ending))) {
            name += "-";  // the name is taken
        }
        return campus_file.parent_path() / (name + ending);
    }
};

/// That walks on the campus must be allowed to read the file, if so.
void print_outside(const fs::path& campus_file, const fs::path& file, const char* what) {
    if (!config::read_roots(campus_file, search_paths()).why_unreadable(file).empty()) {
        print_line("%s isn't in the project: run the walk with --root %s", what,
                   file.parent_path().string().c_str());
    }
}

}  // namespace

int suggest_campus(const scene::SceneFile& model, const SuggestRequest& request) {
    const fs::path& campus_file = request.campus_file;
    const fs::path walk_file = walk_beside(campus_file, request.overwrite);
    for (const fs::path& file : {campus_file, walk_file}) {
        require_writable_file(file, "the suggestion can't be written here");
    }
    UprightModel upright = load_upright(model, request.typed, scene::EmptyModel::refuse);
    const Vector3d origin = move_near(upright);
    lint_ground(ground_of(upright.model, upright.report), upright.report);
    SuggestedCampus campus = without_visitor(upright, origin, request);
    WalkLoader loader = quiet_loader(upright, request);
    const Drafts drafts(campus_file);
    write_campus(upright, request, drafts.campus, campus, loader);
    const std::size_t visits = write_walk(campus, drafts.campus, drafts.walk, loader);
    scene::write_file_atomically(campus_file, campus_yaml(campus));
    scene::write_file_atomically(walk_file, walk_yaml(campus, campus_file.filename().string(), visits));
    print_line("%s: %s", campus_file.string().c_str(),
               scene::plural(campus.buildings.size(), "building").c_str());
    print_line("%s: %s, played%s%s", walk_file.string().c_str(), scene::plural(visits, "visit").c_str(),
               campus.ground ? ", on a box: the model has no ground" : "",
               enters_something(campus, visits) ? "" : "; it goes through no door");
    print_outside(campus_file, model.path, "the model");
    if (request.places) {
        print_outside(campus_file, request.places->path, "the file of places");
    }
    for (const std::string& line : frame_lines(upright)) {
        print_line("%s", line.c_str());
    }
    const RemainingLints left = remaining_lints(upright);
    if (left.opened > 0) {
        print_line("%s left out of what is solid", scene::plural(left.opened, "closed door").c_str());
    }
    print_line("%s about the model", scene::plural(left.lints.size(), "warning").c_str());
    print_lints(left.lints);
    return kPass;
}

}  // namespace campuswalk::tools

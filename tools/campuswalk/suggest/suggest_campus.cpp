#include "tools/campuswalk/suggest/suggest_campus.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "scene/base/atomic_file.h"
#include "scene/base/glob.h"
#include "scene/model/projection.h"
#include "scene/suggest/suggested_buildings.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/base/schema_line.h"
#include "tools/campuswalk/base/text.h"
#include "tools/campuswalk/base/writable_path.h"
#include "tools/campuswalk/loading/walk_loader.h"
#include "tools/campuswalk/suggest/frame_text.h"
#include "tools/campuswalk/suggest/ground_lint.h"
#include "tools/campuswalk/suggest/place_visitor.h"
#include "tools/campuswalk/suggest/read_places.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;
using Eigen::Vector3d;

namespace {

/// The walk may take so much longer than it does: what is farther is a detour round something that is shut.
constexpr double kDetour = 1.25;

constexpr double kStorey = 2.0;  // metres, at least

/// Until a visitor has been placed.
const SuggestedInterior kUnknownInterior{.can_be_entered = true};

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

/// NAME.walk.yaml beside NAME.campus.yaml.
fs::path walk_beside(const fs::path& campus_file) {
    const std::string file_name = campus_file.filename().string();
    const std::string name = without_ending(file_name, ".campus.yaml");
    if (name == file_name) {
        throw error_about(campus_file, "file-name", "a campus file is called NAME.campus.yaml");
    }
    fs::path walk = campus_file;
    walk.replace_filename(name + ".walk.yaml");
    return walk;
}

void require_new(const fs::path& file, bool overwrite) {
    if (!overwrite && fs::exists(file)) {
        throw error_about(file, "file-exists", "the file exists; name another, or pass --overwrite");
    }
}

/// Globs of those of the nodes `left_out` that are the building's.
std::vector<std::string> left_out_of(const scene::Model& model, const scene::SuggestedBuilding& building,
                                     const std::vector<std::string>& left_out) {
    std::vector<std::string> globs;
    for (const std::string& glob : building.globs) {
        for (const std::size_t node : scene::match_nodes(model, glob)) {
            const std::string& name = model.nodes[node].name;
            const std::string glob_of_name = scene::glob_for(name);
            if (std::ranges::find(left_out, name) != left_out.end() &&
                std::ranges::find(globs, glob_of_name) == globs.end()) {
                globs.push_back(glob_of_name);
            }
        }
    }
    return globs;
}

/// How a file refers to another.
std::string seen_from(const fs::path& from, const fs::path& file) {
    return fs::absolute(file)
        .lexically_normal()
        .lexically_relative(fs::absolute(from).lexically_normal().parent_path())
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
    scene::SuggestedBuildings buildings = scene::suggest_buildings(model.model, model.report);
    campus.buildings = std::move(buildings.list);
    campus.more_buildings = buildings.left_out;
    campus.interiors.assign(campus.buildings.size(), kUnknownInterior);
    campus.doubts = frame_lints(model);
    std::vector<std::string> left_out = closed_door_names(model.report);
    campus.closed_doors = left_out.size();
    for (const scene::IntangibleNode& each : model.intangible) {
        left_out.push_back(model.model.nodes[each.node].name);
    }
    for (const std::string& name : left_out) {
        campus.left_out.push_back(scene::glob_for(name));
    }
    for (const scene::SuggestedBuilding& building : campus.buildings) {
        campus.left_out_of.push_back(left_out_of(model.model, building, left_out));
    }
    campus.solids = scene::solid_parts(model.model, campus.buildings, left_out);
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

/// That there is no place to stand, with what is unsure about the model's frame.
scene::InputError no_place_in(const UprightModel& model) {
    const std::vector<scene::ModelLint> lints = frame_lints(model);
    std::string message = "there is no place to stand near its middle";
    for (const scene::ModelLint& lint : lints) {
        message += "; " + lint.message;
    }
    if (lints.empty()) {
        message += "; it is " + size_text(model.report.bounds.max - model.report.bounds.min, 3) + " large";
    }
    return error_about(model.file.file, "no-ground",
                       message + "; pass --scale or --up, and see `campuswalk info`");
}

/// Places the visitor and writes the campus. As a large model's tree takes seconds to build, the visitor is
/// placed on the campus in `loader`, which the walk then uses unless triggers of rooms were found. Returns
/// how what is reached from the spawn was explored.
engine::ExploreSettings write_campus(const UprightModel& model, const SuggestRequest& request,
                                     const fs::path& campus_file, SuggestedCampus& campus,
                                     WalkLoader& loader) {
    const bool tiny = (model.report.bounds.max - model.report.bounds.min).maxCoeff() < 1.0;
    std::optional<engine::ExploreSettings> placed;
    if (!tiny && !has_lint(model.report, "no-ground")) {
        scene::write_file_atomically(campus_file, campus_yaml(campus));  // its spawn isn't known yet
        placed = place_visitor(model.report, *loader.load_campus(campus_file), campus);
    }
    const scene::Bounds ground = substitute_ground(model.report, campus.buildings);
    const bool is_on_roof = campus.starts_aside && campus.spawn.y() > ground.max.y() + kStorey;
    if ((!placed || is_on_roof) && !tiny) {
        loader = quiet_loader(model, request);  // without the campus that lacks the ground
        campus.interiors.assign(campus.buildings.size(), kUnknownInterior);
        campus.ground = ground;
        scene::write_file_atomically(campus_file, campus_yaml(campus));
        placed = place_visitor(model.report, *loader.load_campus(campus_file), campus);
    }
    if (!placed) {
        throw no_place_in(model);
    }
    scene::write_file_atomically(campus_file, campus_yaml(campus));
    if (std::ranges::any_of(campus.interiors, [](const SuggestedInterior& i) { return !i.rooms.empty(); })) {
        loader = quiet_loader(model, request);
    }
    return std::move(*placed);
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

}  // namespace

Suggestion suggest_campus(const scene::SceneFile& model, const SuggestRequest& request) {
    const fs::path& campus_file = request.campus_file;
    const fs::path beside = walk_beside(campus_file);
    Suggestion suggestion{.campus_file = campus_file,
                          .walk_file = request.walk_file.empty() ? beside : request.walk_file};
    for (const fs::path& file : {campus_file, suggestion.walk_file}) {
        require_new(file, request.overwrite);
        require_writable_file(file, "the suggestion can't be written here");
    }
    suggestion.model = load_upright(model, request.typed, scene::EmptyModel::refuse);
    UprightModel& upright = suggestion.model;
    const Vector3d origin = move_near(upright);
    lint_ground(ground_of(upright), upright.report);
    suggestion.campus = without_visitor(upright, origin, request);
    SuggestedCampus& campus = suggestion.campus;
    WalkLoader loader = quiet_loader(upright, request);
    const Drafts drafts(campus_file);
    const engine::ExploreSettings explored = write_campus(upright, request, drafts.campus, campus, loader);
    suggestion.walk = play_visits(campus, drafts.campus, drafts.walk, loader);
    if (suggestion.walk.visits > 0) {
        campus.doorways = try_doorways(suggestion.walk, campus, explored);
        campus.at_most = static_cast<int>(std::ceil(kDetour * suggestion.walk.seconds));
    }
    scene::write_file_atomically(campus_file, schema_line(campus_file, kCampusSchema) + campus_yaml(campus));
    scene::write_file_atomically(
        suggestion.walk_file,
        schema_line(suggestion.walk_file, kWalkSchema) +
            walk_yaml(campus, seen_from(suggestion.walk_file, campus_file), suggestion.walk.visits));
    return suggestion;
}

}  // namespace campuswalk::tools

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "collision/world/broad_phase.h"
#include "scene/campus/campus_description.h"
#include "scene/lint/model_report.h"
#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/base/json_text.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/base/writable_path.h"
#include "tools/campuswalk/commands/commands.h"
#include "tools/campuswalk/images/images.h"
#include "tools/campuswalk/images/rendering_backend.h"
#include "tools/campuswalk/import/numbers.h"
#include "tools/campuswalk/info/model_info.h"
#include "tools/campuswalk/loading/model_importer.h"
#include "tools/campuswalk/suggest/ground_lint.h"
#include "tools/campuswalk/suggest/read_places.h"
#include "tools/campuswalk/suggest/suggest_campus.h"
#include "tools/campuswalk/suggest/suggestion_text.h"
#include "tools/campuswalk/suggest/upright_model.h"

namespace campuswalk::tools {

namespace {

struct InfoOptions {
    scene::SceneFile scene;
    bool json = false;
    bool strict = false;                           ///< what is unsure about the frame fails
    std::optional<std::filesystem::path> suggest;  ///< NAME.campus.yaml to write, with NAME.walk.yaml
    SuggestRequest suggestion;                     ///< what else it is made from
    std::optional<std::filesystem::path> places;   ///< GeoJSON, for the suggested campus or to be counted
    std::optional<std::string> place_name;         ///< the property that names them
    std::optional<std::string> origin;             ///< of the model on the Earth
    std::optional<std::filesystem::path> map;      ///< an image from above to write
    Backend backend = engine::render::RenderingBackend::automatic;  ///< draws it
};

CampusImage plan_image(const InfoOptions& options) {
    CampusImage image;
    image.plan = true;
    image.overlays.grid = true;
    image.file = *options.map;
    image.backend = options.backend;
    return image;
}

/// A campus that has nothing but the model.
scene::Campus campus_of(scene::Model model) {
    scene::Campus campus{{}, {}, {}, collision::World(std::make_unique<collision::LinearBroadPhase>())};
    campus.models.push_back(std::move(model));
    return campus;
}

void draw_map(const InfoOptions& options, scene::Model model) {
    if (model.meshes.empty()) {
        throw scene::InputError(options.scene.mark, "empty-mesh",
                                "'" + options.scene.file + "' has no triangle, so there is no map of it");
    }
    draw_campus(campus_of(std::move(model)), plan_image(options));
}

ModelInfo info_of(UprightModel upright) {
    ModelInfo info;
    info.ground = ground_of(upright);
    lint_ground(info.ground, upright.report);
    info.buildings = scene::suggest_buildings(upright.model, upright.report);
    info.upright = std::move(upright);
    return info;
}

/// Whether something about the frame has to be asked for, if that matters.
int exit_code(const InfoOptions& options, const scene::ModelReport& report) {
    const bool is_unsure = has_lint(report, "z-up") || has_lint(report, "odd-scale");
    return options.strict && is_unsure ? kUnsure : kPass;
}

scene::GeographicPlace origin_in(const std::string& text) {
    const std::vector<double> at = numbers_in(text, 2, "--origin");
    if (std::abs(at[0]) > scene::kMaxLatitude || std::abs(at[1]) > scene::kMaxLongitude) {
        throw error_about("--origin", "bad-value",
                          "'" + text + "' is no place; write LATITUDE,LONGITUDE in degrees");
    }
    return {at[0], at[1]};
}

std::optional<config::PlaceFile> place_file(const InfoOptions& options) {
    config::PlaceFile file;
    file.path = options.places.value_or(std::filesystem::path());
    file.name_property = options.place_name.value_or(file.name_property);
    return options.places ? std::optional(std::move(file)) : std::nullopt;
}

PlaceCount count_places(const config::PlaceFile& file, const std::optional<scene::GeographicPlace>& on_earth,
                        const scene::ModelReport& report) {
    PlaceCount count;
    const scene::Bounds& bounds = report.bounds;
    for (const Eigen::Vector3d& p : read_places(file, on_earth)) {
        ++count.named;
        count.within_bounds += p.x() >= bounds.min.x() && p.x() <= bounds.max.x() &&
                                       p.z() >= bounds.min.z() && p.z() <= bounds.max.z()
                                   ? 1U
                                   : 0U;
    }
    return count;
}

/// Throws unless the picture can be drawn, if one is asked for.
void require_drawable(const InfoOptions& options) {
    if (options.map) {
        require_images(options.backend);
        require_writable_png(*options.map, "the picture can't be written here");
    }
}

/// Draws what is suggested from above: the buildings numbered as in the file, the spawn, the doorways and the
/// walk.
void draw_suggestion(const InfoOptions& options, const Suggestion& suggestion) {
    PlanMarks marks;
    for (const scene::SuggestedBuilding& building : suggestion.campus.buildings) {
        const scene::UprightBox& box = building.box;
        const Eigen::Vector3d top = box.center + 0.5 * box.size.y() * Eigen::Vector3d::UnitY();
        const Eigen::Vector3d along = 0.5 * box.size.x() * box.along;
        const Eigen::Vector3d across = 0.5 * box.size.z() * box.across();
        marks.areas.push_back(
            {{top - along - across, top + along - across, top + along + across, top - along + across},
             std::to_string(marks.areas.size() + 1) + " " + building.title});
    }
    for (const SuggestedDoorway& doorway : suggestion.campus.doorways) {
        marks.doorways.push_back(doorway.at);
    }
    for (const std::vector<Eigen::Vector3d>& path : suggestion.walk.paths) {
        marks.path.insert(marks.path.end(), path.begin(), path.end());
    }
    marks.visitor.position = suggestion.campus.spawn;
    marks.visitor.yaw = suggestion.campus.yaw_deg * std::numbers::pi / 180.0;
    CampusImage image = plan_image(options);
    image.marks = std::move(marks);
    draw_campus(campus_of(suggestion.model.model), image);
}

/// Writes and prints a suggestion. Returns the exit code.
int print_suggested(const InfoOptions& options, const SuggestRequest& request) {
    require_drawable(options);
    const Suggestion suggestion = suggest_campus(options.scene, request);
    print_suggestion(suggestion);
    if (options.map) {
        require_no_input(*options.map, suggestion.model.files, "the model is read from");
        draw_suggestion(options, suggestion);
    }
    return exit_code(options, suggestion.model.report);
}

/// Prints what is in a model file and what looks wrong with it. Returns the exit code.
int print_info(const InfoOptions& options) {
    if (options.suggest && options.json) {
        throw error_about("--json", "bad-value",
                          "with --suggest, the campus and its walk are written; run info without it");
    }
    if (options.place_name && !options.places) {
        throw error_about("--places-name", "bad-value", "it is about --places; pass that, too");
    }
    const std::optional<scene::GeographicPlace> origin =
        options.origin ? std::optional(origin_in(*options.origin)) : std::nullopt;
    if (options.suggest) {
        SuggestRequest request = options.suggestion;
        request.campus_file = *options.suggest;
        request.places = place_file(options);
        request.on_earth = origin;
        return print_suggested(options, request);
    }
    if (origin && !options.places) {
        throw error_about("--origin", "bad-value",
                          "it is about --places or --suggest; pass one of them, too");
    }
    require_drawable(options);
    UprightModel upright = load_upright(options.scene, options.suggestion.typed, scene::EmptyModel::accept);
    if (options.map) {
        require_no_input(*options.map, upright.files, "the model is read from");
    }
    ModelInfo info = info_of(std::move(upright));
    const scene::ModelReport& report = info.upright.report;
    if (options.places) {
        info.places = count_places(*place_file(options), origin ? origin : report.geographic, report);
    }
    if (options.json) {
        print_lines(json_text(json_of(info), 2));
    } else {
        print_text(info);
    }
    if (options.map) {
        draw_map(options, std::move(info.upright.model));
    }
    return exit_code(options, report);
}

}  // namespace

void add_info(Command program, CommandAction& chosen) {
    const auto options = std::make_shared<InfoOptions>();
    Command command = program.add("info", "Report what is in a model file and what looks wrong");
    command.option({.names = "SCENE",
                    .help = "A model file: glTF, OBJ, FBX, COLLADA, ...",
                    .value = "FILE",
                    .required = true},
                   [&scene = options->scene](const std::string& file) {
                       scene.file = file;
                       scene.path = file;
                       scene.mark.file = file;
                   });
    add_file_frame(command, options->scene, "the file");
    command.flag({.names = "--json", .help = "Print JSON"}, options->json);
    command.flag({.names = "--strict",
                  .help = "Fail if the upper axis or the scale is unsure, or unlike what was typed"},
                 options->strict);
    command.option(
        {.names = "--suggest",
         .help = "Write a first campus of it, with buildings, a spawn on open ground and triggers, and "
                 "NAME.walk.yaml beside it that visits some of them",
         .value = "NAME.campus.yaml"},
        options->suggest);
    command.flag({.names = "--overwrite", .help = "Let --suggest replace existing files"},
                 options->suggestion.overwrite);
    command.option(
        {.names = "--places",
         .help =
             "GeoJSON with named points, which are counted; the campus of --suggest refers to them and its "
             "walk visits them",
         .value = "FILE.geojson"},
        options->places);
    command.option({.names = "--places-name",
                    .help = "The property that names the points of --places; default: name",
                    .value = "PROPERTY"},
                   options->place_name);
    command.option(
        {.names = "--origin",
         .help = "Where [0, 0, 0] of the model, or of the campus of --suggest, is on the Earth, for "
                 "--places",
         .value = "LAT,LON"},
        options->origin);
    command.option(
        {.names = "--map",
         .help = "Draw it from above, with a grid of its coordinates; with --suggest also the numbered "
                 "buildings, the doorways, the spawn and the walk",
         .value = "FILE.png"},
        options->map);
    add_rendering_backend(command, options->backend);
    add_import_options(command);
    command.footer(
        "Exit code: 0 read, whatever its warnings; 1 with --strict, if its frame is unsure; 2 bad usage or "
        "input.");
    command.choose(chosen, [options, command] {
        options->suggestion.typed = {is_typed(command, "--up"), is_typed(command, "--scale")};
        return print_info(*options);
    });
}

}  // namespace campuswalk::tools

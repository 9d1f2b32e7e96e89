#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "collision/world/broad_phase.h"
#include "engine/events/decimals.h"
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
#include "tools/campuswalk/loading/model_importer.h"
#include "tools/campuswalk/suggest/ground_lint.h"
#include "tools/campuswalk/suggest/lint_text.h"
#include "tools/campuswalk/suggest/suggest_campus.h"
#include "tools/campuswalk/suggest/upright_model.h"

namespace campuswalk::tools {

using scene::ModelReport;

namespace {

struct InfoOptions {
    scene::SceneFile scene;
    bool json = false;
    std::optional<std::filesystem::path> suggest;  ///< NAME.campus.yaml to write, with NAME.walk.yaml
    SuggestRequest suggestion;                     ///< what else it is made from
    std::optional<std::string> origin;             ///< of the suggested campus on the Earth
    std::optional<std::filesystem::path> map;      ///< an image from above to write
    Backend backend = engine::render::RenderingBackend::automatic;  ///< draws it
};

// Limits of the text: nobody reads more, and the warnings come below.
constexpr std::size_t kMaxMaterials = 50;
constexpr std::size_t kMaxNodes = 200;

Json json_of(const Eigen::Vector3d& v) {
    return {v.x(), v.y(), v.z()};
}

/// Null for empty bounds.
Json json_of(const scene::Bounds& bounds) {
    return bounds.empty() ? Json() : Json{{"min", json_of(bounds.min)}, {"max", json_of(bounds.max)}};
}

Json json_of(const std::optional<scene::GeographicPlace>& place) {
    return place ? Json{{"latitude_deg", place->latitude_deg},
                        {"longitude_deg", place->longitude_deg},
                        {"height", place->height},
                        {"at", json_of(place->at)}}
                 : Json();
}

Json json_of(const std::optional<engine::GroundCover>& ground) {
    return ground
               ? Json{{"area", ground->area}, {"complete", !ground->is_cut_short}, {"height", ground->height}}
               : Json();
}

const char* name_of(scene::AlphaMode mode) {
    switch (mode) {
        case scene::AlphaMode::mask:
            return "mask";
        case scene::AlphaMode::blend:
            return "blend";
        default:
            return "opaque";
    }
}

/// As config/schema/info.schema.json says.
Json json_of(const ModelReport& report, const std::optional<engine::GroundCover>& ground,
             const std::vector<scene::ModelLint>& warnings) {
    Json json = {{"campuswalk_info", 1},
                 {"file", report.file},
                 {"meshes", report.meshes},
                 {"placements", report.placements},
                 {"triangles", report.triangles},
                 {"vertices", report.vertices},
                 {"bounds", json_of(report.bounds)},
                 {"origin_near", json_of(scene::origin_near(report.bounds))},
                 {"geographic", json_of(report.geographic)},
                 {"ground", json_of(ground)},
                 {"materials", Json::array()},
                 {"textures", Json::array()},
                 {"nodes", Json::array()},
                 {"warnings", Json::array()}};
    for (const scene::MaterialReport& m : report.materials) {
        json["materials"].push_back({{"name", m.name},
                                     {"texture", m.texture.empty() ? Json() : Json(m.texture)},
                                     {"triangles", m.triangles},
                                     {"alpha_mode", name_of(m.alpha_mode)},
                                     {"double_sided", m.double_sided}});
    }
    for (const scene::TextureReport& t : report.textures) {
        json["textures"].push_back({{"name", t.name}, {"width", t.width}, {"height", t.height}});
    }
    for (const scene::NodeReport& n : report.nodes) {
        json["nodes"].push_back({{"name", n.name},
                                 {"parent", n.parent < 0 ? Json() : Json(n.parent)},
                                 {"depth", n.depth},
                                 {"triangles", n.triangles},
                                 {"bounds", json_of(n.bounds)}});
    }
    for (const scene::ModelLint& w : warnings) {
        Json& warning = json["warnings"].emplace_back(Json{{"code", w.code}, {"message", w.message}});
        for (const scene::ModelLint::Place& place : w.places) {
            warning["places"].push_back({{"node", place.node}, {"at", json_of(place.at)}});
        }
    }
    return json;
}

void print_omitted(std::size_t count, std::size_t shown) {
    if (count > shown) {
        print_line("  and %zu more: see --json", count - shown);
    }
}

std::string text_of(const scene::GeographicPlace& place) {
    constexpr int kDigits = 8;  // a millimetre
    return "latitude " + engine::fixed(place.latitude_deg, kDigits) + ", longitude " +
           engine::fixed(place.longitude_deg, kDigits) + ", height " + engine::fixed(place.height, 3) +
           " m, at " + engine::fixed(place.at);
}

void print_text(const ModelReport& report, const std::optional<engine::GroundCover>& ground,
                const std::vector<scene::ModelLint>& warnings) {
    const Eigen::Vector3d size = report.bounds.max - report.bounds.min;
    print_line("%s", report.file.c_str());
    print_line("meshes     %zu, placed %zu times", report.meshes, report.placements);
    print_line("triangles  %zu", report.triangles);
    if (report.triangles > 0) {
        print_line("bounds     %s to %s m (%s x %s x %s m)", engine::fixed(report.bounds.min).c_str(),
                   engine::fixed(report.bounds.max).c_str(), engine::fixed(size.x(), 3).c_str(),
                   engine::fixed(size.y(), 3).c_str(), engine::fixed(size.z(), 3).c_str());
    }
    if (const Eigen::Vector3d origin = scene::origin_near(report.bounds); !origin.isZero(0.0)) {
        print_line("origin     %s m, with `origin: {at: near}`", engine::fixed(origin).c_str());
    }
    if (ground) {
        print_line("ground     %s", ground_text(*ground).c_str());
    }
    if (report.geographic) {
        print_line("on Earth   %s", text_of(*report.geographic).c_str());
    }
    print_line("materials  %zu", report.materials.size());
    for (std::size_t i = 0; i < std::min(report.materials.size(), kMaxMaterials); ++i) {
        const scene::MaterialReport& m = report.materials[i];
        print_line("  %-28s %8zu triangles  %s", m.name.c_str(), m.triangles,
                   m.texture.empty() ? "no texture" : m.texture.c_str());
    }
    print_omitted(report.materials.size(), kMaxMaterials);
    print_line("nodes      %zu", report.nodes.size());
    for (std::size_t i = 0; i < std::min(report.nodes.size(), kMaxNodes); ++i) {
        const scene::NodeReport& n = report.nodes[i];
        print_line("  %*s%s  %zu", 2 * n.depth, "", n.name.c_str(), n.triangles);
    }
    print_omitted(report.nodes.size(), kMaxNodes);
    print_line("warnings   %zu", warnings.size());
    print_lints(warnings);
}

void draw_map(const InfoOptions& options, scene::Model model) {
    if (model.meshes.empty()) {
        throw scene::InputError(options.scene.mark, "empty-mesh",
                                "'" + options.scene.file + "' has no triangle, so there is no map of it");
    }
    scene::Campus campus{{}, {}, {}, collision::World(std::make_unique<collision::LinearBroadPhase>())};
    campus.models.push_back(std::move(model));
    CampusImage image;
    image.plan = true;
    image.overlays.grid = true;
    image.file = *options.map;
    image.backend = options.backend;
    draw_campus(campus, image);
}

/// The model, turned upright if it seems to lie on its side: from above it would be a line.
scene::Model upright_for_map(const scene::SceneFile& scene, const ModelReport& report, scene::Model model) {
    if (!has_lint(report, "z-up") || scene.up != scene::UpAxis::y) {
        return model;
    }
    print_error_line(scene.file + ": the map is drawn with --up z");
    scene::SceneFile upright = scene;
    upright.up = scene::UpAxis::z;
    return read_model(upright, scene::EmptyModel::accept).model;
}

scene::GeographicPlace origin_in(const std::string& text) {
    const std::vector<double> at = numbers_in(text, 2, "--origin");
    if (std::abs(at[0]) > scene::kMaxLatitude || std::abs(at[1]) > scene::kMaxLongitude) {
        throw error_about("--origin", "bad-value",
                          "'" + text + "' is no place; write LATITUDE,LONGITUDE in degrees");
    }
    return {at[0], at[1]};
}

/// Prints what is in a model file and what looks wrong with it. Returns the exit code.
int print_info(const InfoOptions& options) {
    if (options.suggest) {
        SuggestRequest request = options.suggestion;
        request.campus_file = *options.suggest;
        if (options.origin) {
            request.on_earth = origin_in(*options.origin);
        }
        return suggest_campus(options.scene, request);
    }
    if (options.suggestion.places || options.origin) {
        throw error_about(options.suggestion.places ? "--places" : "--origin", "bad-value",
                          "it is about the campus that --suggest writes; pass that, too");
    }
    if (options.map) {
        require_images(options.backend);
        require_writable_png(*options.map, "the picture can't be written here");
    }
    scene::ImportedModel imported = read_model(options.scene, scene::EmptyModel::accept);
    ModelReport report = scene::report(imported.model);
    const std::optional<engine::GroundCover> ground = ground_of(imported.model, report);
    lint_ground(ground, report);
    std::vector<scene::ModelLint> warnings;
    for (const scene::Diagnostic& repair : imported.warnings) {
        warnings.push_back({repair.code, repair.message});
    }
    warnings.insert(warnings.end(), report.warnings.begin(), report.warnings.end());
    if (options.json) {
        print_lines(json_text(json_of(report, ground, warnings), 2));
    } else {
        print_text(report, ground, warnings);
    }
    if (options.map) {
        draw_map(options, upright_for_map(options.scene, report, std::move(imported.model)));
    }
    return kPass;
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
         .help = "GeoJSON with named points that the campus of --suggest refers to and its walk visits",
         .value = "FILE.geojson"},
        options->suggestion.places);
    command.option({.names = "--origin",
                    .help = "Where [0, 0, 0] of the campus of --suggest is on the Earth, for --places",
                    .value = "LAT,LON"},
                   options->origin);
    command.option(
        {.names = "--map", .help = "Draw it from above, with a grid of its coordinates", .value = "FILE.png"},
        options->map);
    add_rendering_backend(command, options->backend);
    add_import_options(command);
    command.choose(chosen, [options] { return print_info(*options); });
}

}  // namespace campuswalk::tools

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "config/loader/load_profile.h"
#include "engine/script/resolve_targets.h"
#include "engine/script/walk.h"
#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/base/text.h"
#include "tools/campuswalk/base/writable_path.h"
#include "tools/campuswalk/commands/commands.h"
#include "tools/campuswalk/images/images.h"
#include "tools/campuswalk/images/rendering_backend.h"
#include "tools/campuswalk/loading/model_importer.h"
#include "tools/campuswalk/loading/walk_loader.h"

namespace campuswalk::tools {

namespace {

struct SnapshotOptions {
    std::filesystem::path campus;
    /// "top" for a plan of everything, a spawn or a place to look from, or a camera's keys as in a walk:
    /// "{view: orbit, around: library}".
    std::string camera = "top";
    std::string light;  ///< as in a walk: a profile's name or what differs; empty: day
    engine::ImageChannels channels;
    engine::ImageOverlays overlays;
    std::vector<std::string> overlay_names;  ///< set the flags of `overlays`
    bool no_grid = false;                    ///< leave a plan without
    std::filesystem::path output;
    int width = 1280;  ///< pixels
    int height = 720;  ///< pixels
    Backend backend = engine::render::RenderingBackend::automatic;
};

constexpr const char* kCameraOption = "--camera";
// Names of overlays.
constexpr const char* kGrid = "grid";
constexpr const char* kLabels = "labels";

/// Puts somebody at the spawn or else the place of that name, where one looks north.
void stand_at(const scene::CampusDescription& campus, const std::string& name, engine::AvatarState& avatar) {
    std::vector<std::string> known = {"top"};
    for (const scene::Spawn& spawn : campus.spawns) {
        if (spawn.name == name) {
            avatar.position = spawn.position;
            avatar.yaw = spawn.yaw;
            return;
        }
        known.push_back(spawn.name);
    }
    for (const scene::Place& place : campus.places) {
        if (place.name == name) {
            avatar.position = place.position;
            return;
        }
        known.push_back(place.name);
    }
    throw error_about(kCameraOption, "unknown-name",
                      "'" + name + "' is neither 'top' nor a spawn or place of " + campus.name +
                          scene::did_you_mean(name, known));
}

/// A plan shows whole buildings from far above, with their names; only a grid is drawn over it besides, and
/// that over nothing else.
void refuse_overlays(const SnapshotOptions& options) {
    const bool plan = options.camera == "top";
    const auto on_plan = [](const std::string& name) { return name == kGrid || name == kLabels; };
    if (plan && (options.overlays.tree_level || !std::ranges::all_of(options.overlay_names, on_plan))) {
        throw error_about(
            options.overlays.tree_level ? "--tree-level" : "--overlay", "bad-value",
            "only a grid and labels are drawn over a plan; give another --camera, such as a spawn");
    }
    const bool asks_for_grid = std::ranges::count(options.overlay_names, kGrid) > 0;
    if (!plan && (options.no_grid || asks_for_grid)) {
        throw error_about(options.no_grid ? "--no-grid" : "--overlay", "bad-value",
                          "a grid is drawn over a plan only: --camera top");
    }
    if (options.no_grid && asks_for_grid) {
        throw error_about("--no-grid", "bad-value", "--overlay grid asks for a grid; give one or the other");
    }
}

/// Sets from where the image is taken.
void set_viewpoint(const SnapshotOptions& options, const scene::CampusDescription& campus,
                   CampusImage& image) {
    image.camera.width = options.width;
    image.camera.height = options.height;
    if (options.camera == "top") {
        image.plan = true;
        return;
    }
    if (!options.camera.starts_with('{')) {
        stand_at(campus, options.camera, image.avatar);
        return;
    }
    image.camera = config::read_camera_text(options.camera, kCameraOption, campus, image.camera);
    const auto* fixed = std::get_if<engine::FixedView>(&image.camera.view);
    const auto* orbit = std::get_if<engine::OrbitView>(&image.camera.view);
    if (!(fixed != nullptr && fixed->position) && !(orbit != nullptr && orbit->around)) {
        throw scene::InputError(
            {kCameraOption, 1, 1}, "bad-value",
            "there is no avatar here for the camera to follow: use {view: orbit, around: NAME} or "
            "{view: fixed, position: [x, y, z]}");
    }
}

engine::ImageOverlays overlays_of(const SnapshotOptions& options) {
    engine::ImageOverlays overlays = options.overlays;
    const auto named = [&](const char* name) { return std::ranges::count(options.overlay_names, name) > 0; };
    overlays.colliders = named("colliders");
    overlays.compass = named("compass");
    overlays.grid = !options.no_grid;  // on every plan
    overlays.labels = named(kLabels);
    overlays.triggers = named("triggers");
    overlays.walkspace = named("walkspace");
    return overlays;
}

/// The picture, and the files of its channels beside it.
std::vector<std::filesystem::path> outputs_of(const SnapshotOptions& options) {
    std::vector<std::filesystem::path> outputs = {options.output};
    const std::vector<std::string> names = files_of(options.output.stem().string(), options.channels);
    for (std::size_t i = 1; i < names.size(); ++i) {
        outputs.push_back(options.output.parent_path() / names[i]);
    }
    return outputs;
}

/// Draws one image of a campus without a visitor. Returns the exit code.
int draw_snapshot(const SnapshotOptions& options) {
    refuse_overlays(options);
    require_images(options.backend);
    require_writable_png(options.output, "the picture can't be written here");
    const std::vector<std::filesystem::path> outputs = outputs_of(options);
    for (const std::filesystem::path& output : outputs) {
        require_writable_file(output, "the picture can't be written here");
    }
    WalkLoader loader;
    const std::shared_ptr<const scene::Campus> campus = loader.load_campus(options.campus);
    for (const std::filesystem::path& output : outputs) {
        require_no_input(output, files_of(*campus, options.campus), "the campus is read from");
    }
    CampusImage image;
    set_viewpoint(options, campus->description, image);
    if (auto errors = engine::check_aim(*campus, image.camera.view); !errors.empty()) {
        throw scene::InputError(std::move(errors));
    }
    if (!options.light.empty()) {
        image.light =
            config::read_light_text(options.light, "--light", options.campus.parent_path(), search_paths());
    }
    image.channels = options.channels;
    image.overlays = overlays_of(options);
    image.file = options.output;
    image.backend = options.backend;
    draw_campus(*campus, image);
    return kPass;
}

/// Nullopt if a word isn't a channel.
std::optional<engine::ImageChannels> channels_in(const std::string& list) {
    engine::ImageChannels channels;
    for (const std::string_view word : split(list, ',')) {
        if (word == "depth") {
            channels.depth = true;
        } else if (word == "ids") {
            channels.ids = true;
        } else if (word == "normals") {
            channels.normals = true;
        } else {
            return std::nullopt;
        }
    }
    return channels;
}

std::string check_channels(const std::string& list) {
    return channels_in(list)
               ? ""
               : "'" + list + "' must be a comma-separated list of depth, ids and normals, as in depth,ids";
}

}  // namespace

void add_snapshot(Command program, CommandAction& chosen) {
    const auto options = std::make_shared<SnapshotOptions>();
    Command command = program.add("snapshot", "Draw one picture of a campus");
    command.option({.names = "CAMPUS", .help = "NAME.campus.yaml", .value = "FILE", .required = true},
                   options->campus);
    command.option(
        {.names = "--camera",
         .help = "top for a plan of everything, a spawn or place to look from, or a camera as in a "
                 "walk: "
                 "'{view: orbit, around: library}'",
         .value = "CAMERA",
         .show_default = true},
        options->camera);
    command.option(
        {.names = "-o,--output", .help = "The PNG file to write", .value = "FILE", .required = true},
        options->output);
    const Limits<int> pixels{16, 8192};
    command.option({.names = "--width", .help = "Pixels", .show_default = true}, options->width, pixels);
    command.option({.names = "--height", .help = "Pixels", .show_default = true}, options->height, pixels);
    command.option({.names = "--light",
                    .help = "day, overcast, night or another NAME.light.yaml; or as in a walk: "
                            "'{profile: night, anti_aliasing: fxaa}'",
                    .value = "LIGHT"},
                   options->light);
    command.option(
        {.names = "--channels",
         .help =
             "Comma-separated list of depth, ids and normals, to save beside the picture: FILE-depth.png, "
             "-ids.png, -ids.json, -normals.png",
         .value = "LIST",
         .check = check_channels},
        [&channels = options->channels](const std::string& list) { channels = *channels_in(list); });
    command.choices(
        {.names = "--overlay",
         .help = "Draw this over the picture, a grid over a plan only; may be repeated. Plans have "
                 "labels anyway"},
        {"colliders", "compass", kGrid, kLabels, "triggers", "walkspace"}, options->overlay_names);
    command.flag({.names = "--no-grid", .help = "Draw a plan without the grid of coordinates"},
                 options->no_grid);
    command.option({.names = "--tree-level",
                    .help = "Draw the boxes at this level of the collision meshes' trees",
                    .value = "N"},
                   options->overlays.tree_level, Limits<int>{0, 40});
    add_rendering_backend(command, options->backend);
    add_import_options(command);
    add_root_option(command);
    command.footer("Exit code: 0 drawn, 2 bad usage or input, 3 it can't be drawn or written.");
    command.choose(chosen, [options] { return draw_snapshot(*options); });
}

}  // namespace campuswalk::tools

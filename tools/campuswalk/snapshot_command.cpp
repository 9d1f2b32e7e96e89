#include "tools/campuswalk/snapshot_command.h"

#include <algorithm>
#include <vector>

#include "config/loader/load_run.h"
#include "tools/campuswalk/exit_codes.h"
#include "tools/campuswalk/pictures.h"
#include "tools/campuswalk/walk_loader.h"
#include "tools/campuswalk/writable_path.h"

namespace campuswalk::tools {

namespace {

constexpr const char* kAsked = "--camera";

const scene::Spawn& spawn_named(const scene::CampusDescription& campus, const std::string& name) {
    std::vector<std::string> known = {"top"};
    for (const scene::Spawn& spawn : campus.spawns) {
        if (spawn.name == name) {
            return spawn;
        }
        known.push_back(spawn.name);
    }
    throw scene::InputError(
        {kAsked, 0, 0}, "unknown-name",
        "'" + name + "' is neither 'top' nor a spawn of " + campus.name + scene::did_you_mean(name, known));
}

/// Fills in from where the picture is taken.
void aim(const SnapshotOptions& options, const scene::CampusDescription& campus, CampusPicture& picture) {
    picture.camera.width = options.width;
    picture.camera.height = options.height;
    if (options.camera == "top") {
        picture.plan = true;
        return;
    }
    if (!options.camera.starts_with('{')) {
        const scene::Spawn& spawn = spawn_named(campus, options.camera);
        picture.avatar.position = spawn.position;
        picture.avatar.yaw = spawn.yaw;
        return;
    }
    picture.camera = config::read_camera_text(options.camera, kAsked, campus, picture.camera);
    const bool alone = (picture.camera.view == engine::View::fixed && picture.camera.position) ||
                       (picture.camera.view == engine::View::orbit && picture.camera.around);
    if (!alone) {
        throw scene::InputError(
            {kAsked, 1, 1}, "bad-value",
            "nobody walks here whom a camera could follow: use {view: orbit, around: NAME} or "
            "{view: fixed, position: [x, y, z]}");
    }
}

engine::PictureOverlays overlays_of(const SnapshotOptions& options) {
    engine::PictureOverlays overlays = options.overlays;
    const auto named = [&](const char* name) { return std::ranges::count(options.overlay_names, name) > 0; };
    overlays.colliders = named("colliders");
    overlays.compass = named("compass");
    overlays.labels = named("labels");
    overlays.triggers = named("triggers");
    return overlays;
}

}  // namespace

int draw_snapshot(const SnapshotOptions& options) {
    require_pictures(options.backend);
    require_writable_picture(options.output);
    WalkLoader loader;
    const std::shared_ptr<const scene::Campus> campus = loader.load_campus(options.campus);
    CampusPicture picture;
    aim(options, campus->description, picture);
    if (!options.light.empty()) {
        picture.light =
            config::read_light_text(options.light, "--light", options.campus.parent_path(), search_paths());
    }
    picture.channels = options.channels;
    picture.overlays = overlays_of(options);
    picture.file = options.output;
    picture.backend = options.backend;
    draw_campus(*campus, picture);
    return kPass;
}

}  // namespace campuswalk::tools

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

/// Fills in from where the image is taken.
void aim(const SnapshotOptions& options, const scene::CampusDescription& campus, CampusImage& image) {
    image.camera.width = options.width;
    image.camera.height = options.height;
    if (options.camera == "top") {
        image.plan = true;
        return;
    }
    if (!options.camera.starts_with('{')) {
        const scene::Spawn& spawn = spawn_named(campus, options.camera);
        image.avatar.position = spawn.position;
        image.avatar.yaw = spawn.yaw;
        return;
    }
    image.camera = config::read_camera_text(options.camera, kAsked, campus, image.camera);
    const bool alone = (image.camera.view == engine::View::fixed && image.camera.position) ||
                       (image.camera.view == engine::View::orbit && image.camera.around);
    if (!alone) {
        throw scene::InputError(
            {kAsked, 1, 1}, "bad-value",
            "nobody walks here whom a camera could follow: use {view: orbit, around: NAME} or "
            "{view: fixed, position: [x, y, z]}");
    }
}

engine::ImageOverlays overlays_of(const SnapshotOptions& options) {
    engine::ImageOverlays overlays = options.overlays;
    const auto named = [&](const char* name) { return std::ranges::count(options.overlay_names, name) > 0; };
    overlays.colliders = named("colliders");
    overlays.compass = named("compass");
    overlays.labels = named("labels");
    overlays.triggers = named("triggers");
    return overlays;
}

}  // namespace

int draw_snapshot(const SnapshotOptions& options) {
    require_images(options.backend);
    require_writable_image(options.output);
    WalkLoader loader;
    const std::shared_ptr<const scene::Campus> campus = loader.load_campus(options.campus);
    CampusImage image;
    aim(options, campus->description, image);
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

}  // namespace campuswalk::tools

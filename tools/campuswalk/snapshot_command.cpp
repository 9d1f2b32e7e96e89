#include "tools/campuswalk/snapshot_command.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "tools/campuswalk/exit_codes.h"
#include "tools/campuswalk/pictures.h"
#include "tools/campuswalk/walk_loader.h"
#include "tools/campuswalk/writable_path.h"

namespace campuswalk::tools {

namespace {

const scene::Spawn& spawn_named(const scene::CampusDescription& campus, const std::string& name) {
    std::vector<std::string> known = {"top"};
    for (const scene::Spawn& spawn : campus.spawns) {
        if (spawn.name == name) {
            return spawn;
        }
        known.push_back(spawn.name);
    }
    throw scene::InputError(
        {"--camera", 0, 0}, "unknown-name",
        "'" + name + "' is neither 'top' nor a spawn of " + campus.name + scene::did_you_mean(name, known));
}

}  // namespace

int draw_snapshot(const SnapshotOptions& options) {
    if (!can_draw()) {
        throw std::runtime_error("this build has no rendering: configure with CAMPUSWALK_RENDER=ON");
    }
    if (const std::string why = why_file_unwritable(options.output); !why.empty()) {
        throw scene::InputError({options.output.string(), 0, 0}, "output-unwritable",
                                "the picture can't be written here: " + why);
    }
    WalkLoader loader;
    const std::shared_ptr<const scene::Campus> campus = loader.load_campus(options.campus);
    if (options.camera == "top") {
        draw_plan(*campus, options.width, options.height, options.output);
        return kPass;
    }
    const scene::Spawn& spawn = spawn_named(campus->description, options.camera);
    engine::CameraSettings camera;
    camera.width = options.width;
    camera.height = options.height;
    engine::AvatarState avatar;
    avatar.position = spawn.position;
    avatar.yaw = spawn.yaw;
    draw_campus(*campus, camera, avatar, options.output);
    return kPass;
}

}  // namespace campuswalk::tools

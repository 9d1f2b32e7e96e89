#include "engine/walkspace/explore/campus_settings.h"

#include "engine/script/avatar_body.h"

namespace campuswalk::engine {

ExploreSettings explore_settings(const scene::Campus& campus, const AvatarProfile& avatar,
                                 int ticks_per_second) {
    ExploreSettings settings;
    settings.strides.body = mover_settings(avatar);
    settings.strides.seconds = 1.0 / ticks_per_second;
    settings.strides.walk_speed = avatar.speed;
    settings.strides.run_speed = running_speed(avatar);
    settings.solids = {collision::Detection::solid, ignored_layers(campus, avatar), nullptr};
    for (const scene::Spawn& spawn : campus.description.spawns) {
        settings.starts.push_back(spawn.position);
    }
    return settings;
}

}  // namespace campuswalk::engine

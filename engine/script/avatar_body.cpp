#include "engine/script/avatar_body.h"

#include <string>

#include "collision/geometry/trigonometry.h"

namespace campuswalk::engine {

collision::MoverSettings mover_settings(const AvatarProfile& avatar) {
    collision::MoverSettings settings;
    settings.height = avatar.height;
    settings.radius = avatar.radius;
    settings.step_height = avatar.step_height;
    settings.min_up = collision::sin_cos(avatar.max_slope).cos;
    settings.skin = avatar.skin_width;
    return settings;
}

std::uint32_t ignored_layers(const scene::Campus& campus, const AvatarProfile& avatar) {
    std::uint32_t bits = 0;
    for (const std::string& layer : avatar.ignore_layers) {
        bits |= 1U << campus.layer_index(layer);
    }
    return bits;
}

}  // namespace campuswalk::engine

#pragma once

#include <cstdint>

#include "collision/mover/mover_settings.h"
#include "engine/script/avatar.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// The avatar's body for the collision layer.
collision::MoverSettings mover_settings(const AvatarProfile& avatar);
/// Bits of the layers that the avatar ignores.
std::uint32_t ignored_layers(const scene::Campus& campus, const AvatarProfile& avatar);

}  // namespace campuswalk::engine

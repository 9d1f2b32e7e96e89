#pragma once

#include <cstdint>

#include "collision/mover/mover_settings.h"
#include "engine/script/avatar.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// How far above a given position a free placement is searched for, metres (see nearest_free_placement).
/// Ground is searched for twice as far below that placement, so at least as far below the given position.
inline constexpr double kPlacementSearch = 0.5;
/// A contact with a solid begins this far beyond the skin, metres.
inline constexpr double kTouchSlack = 1e-3;

/// The avatar's body for the collision layer.
collision::MoverSettings mover_settings(const AvatarProfile& avatar);
/// Bits of the layers that the avatar ignores.
std::uint32_t ignored_layers(const scene::Campus& campus, const AvatarProfile& avatar);

}  // namespace campuswalk::engine

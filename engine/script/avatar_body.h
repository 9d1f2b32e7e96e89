#pragma once

#include <cstdint>

#include "collision/mover/mover_settings.h"
#include "engine/script/avatar.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// The avatar's body for the collision layer.
collision::MoverSettings mover_settings(const AvatarProfile& avatar);
/// The axis of the avatar's capsule at a foot point; `height` is the whole capsule's, metres.
inline collision::Segment body_axis(const AvatarProfile& avatar, const Eigen::Vector3d& foot, double height) {
    return {foot + Eigen::Vector3d(0, avatar.radius, 0),
            foot + Eigen::Vector3d(0, height - avatar.radius, 0)};
}
/// Bits of the layers that the avatar ignores.
std::uint32_t ignored_layers(const scene::Campus& campus, const AvatarProfile& avatar);

}  // namespace campuswalk::engine

#pragma once

#include <optional>
#include <span>
#include <string>

#include <Eigen/Core>

#include "engine/record/tick_record.h"
#include "engine/render/image/image.h"
#include "engine/render/snapshot/snapshot_renderer.h"
#include "engine/script/avatar.h"
#include "scene/campus/campus.h"

namespace campuswalk::tools {

/// A place on a walk, as it shall be drawn from above.
struct MapState {
    engine::AvatarState avatar;
    engine::AvatarProfile profile;
    std::span<const Eigen::Vector3d> path;  ///< walked so far
    std::string caption;                    ///< in the upper left corner
};

/// The surroundings from above, north up, with the way walked and where the avatar looks. What is over the
/// avatar's head is cut away where it stands under something solid.
engine::render::Image draw_map(const scene::Campus& campus,
                               engine::render::SnapshotRenderer& snapshot_renderer, const MapState& moment,
                               int width, int height);

}  // namespace campuswalk::tools

#pragma once

#include <span>
#include <string>

#include <Eigen/Core>

#include "engine/record/tick_record.h"
#include "engine/render/image/image.h"
#include "engine/render/snapshot/snapshot_renderer.h"
#include "engine/script/avatar.h"
#include "scene/campus/campus.h"

namespace campuswalk::tools {

/// What a map shows of a walk at one moment.
struct MapState {
    engine::AvatarState avatar;
    engine::AvatarProfile profile;
    std::span<const Eigen::Vector3d> path;  ///< walked so far
    std::string caption;                    ///< in the upper left corner
};

/// Draws the surroundings from above, north up, under a labelled grid, with the path walked and the direction
/// in which the avatar looks. What is above its head is cut away if it stands under something solid.
engine::render::Image draw_map(const scene::Campus& campus,
                               engine::render::SnapshotRenderer& snapshot_renderer, const MapState& state,
                               int width, int height);

}  // namespace campuswalk::tools

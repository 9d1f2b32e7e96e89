#pragma once

#include <vector>

#include "engine/render/geometry/overlay_lines.h"
#include "engine/script/avatar.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine::render {

/// Whose walk space is drawn, and from where.
struct WalkSpaceRequest {
    AvatarProfile profile;
    std::vector<Eigen::Vector3d> starts;  ///< feet
    double radius = 0.0;                  ///< of the first start, metres; 0: everywhere
    const std::vector<bool>* disabled = nullptr;
};

/// Adds the edge of the ground that a visitor gets to from the starts without leaving the radius, and a dot
/// for one in four cells of it.
void add_walk_space(const scene::Campus& campus, const WalkSpaceRequest& request,
                    std::vector<OverlayLine>& lines);

}  // namespace campuswalk::engine::render

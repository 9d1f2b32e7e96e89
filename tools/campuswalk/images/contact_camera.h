#pragma once

#include <Eigen/Core>

#include "engine/render/snapshot/snapshot_renderer.h"
#include "scene/campus/campus.h"

namespace campuswalk::tools {

/// Aims the request's camera at a point that the avatar touches, from behind and beside it: from where
/// neither the avatar, a wall nor anything else that is drawn hides that point, and from where the avatar is
/// in the image, if there is such a place. Returns the camera.
engine::render::Viewpoint aim_at_contact(const scene::Campus& campus,
                                         engine::render::SnapshotRenderer& snapshot_renderer,
                                         const Eigen::Vector3d& contact,
                                         engine::render::SnapshotRequest& request);

}  // namespace campuswalk::tools

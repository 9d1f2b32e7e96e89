#pragma once

#include <vector>

#include "engine/record/tick_record.h"
#include "engine/render/overlay/walk_trail.h"
#include "engine/render/snapshot/snapshot_renderer.h"
#include "engine/script/walk.h"

namespace campuswalk::engine::render {

/// Follows a walk, and has what all images of it show alike: the avatar in its step, its way, the windows
/// that are open.
class SnapshotRequestBuilder {
public:
    void begin(const Walk& walk);
    /// Every tick, whether an image is taken or not.
    void follow(const AvatarState& avatar) { trail_.follow(avatar); }

    const LightSettings& light() const { return light_; }
    /// Refers to this and to `record`: draw it before either changes.
    SnapshotRequest request(const TickRecord& record, const CameraSettings& camera);

private:
    AvatarProfile profile_;
    LightSettings light_;
    WalkTrail trail_;
    std::vector<Eigen::Vector3d> path_;  ///< of the latest shot
};

}  // namespace campuswalk::engine::render

#pragma once

#include <vector>

#include "engine/record/tick_record.h"
#include "engine/render/overlay/walk_trail.h"
#include "engine/render/snapshot/snapshot_renderer.h"
#include "engine/script/walk.h"

namespace campuswalk::engine::render {

/// Follows a walk and fills in the parts that are common to all its snapshots: avatar, gait, path, open
/// pop-ups.
class SnapshotRequestBuilder {
public:
    void begin(const Walk& walk);
    /// To be called every tick.
    void follow(const AvatarState& avatar) { trail_.follow(avatar); }

    const LightSettings& light() const { return light_; }
    /// The result refers to this object and to `record`: draw it before either changes.
    SnapshotRequest request(const TickRecord& record, const CameraSettings& camera);

private:
    AvatarProfile profile_;
    LightSettings light_;
    WalkTrail trail_;
    std::vector<Eigen::Vector3d> path_;  ///< of the latest request
};

}  // namespace campuswalk::engine::render

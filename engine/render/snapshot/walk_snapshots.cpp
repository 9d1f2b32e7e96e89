#include "engine/render/snapshot/walk_snapshots.h"

namespace campuswalk::engine::render {

void SnapshotRequestBuilder::begin(const Walk& walk) {
    profile_ = walk.avatar;
    light_ = walk.light;
    trail_.clear();
}

SnapshotRequest SnapshotRequestBuilder::request(const TickRecord& record, const CameraSettings& camera) {
    path_ = trail_.path();
    SnapshotRequest request;
    request.camera = camera;
    request.avatar = record.avatar;
    request.profile = profile_;
    request.stride = trail_.stride();
    request.open_popups = record.open_popups;
    request.path = path_;
    request.disabled = record.disabled;
    return request;
}

}  // namespace campuswalk::engine::render

#include "engine/render/snapshot/walk_shots.h"

namespace campuswalk::engine::render {

void WalkShots::begin(const Walk& walk) {
    profile_ = walk.avatar;
    light_ = walk.light;
    trail_.clear();
}

Shot WalkShots::shot(const TickRecord& record, const CameraSettings& camera) {
    path_ = trail_.path();
    Shot shot;
    shot.camera = camera;
    shot.avatar = record.avatar;
    shot.profile = profile_;
    shot.stride = trail_.stride();
    shot.open_popups = record.open_popups;
    shot.path = path_;
    return shot;
}

}  // namespace campuswalk::engine::render

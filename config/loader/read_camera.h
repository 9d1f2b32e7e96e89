#pragma once

#include "config/loader/checked_map.h"
#include "engine/script/walk.h"

namespace campuswalk::config {

/// Sets what the map's keys say: view, width, height, fov_deg, height_above, distance.
void read_camera_fields(CheckedMap& map, engine::CameraSettings& camera);

}  // namespace campuswalk::config

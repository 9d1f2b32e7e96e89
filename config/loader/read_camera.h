#pragma once

#include "config/loader/campus_names.h"
#include "config/loader/checked_map.h"
#include "engine/script/walk.h"

namespace campuswalk::config {

/// Sets what the map's keys say: view, width, height, fov_deg, height_above, distance, around, position,
/// look_at, yaw_deg, pitch_deg.
void read_camera_fields(CheckedMap& map, const CampusNames& names, engine::CameraSettings& camera);

/// `channels`: one of depth, ids and normals, or a list of them.
engine::ImageChannels read_channels(const CheckedNode& node);

/// `overlays`: one of path, contacts, colliders, triggers, labels and compass, or a list of them.
void read_overlays(const CheckedNode& node, engine::ImageOverlays& overlays);

}  // namespace campuswalk::config

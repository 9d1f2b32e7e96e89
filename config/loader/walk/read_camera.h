#pragma once

#include <optional>

#include <Eigen/Core>

#include "config/loader/values/checked_map.h"
#include "config/loader/walk/campus_names.h"
#include "engine/script/camera.h"
#include "engine/script/walk.h"

namespace campuswalk::config {

/// A camera's keys, of whichever view: each view uses those that it needs.
struct CameraKeys {
    engine::View (*view)(const CameraKeys& keys) = nullptr;  ///< makes the view; null: use that of `size`
    engine::CameraSettings size;                             ///< size, field of view, and the default view
    double height_above = engine::TopView().height_above;
    std::optional<double> distance;
    std::optional<engine::CameraTarget> around;
    std::optional<Eigen::Vector3d> position;
    std::optional<engine::CameraTarget> look_at;
    std::optional<double> yaw;
    std::optional<double> pitch;

    engine::CameraSettings settings() const;
    /// Every kind of view, with these keys.
    engine::Views views() const;
};

/// Sets the fields of `camera` whose keys are in the map.
void read_camera_fields(CheckedMap& map, const CampusNames& names, CameraKeys& camera);

/// Reports the keys in the map that a camera with this view doesn't use.
void refuse_unused_keys(CheckedMap& map, const engine::View& view);

/// `channels`: one of depth, ids and normals, or a list of them.
engine::ImageChannels read_channels(const CheckedNode& node);

/// `overlays`: one of path, contacts, colliders, triggers, labels, compass, grid and walkspace, or a list of
/// them.
void read_overlays(const CheckedNode& node, engine::ImageOverlays& overlays);

}  // namespace campuswalk::config

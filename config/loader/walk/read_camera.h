#pragma once

#include <optional>

#include <Eigen/Core>

#include "config/loader/values/checked_map.h"
#include "config/loader/walk/campus_names.h"
#include "engine/script/camera.h"
#include "engine/script/walk.h"

namespace campuswalk::config {

/// What is written about a camera, for whichever view: those that don't need a key leave it to the others.
struct CameraKeys {
    engine::View (*view)(const CameraKeys& keys) = nullptr;  ///< makes the view; null: that of `size`
    engine::CameraSettings size;                             ///< and what isn't written
    double height_above = engine::TopView().height_above;
    std::optional<double> distance;
    std::optional<engine::CameraTarget> around;
    std::optional<Eigen::Vector3d> position;
    std::optional<engine::CameraTarget> look_at;
    std::optional<double> yaw;
    std::optional<double> pitch;

    engine::CameraSettings settings() const;
    /// Each as it would be, were it the one.
    engine::Views views() const;
};

/// Sets what the map's keys say: view, width, height, fov_deg, height_above, distance, around, position,
/// look_at, yaw_deg, pitch_deg.
void read_camera_fields(CheckedMap& map, const CampusNames& names, CameraKeys& camera);

/// `channels`: one of depth, ids and normals, or a list of them.
engine::ImageChannels read_channels(const CheckedNode& node);

/// `overlays`: one of path, contacts, colliders, triggers, labels and compass, or a list of them.
void read_overlays(const CheckedNode& node, engine::ImageOverlays& overlays);

}  // namespace campuswalk::config

#pragma once

#include <optional>

#include <Eigen/Core>

#include "scene/import/gltf/document.h"
#include "scene/model/origin.h"

namespace campuswalk::scene::gltf {

/// What CESIUM_RTC says of a file, in which coordinates are about a center far away.
struct CenterFrame {
    Eigen::Matrix4d X_file_rtc = Eigen::Matrix4d::Identity();
    std::optional<GeographicPlace> place;  ///< on the Earth; its `at` is yet unknown
};

/// A center in the Earth's own frame, as map servers have it, becomes the house's origin, with up and north
/// as they are there. Any other is a map's, and moves the file there: along +X, its third number up, its
/// second towards -Z, for the extension's axes are z-up. Identity for a file without. Throws Fault.
CenterFrame center_frame(const Document& document);

}  // namespace campuswalk::scene::gltf

#pragma once

#include <optional>

#include <Eigen/Core>

namespace campuswalk::scene {

/// A location on the Earth (WGS 84) and its position in the world frame.
struct GeographicPlace {
    double latitude_deg = 0.0;   ///< from -90 to 90
    double longitude_deg = 0.0;  ///< from -180 to 180
    double height = 0.0;         ///< metres above the ellipsoid, or whatever the file refers to
    Eigen::Vector3d at = Eigen::Vector3d::Zero();

    friend bool operator==(const GeographicPlace&, const GeographicPlace&) = default;
};

constexpr double kMaxLatitude = 90.0;
constexpr double kMaxLongitude = 180.0;

/// How the world frame relates to the scenes' own coordinates and to the Earth.
struct Origin {
    /// Subtracted from the scenes' coordinates, metres: p_scene = p_world + at.
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    std::optional<GeographicPlace> geographic;

    bool is_known() const { return geographic.has_value() || !at.isZero(0.0); }
};

/// Metres from 0 beyond which coordinates are taken for those of a map.
constexpr double kFarAway = 10e3;

}  // namespace campuswalk::scene

#pragma once

#include <optional>

#include <Eigen/Core>

namespace campuswalk::scene {

/// A place on the Earth (WGS 84) and where in the world it is.
struct GeographicPlace {
    double latitude_deg = 0.0;   ///< from -90 to 90
    double longitude_deg = 0.0;  ///< from -180 to 180
    double height = 0.0;         ///< metres above the ellipsoid, or as the file means it
    Eigen::Vector3d at = Eigen::Vector3d::Zero();

    friend bool operator==(const GeographicPlace&, const GeographicPlace&) = default;
};

constexpr double kMaxLatitude = 90.0;
constexpr double kMaxLongitude = 180.0;

/// Where a campus lies outside of itself.
struct Origin {
    /// What was taken off the scenes' coordinates: a point of the world and this make the point that they
    /// have. Metres, along the world's axes.
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    std::optional<GeographicPlace> geographic;

    bool is_known() const { return geographic.has_value() || !at.isZero(0.0); }
};

/// From where on coordinates are a map's, metres: a thing so far off is hard to talk about.
constexpr double kFarAway = 10e3;

}  // namespace campuswalk::scene

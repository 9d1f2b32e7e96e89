#pragma once

#include <Eigen/Core>

#include "scene/model/origin.h"

namespace campuswalk::scene {

/// Latitude and longitude, degrees (WGS 84).
struct GeographicPoint {
    double latitude_deg = 0.0;
    double longitude_deg = 0.0;
};

/// East and north in the plane that touches the WGS 84 ellipsoid at an origin: the orthographic projection of
/// the local east-north-up frame. A length r metres from the origin comes out too short by r²/(2·6378137²) of
/// it, 3e-7 at 5 km; directions at the origin are exact.
class Projection {
public:
    Projection(double latitude_deg, double longitude_deg);

    /// (east, north), metres.
    Eigen::Vector2d project(double latitude_deg, double longitude_deg) const;
    /// The point of the ellipsoid that `project` maps there, on this side of the Earth.
    GeographicPoint unproject(const Eigen::Vector2d& p) const;

private:
    Eigen::Vector3d origin_;  ///< earth-centred, earth-fixed, metres
    Eigen::Vector3d east_;
    Eigen::Vector3d north_;
    Eigen::Vector3d up_;
};

/// From a campus's world frame, where +X is east and -Z north, to the Earth and back.
class MapFrame {
public:
    /// `place`: what is known of one point of the world.
    explicit MapFrame(const GeographicPlace& place);

    /// (longitude, latitude, height), as GeoJSON has them (RFC 7946): degrees, and metres above what the
    /// place's height refers to. Heights are counted from the plane, not along the Earth's curve: 2 m less
    /// at 5 km.
    Eigen::Vector3d to_map(const Eigen::Vector3d& p_world) const;
    Eigen::Vector3d to_world(const Eigen::Vector3d& map) const;

private:
    GeographicPlace place_;
    Projection projection_;
};

}  // namespace campuswalk::scene

#pragma once

#include "scene/osm/map.h"

namespace campuswalk::scene::osm {

/// East and north in the plane that touches the WGS 84 ellipsoid at an origin: the orthographic projection of
/// the local east-north-up frame. A length r metres from the origin comes out too short by r²/(2·6378137²) of
/// it, 3e-7 at 5 km; directions at the origin are exact.
class Projection {
public:
    Projection(double latitude_deg, double longitude_deg);

    Point project(double latitude_deg, double longitude_deg) const;

private:
    Eigen::Vector3d origin_;  ///< earth-centred, earth-fixed, metres
    Eigen::Vector3d east_;
    Eigen::Vector3d north_;
};

}  // namespace campuswalk::scene::osm

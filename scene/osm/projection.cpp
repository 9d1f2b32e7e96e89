#include "scene/osm/projection.h"

#include <cmath>
#include <numbers>

#include "collision/geometry/trigonometry.h"

namespace campuswalk::scene::osm {
namespace {

constexpr double kRadians = std::numbers::pi / 180.0;

/// Of the point on the ellipsoid, earth-centred and earth-fixed (EPSG guidance note 7-2, section 4.1.1).
Eigen::Vector3d geocentric(double latitude_deg, double longitude_deg) {
    constexpr double kSemiMajor = 6378137.0;
    constexpr double kFlattening = 1.0 / 298.257223563;
    constexpr double kEccentricity2 = kFlattening * (2.0 - kFlattening);
    const collision::SinCos latitude = collision::sin_cos(latitude_deg * kRadians);
    const collision::SinCos longitude = collision::sin_cos(longitude_deg * kRadians);
    const double normal = kSemiMajor / std::sqrt(1.0 - kEccentricity2 * latitude.sin * latitude.sin);
    return {normal * latitude.cos * longitude.cos, normal * latitude.cos * longitude.sin,
            normal * (1.0 - kEccentricity2) * latitude.sin};
}

double dot(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

}  // namespace

Projection::Projection(double latitude_deg, double longitude_deg)
    : origin_(geocentric(latitude_deg, longitude_deg)) {
    const collision::SinCos latitude = collision::sin_cos(latitude_deg * kRadians);
    const collision::SinCos longitude = collision::sin_cos(longitude_deg * kRadians);
    east_ = {-longitude.sin, longitude.cos, 0.0};
    north_ = {-latitude.sin * longitude.cos, -latitude.sin * longitude.sin, latitude.cos};
}

Point Projection::project(double latitude_deg, double longitude_deg) const {
    const Eigen::Vector3d offset = geocentric(latitude_deg, longitude_deg) - origin_;
    return {dot(offset, east_), dot(offset, north_)};
}

}  // namespace campuswalk::scene::osm

#include "scene/model/projection.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "collision/geometry/trigonometry.h"

namespace campuswalk::scene {
namespace {

constexpr double kRadians = std::numbers::pi / 180.0;
constexpr double kSemiMajor = 6378137.0;
constexpr double kFlattening = 1.0 / 298.257223563;
constexpr double kEccentricity2 = kFlattening * (2.0 - kFlattening);

/// Of the point on the ellipsoid, earth-centred and earth-fixed (EPSG guidance note 7-2, section 4.1.1).
Eigen::Vector3d geocentric(double latitude_deg, double longitude_deg) {
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
    up_ = {latitude.cos * longitude.cos, latitude.cos * longitude.sin, latitude.sin};
}

Eigen::Vector2d Projection::project(double latitude_deg, double longitude_deg) const {
    const Eigen::Vector3d offset = geocentric(latitude_deg, longitude_deg) - origin_;
    return {dot(offset, east_), dot(offset, north_)};
}

GeographicPoint Projection::unproject(const Eigen::Vector2d& p) const {
    // Down from the plane to the ellipsoid x² + y² + z²/(1 - e²) = a²: a quadratic equation for the distance.
    const auto product = [](const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
        return u.x() * v.x() + u.y() * v.y() + u.z() * v.z() / (1.0 - kEccentricity2);
    };
    const Eigen::Vector3d above = origin_ + p.x() * east_ + p.y() * north_;
    const double a = product(up_, up_);
    const double b = product(above, up_);
    const double c = product(above, above) - kSemiMajor * kSemiMajor;
    const double down = c / (b + std::sqrt(std::max(b * b - a * c, 0.0)));
    const Eigen::Vector3d on = above - down * up_;
    const double from_axis = std::sqrt(on.x() * on.x() + on.y() * on.y());
    return {collision::angle_of(on.z(), (1.0 - kEccentricity2) * from_axis) / kRadians,
            collision::angle_of(on.y(), on.x()) / kRadians};
}

MapFrame::MapFrame(const GeographicPlace& place)
    : place_(place), projection_(place.latitude_deg, place.longitude_deg) {}

Eigen::Vector3d MapFrame::to_map(const Eigen::Vector3d& p_world) const {
    const Eigen::Vector3d from_place = p_world - place_.at;
    const GeographicPoint point = projection_.unproject({from_place.x(), -from_place.z()});
    return {point.longitude_deg, point.latitude_deg, from_place.y() + place_.height};
}

Eigen::Vector3d MapFrame::to_world(const Eigen::Vector3d& map) const {
    const Eigen::Vector2d p = projection_.project(map.y(), map.x());
    return place_.at + Eigen::Vector3d(p.x(), map.z() - place_.height, -p.y());
}

}  // namespace campuswalk::scene

#pragma once

#include <optional>

#include <Eigen/Core>

#include "scene/model/origin.h"

namespace campuswalk::scene {

/// The local tangent frame at a point near the Earth's surface, which is given in ECEF coordinates (metres
/// from the Earth's centre, x towards latitude 0 and longitude 0, z towards the north pole; WGS 84).
struct TangentFrame {
    GeographicPlace place;
    /// To x east, y up, z south.
    Eigen::Matrix3d R_local_ecef = Eigen::Matrix3d::Identity();
};

/// nullopt if the point is over 100 km from the ellipsoid: then it isn't in ECEF coordinates.
std::optional<TangentFrame> tangent_frame(const Eigen::Vector3d& p_ecef);

}  // namespace campuswalk::scene

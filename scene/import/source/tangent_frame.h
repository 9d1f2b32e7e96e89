#pragma once

#include <optional>

#include <Eigen/Core>

#include "scene/model/origin.h"

namespace campuswalk::scene {

/// A place near the Earth's surface, found from its coordinates in the Earth's own frame (ECEF: metres from
/// the centre, x to latitude 0 and longitude 0, z to the north pole; WGS 84).
struct TangentFrame {
    GeographicPlace place;
    /// Turns the Earth's axes to the house's there: x east, y up, z south.
    Eigen::Matrix3d R_local_ecef = Eigen::Matrix3d::Identity();
};

/// nullopt for what lies more than 100 km above or below the ellipsoid: not the Earth's frame, then.
std::optional<TangentFrame> tangent_frame(const Eigen::Vector3d& p_ecef);

}  // namespace campuswalk::scene

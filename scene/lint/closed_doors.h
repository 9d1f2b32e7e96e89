#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "scene/model/model.h"

namespace campuswalk::scene {

/// A panel that closes a way through: without it a visitor could go on, on both sides.
struct ClosedDoor {
    std::size_t node = 0;
    Eigen::Vector3d foot = Eigen::Vector3d::Zero();  ///< world, the middle of its lower edge
    double width = 0.0;                              ///< metres
    double height = 0.0;                             ///< metres
};

/// Nodes called doors (see is_door_name) with something solid to their left and right, and nodes without that
/// name whose own triangles are an upright panel as large as a door, which has besides something above and
/// a floor before and behind. A door that stands open closes nothing, and one with a wall behind it
/// neither. In the file's order.
std::vector<ClosedDoor> find_closed_doors(const Model& model);

}  // namespace campuswalk::scene

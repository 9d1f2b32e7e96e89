#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "scene/model/model.h"

namespace campuswalk::scene {

/// A panel that blocks a doorway: there is free space on both sides of it.
struct ClosedDoor {
    std::size_t node = 0;
    Eigen::Vector3d foot = Eigen::Vector3d::Zero();  ///< world, the centre of its lower edge
    double width = 0.0;                              ///< metres
    double height = 0.0;                             ///< metres
};

/// Finds nodes named as doors (is_door_name) between two walls, and nodes with other names whose own
/// triangles form an upright panel of a door's size between two walls, with a lintel above and a floor on
/// both sides. Open doors and doors in front of a wall are left out. In order of nodes.
std::vector<ClosedDoor> find_closed_doors(const Model& model);

}  // namespace campuswalk::scene

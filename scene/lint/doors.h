#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "scene/model/model.h"

namespace campuswalk::scene {

/// A node named as a door, with its subtree, or a panel that closes a doorway.
struct Door {
    std::size_t node = 0;
    Eigen::Vector3d foot = Eigen::Vector3d::Zero();  ///< world, the centre of its lower edge
    double width = 0.0;                              ///< metres
    double height = 0.0;                             ///< metres
    bool is_closed = false;                          ///< it blocks a doorway: find_closed_doors
};

/// In order of nodes.
std::vector<Door> find_doors(const Model& model);

}  // namespace campuswalk::scene

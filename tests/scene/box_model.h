#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "scene/model/model.h"

namespace campuswalk::scene::test {

/// Adds a node with the twelve triangles of a box, facing outwards. Returns its index.
std::size_t add_box(Model& model, const std::string& name, const Eigen::Vector3d& low,
                    const Eigen::Vector3d& high, int parent = -1);

struct Box {
    Eigen::Vector3d low;
    Eigen::Vector3d high;
};

/// Adds a node with the triangles of several boxes, in a mesh each. Returns its index.
std::size_t add_boxes(Model& model, const std::string& name, const std::vector<Box>& boxes);

/// The same for a box that is rotated about +Y through its centre.
std::size_t add_turned_box(Model& model, const std::string& name, const Eigen::Vector3d& center,
                           const Eigen::Vector3d& size, double yaw_deg);

/// Adds a node without triangles.
std::size_t add_group(Model& model, const std::string& name, int parent = -1);

}  // namespace campuswalk::scene::test

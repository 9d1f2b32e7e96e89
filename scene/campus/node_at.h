#pragma once

#include <string>

#include <Eigen/Core>

#include "scene/campus/campus.h"

namespace campuswalk::scene {

/// The name of the node whose geometry is nearest to the point, of those that the object comes from; empty if
/// it has none. Messages name it where an object is as large as a building.
std::string node_at(const Campus& campus, const CampusObject& object, const Eigen::Vector3d& point);

}  // namespace campuswalk::scene

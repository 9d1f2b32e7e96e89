#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "scene/campus/campus_description.h"
#include "scene/suggest/suggested_buildings.h"

namespace campuswalk::tools {

/// A way from where the last one ended into a building's trigger.
struct SuggestedVisit {
    std::string building;                    ///< its id; empty: to a place without one
    std::vector<Eigen::Vector3d> waypoints;  ///< to walk to, one after the other
};

/// What is to be written down.
struct SuggestedCampus {
    scene::SceneFile scene;
    std::string model;  ///< path from the campus file
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    std::vector<scene::SuggestedBuilding> buildings;
    std::vector<scene::NodeGlob> doors;   ///< that are closed: not to be solid
    std::optional<scene::Bounds> ground;  ///< a box to stand on where the model has nothing
    Eigen::Vector3d spawn = Eigen::Vector3d::Zero();
    double yaw_deg = 0.0;
    std::vector<SuggestedVisit> visits;
};

/// The box about a building in which its pop-up opens.
scene::UprightBox trigger_about(const scene::SuggestedBuilding& building);

std::string campus_yaml(const SuggestedCampus& campus);
/// A walk that makes the first so many visits; `campus_file`: its file's name.
std::string walk_yaml(const SuggestedCampus& campus, const std::string& campus_file, std::size_t visits);

}  // namespace campuswalk::tools

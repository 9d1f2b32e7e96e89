#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "collision/geometry/shapes.h"
#include "config/loader/load_campus.h"
#include "scene/campus/campus_description.h"
#include "scene/suggest/solid_parts.h"
#include "scene/suggest/suggested_buildings.h"

namespace campuswalk::tools {

/// A way from the end of the previous visit into a trigger of a building, or to a place.
struct SuggestedVisit {
    std::string trigger;  ///< its id; empty: the way leads to no building
    Eigen::Vector3d to = Eigen::Vector3d::Zero();
    std::string place = {};  ///< its name; empty: the way leads to no place
};

/// What becomes of the inside of a building.
struct SuggestedInterior {
    bool can_be_entered = false;
    std::vector<scene::UprightBox> rooms = {};  ///< triggers; room_trigger names them
};

/// The part of the id of a building's trigger behind the building's: of the one about it from outside.
inline constexpr const char* kAroundTrigger = "/around";
/// Of a room's; `room` counts from 0.
std::string room_trigger(std::size_t room);

/// What the files of a suggested campus say.
struct SuggestedCampus {
    scene::SceneFile scene;
    std::string model;  ///< path relative to the campus file
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    std::optional<scene::GeographicPlace> on_earth;  ///< of [0, 0, 0]; none if nothing needs it
    std::optional<config::PlaceFile> places;         ///< its path is likewise relative
    std::vector<scene::SuggestedBuilding> buildings;
    std::vector<SuggestedInterior> interiors;        ///< by building
    std::vector<std::vector<std::string>> doors_of;  ///< by building: globs of its closed doors
    scene::SolidParts solids;                        ///< besides the buildings
    std::vector<scene::NodeGlob> doors;              ///< closed ones, which must not be solid
    std::optional<scene::Bounds> ground;             ///< a box to stand on if the model has no ground
    Eigen::Vector3d spawn = Eigen::Vector3d::Zero();
    double yaw_deg = 0.0;
    std::vector<SuggestedVisit> visits;
};

/// The box around a building in which its pop-up opens.
scene::UprightBox trigger_about(const scene::SuggestedBuilding& building);

/// The box inside a building that one is in after passing its door; none in a house that is too small.
std::optional<scene::UprightBox> trigger_inside(const scene::SuggestedBuilding& building);

inline constexpr double kWaist = 0.9;  ///< metres above the feet

/// About an upright box, and as far below it as feet are below a waist.
collision::Aabb box_about(const scene::UprightBox& box);

std::string campus_yaml(const SuggestedCampus& campus);
/// Whether one of the first `visits` visits leads into a building or to one of its rooms.
bool enters_something(const SuggestedCampus& campus, std::size_t visits);

/// A walk that makes the first `visits` visits; `campus_file` is the name of the campus file.
std::string walk_yaml(const SuggestedCampus& campus, const std::string& campus_file, std::size_t visits);

}  // namespace campuswalk::tools

#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "collision/geometry/shapes.h"
#include "config/loader/load_campus.h"
#include "scene/campus/campus_description.h"
#include "scene/lint/model_report.h"
#include "scene/suggest/solid_parts.h"
#include "scene/suggest/suggested_buildings.h"

namespace campuswalk::tools {

/// A way from the end of the previous visit into a trigger of a building, or to a place.
struct SuggestedVisit {
    std::string trigger;  ///< its id; empty: the way leads to no building
    Eigen::Vector3d to = Eigen::Vector3d::Zero();
    std::string place = {};  ///< its name; empty: the way leads to no place
};

/// A doorway on the way to a visit.
struct SuggestedDoorway {
    std::size_t visit = 0;                         ///< index into the visits
    Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< feet of who passes it
    double width = 0.0;                            ///< metres
    bool is_only_path = false;                     ///< closed, it leaves no other within kFarthestVisit
};

/// Visits are looked for where a visitor gets by walking so far from the spawn, metres.
inline constexpr double kFarthestVisit = 100.0;

/// Another place to start from.
struct SuggestedSpawn {
    Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< the feet
    double yaw_deg = 0.0;
    double area = 0.0;  ///< m² of the ground there, which isn't reached from the first spawn
};

/// What becomes of the inside of a building.
struct SuggestedInterior {
    bool can_be_entered = false;
    std::vector<scene::UprightBox> rooms = {};  ///< triggers; room_trigger names them
};

/// The part of the id of a building's trigger behind the building's: of the one about it from outside.
inline constexpr const char* kAroundTrigger = "/around";
/// The same part of the id of the trigger in its inside.
inline constexpr const char* kInsideTrigger = "/inside";
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
    std::size_t more_buildings = 0;            ///< without names, smaller than these
    std::vector<scene::ModelLint> doubts;      ///< about the unit and the upper axis
    std::vector<SuggestedInterior> interiors;  ///< by building
    std::vector<std::vector<std::string>>
        left_out_of;                      ///< by building: those of `left_out` that are its nodes
    scene::SolidParts solids;             ///< besides the buildings
    std::vector<std::string> left_out;    ///< globs of what must not be solid: closed doors, then the rest
    std::size_t closed_doors = 0;         ///< how many of these are doors
    std::optional<scene::Bounds> ground;  ///< a box to stand on if the model has no ground
    Eigen::Vector3d spawn = Eigen::Vector3d::Zero();
    bool starts_aside = false;  ///< the spawn is above rooms, such as on a roof: nothing else was found
    double yaw_deg = 0.0;
    std::vector<SuggestedSpawn> more_spawns = {};  ///< on other ground, that with the most of it first
    /// Where more triangles than these are near, nobody was sent: it would take too long to try.
    std::optional<double> most_triangles = {};
    std::vector<SuggestedVisit> visits;
    std::vector<SuggestedDoorway> doorways = {};  ///< once the walk has been played
    std::optional<int> at_most = {};              ///< seconds that the walk may take; likewise
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

/// What the spawn at that index of the others is called: `start-2` for the first.
std::string more_spawn_name(std::size_t index);

/// That crowded places weren't tried; empty if they were.
std::string crowded_text(const SuggestedCampus& campus);

/// What closing it does: "the doorway at [1.200, 0.000, -3.000], 0.92 m wide, leaves another path".
std::string closing_text(const SuggestedDoorway& doorway);

/// A walk that makes the first `visits` visits; `campus_file` is the campus file as seen from the walk's
/// folder.
std::string walk_yaml(const SuggestedCampus& campus, const std::string& campus_file, std::size_t visits);

}  // namespace campuswalk::tools

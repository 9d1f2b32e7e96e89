#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "scene/osm/read/map.h"

namespace campuswalk::scene::osm {

// What a map says beyond its geometry, as a campus file says it. Positions are world coordinates.

struct DraftBuilding {
    std::string id;     ///< of ASCII, from the element's number: "building-123"
    std::string title;  ///< as people there write it
    std::string kind;
    std::string hours;
    std::optional<int> floors;
    std::vector<std::pair<std::string, std::string>> info;  ///< ordered as the pop-up lists them
};

/// Solid nodes.
struct DraftSolid {
    std::string id;
    std::vector<std::string> globs;
    std::string building;  ///< empty: none
    std::string layer;     ///< empty: none
    bool each = false;
};

/// An upright box that notices visitors.
struct DraftTrigger {
    std::string id;
    std::string building;  ///< empty: none
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    Eigen::Vector3d size = Eigen::Vector3d::Ones();
    double yaw_deg = 0.0;
    std::string layer;
};

struct DraftSpawn {
    std::string name;
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    double yaw_deg = 0.0;
};

struct DraftPlace {
    std::string name;
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    std::string trigger;  ///< that one is in there; empty: none
    int importance = 0;   ///< the higher, the better to show to a visitor
};

struct CampusDraft {
    double latitude_deg = 0.0;  ///< of [0, 0, 0]
    double longitude_deg = 0.0;
    std::vector<std::string> layers;
    std::vector<DraftBuilding> buildings;
    std::vector<DraftSolid> solids;
    std::vector<DraftTrigger> triggers;
    std::vector<DraftSpawn> spawns;
    std::vector<DraftPlace> places;
};

}  // namespace campuswalk::scene::osm

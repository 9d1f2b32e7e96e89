#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "config/loader/values/checked_node.h"
#include "engine/script/walk.h"
#include "scene/campus/campus_description.h"

namespace campuswalk::config {

class CheckedMap;

/// Where an avatar is placed.
struct Placement {
    std::string label;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    std::optional<double> yaw;         ///< radians
    bool fall = false;                 ///< it is meant to be in the air
    std::optional<std::size_t> place;  ///< index into the campus' places, if it is one
};

/// What an avatar looks at.
struct Sight {
    engine::Target target;
    std::optional<std::size_t> building;  ///< index into the campus' buildings, if it is one
};

/// Turns the names and coordinates of a walk into points of its campus.
class CampusNames {
public:
    /// Null if the campus could not be read: names are then not checked.
    explicit CampusNames(const scene::CampusDescription* campus) : campus_(campus) {}

    /// A place's or a spawn's name (places first), `[x, z]` or `[x, y, z]`.
    engine::Target target(const CheckedNode& node) const;
    /// A building's, place's or spawn's name (in this order), or `[x, y, z]`.
    engine::CameraTarget camera_target(const CheckedNode& node) const;
    /// Reads what `target` reads, or else the name of a building.
    Sight sight(const CheckedNode& node) const;
    /// Reads where the first step puts the avatar: a spawn's name, or `{at, yaw_deg, fall}`, whose `at` is
    /// such a name or `[x, y, z]`.
    Placement spawn(const CheckedNode& node) const;
    /// Reads where a later step puts it: without `fall`, and a name may also be that of a place.
    Placement teleport(const CheckedNode& node) const;
    /// Reports a layer that the campus doesn't have.
    void check_layer(const CheckedNode& node, const std::string& layer) const;

private:
    Placement placement(const CheckedNode& node, bool teleports) const;
    Placement placement_named(const CheckedNode& node, bool also_places) const;
    Placement placement_in(CheckedMap& map) const;
    engine::Target target_at(const CheckedNode& node) const;
    engine::Target target_named(const CheckedNode& node, const std::string& name) const;

    /// The names of all places and spawns. Requires a campus.
    std::vector<std::string> target_names() const;
    /// The names of all places and spawns, and the ids of all buildings. Requires a campus.
    std::vector<std::string> sight_names() const;

    const scene::CampusDescription* campus_;
};

}  // namespace campuswalk::config

#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "config/loader/values/checked_node.h"
#include "engine/script/walk.h"
#include "scene/campus/campus_description.h"

namespace campuswalk::config {

/// Where an avatar is put down.
struct Placement {
    std::string label;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    std::optional<double> yaw;  ///< radians
};

/// Turns the names and coordinates of a walk into points of its campus.
class CampusNames {
public:
    /// Null when the campus could not be read: then any name may be right, and none is complained of.
    explicit CampusNames(const scene::CampusDescription* campus) : campus_(campus) {}

    /// A place's or a spawn's name (places first), `[x, z]` or `[x, y, z]`.
    engine::Target target(const CheckedNode& node) const;
    /// A building's, place's or spawn's name (in this order), or `[x, y, z]`.
    engine::CameraTarget camera_target(const CheckedNode& node) const;
    /// A spawn's name, or `{at: [x, y, z], yaw_deg: 90}`.
    Placement placement(const CheckedNode& node) const;
    /// Complains unless the campus has the layer.
    void check_layer(const CheckedNode& node, const std::string& layer) const;

private:
    engine::Target target_at(const CheckedNode& node) const;
    engine::Target target_named(const CheckedNode& node, const std::string& name) const;

    /// Of places and spawns. There is a campus.
    std::vector<std::string> standing_names() const;

    const scene::CampusDescription* campus_;
};

}  // namespace campuswalk::config

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "scene/base/diagnostic.h"
#include "scene/model/origin.h"
#include "scene/model/scene_file.h"

namespace campuswalk::scene {

/// The contents of a `NAME.campus.yaml`, validated by themselves but not yet against the models they name.
/// Lengths in metres, angles in radians; every item has the mark of where it is written.

/// A glob over node names; matching a node takes its whole subtree.
struct NodeGlob {
    SourceMark mark;
    std::string pattern;
};

/// When a contact opens a building's pop-up.
struct PopupRule {
    bool once = false;      ///< only once per walk
    double cooldown = 0.0;  ///< seconds after closing during which it doesn't reopen
    double dwell = 0.0;     ///< seconds that the contact must last
};

/// Additional information about a building, available to its texts as a variable.
struct InfoField {
    std::string name;  ///< kebab-case
    std::string value;
};

/// The information record that a pop-up shows. `title` and `text` may hold variables (see
/// engine/events/popup_text.h).
struct Building {
    SourceMark mark;
    std::string id;  ///< stable, kebab-case
    std::vector<NodeGlob> nodes;
    std::string title;
    std::string kind;
    std::string text;
    std::string hours;
    int floors = 0;
    std::vector<InfoField> info;
    bool popup = true;     ///< the default of its colliders
    PopupRule popup_rule;  ///< likewise
};

// Shapes. With nodes, numbers that are left out come from the nodes' geometry, and `center` and `base` are
// in the node's frame; without nodes they are world coordinates and required.

struct MeshShape {};

struct BoxShape {
    std::optional<Eigen::Vector3d> center;
    std::optional<Eigen::Vector3d> size;  ///< full edge lengths
    double yaw = 0.0;
};

struct SphereShape {
    std::optional<Eigen::Vector3d> center;
    std::optional<double> radius;
};

/// Upright; `height` is the total height, caps included.
struct CapsuleShape {
    std::optional<Eigen::Vector3d> base;  ///< lowest point
    std::optional<double> radius;
    std::optional<double> height;
};

/// A solid cylinder: a disc of `radius`, `width` thick along `axis`.
struct WheelShape {
    std::optional<Eigen::Vector3d> center;
    std::optional<double> radius;
    std::optional<double> width;
    Eigen::Vector3d axis = Eigen::Vector3d::UnitX();
};

using ShapeDescription = std::variant<MeshShape, BoxShape, SphereShape, CapsuleShape, WheelShape>;

/// The paper's three detection modes; an object may have several.
struct DetectionModes {
    bool solid = false;
    bool trigger = false;
    bool ray = false;
};

/// Its surface then counts for nothing but what it encloses.
inline bool is_only_trigger(const DetectionModes& modes) {
    return modes.trigger && !modes.solid && !modes.ray;
}

struct ColliderDescription {
    SourceMark mark;
    std::string id;        ///< object id in events; with `each` the prefix of every object's id
    std::string building;  ///< owner, empty for none; the loader has checked that it exists
    std::vector<NodeGlob> nodes;
    std::vector<NodeGlob> except;  ///< nodes, each with its subtree, that are left out of those
    bool each = false;             ///< one object per matched node instead of one for all
    ShapeDescription shape;
    DetectionModes modes;
    std::string layer;   ///< empty or one of CampusDescription::layers
    bool popup = false;  ///< its events open the building's pop-up
    PopupRule popup_rule;
};

struct Spawn {
    SourceMark mark;
    std::string name;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< feet
    double yaw = 0.0;                                    ///< radians about +Y, 0 looks along -Z
    bool fall = false;                                   ///< it is meant to be in the air
};

struct Place {
    SourceMark mark;
    std::string name;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    /// Otherwise it is reached on whichever storey, and load_campus puts it on the ground (place_heights.h).
    bool has_height = true;
};

/// The offset subtracted from all scenes' coordinates, and where on the Earth the world's origin then is.
struct CampusOrigin {
    bool near = false;  ///< `at` is to be computed by origin_near from the first scene
    Origin origin;
};

struct CampusDescription {
    std::string name;  ///< from the file's name
    SourceMark mark;
    std::vector<SceneFile> scenes;
    CampusOrigin origin;
    std::vector<std::string> layers;
    std::vector<Building> buildings;
    std::vector<ColliderDescription> colliders;
    std::vector<Spawn> spawns;
    std::vector<Place> places;
    std::vector<std::filesystem::path> place_files;  ///< that some of the places come from
    std::vector<Diagnostic> warnings;                ///< about what was read; load_campus passes them on
};

}  // namespace campuswalk::scene

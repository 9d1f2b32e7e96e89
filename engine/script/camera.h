#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include <Eigen/Core>

namespace campuswalk::engine {

/// What a camera is turned to: a building, as much of it as there is, or a point. Resolved by the loader.
struct CameraTarget {
    std::string label;                                ///< what the user wrote
    std::optional<std::size_t> building;              ///< index into the campus' buildings
    Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< without a building
};

/// From the avatar's eyes.
struct FirstPersonView {};

/// From behind the avatar.
struct ThirdPersonView {
    std::optional<double> distance = {};  ///< metres; 4 without
};

/// As a map, from above the avatar.
struct TopView {
    double height_above = 40.0;  ///< metres
};

/// From outside, towards what it goes around.
struct OrbitView {
    std::optional<CameraTarget> around = {};  ///< the avatar without
    /// Metres; without, a building fills the image and a point is 10 m away.
    std::optional<double> distance = {};
    std::optional<double> yaw = {};    ///< radians, of the look
    std::optional<double> pitch = {};  ///< radians, up positive
};

/// From a place of the campus.
struct FixedView {
    std::optional<Eigen::Vector3d> position = {};  ///< the avatar's eyes without
    std::optional<CameraTarget> look_at = {};      ///< in the place of angles
    std::optional<double> yaw = {};                ///< radians, of the look
    std::optional<double> pitch = {};              ///< radians, up positive
};

using View = std::variant<FirstPersonView, ThirdPersonView, TopView, OrbitView, FixedView>;

struct CameraSettings {
    View view;
    int width = 1280;                 ///< pixels
    int height = 720;                 ///< pixels
    double fov = 1.0471975511965976;  ///< radians (60°), vertical
};

/// What else of an image is kept, as files of numbers.
struct ImageChannels {
    bool depth = false;
    bool ids = false;  ///< which building and object each pixel shows
    bool normals = false;

    bool any() const { return depth || ids || normals; }
};

/// What is drawn over an image, for whoever wants to see how the campus works.
struct ImageOverlays {
    bool path = false;                   ///< the way walked so far
    bool contacts = false;               ///< where something solid was touched
    bool colliders = false;              ///< edges of what is solid or seen
    bool triggers = false;               ///< edges of what notices who is inside
    bool labels = false;                 ///< titles of the buildings that are in the image
    bool compass = false;                ///< where north is
    std::optional<int> tree_level = {};  ///< the boxes at this level of the meshes' trees, 0 the whole mesh'

    bool any_lines() const { return path || contacts || colliders || triggers || tree_level; }
};

/// A view of each kind, in the variant's order.
using Views = std::array<View, std::variant_size_v<View>>;

inline Views default_views() {
    return []<std::size_t... kind>(std::index_sequence<kind...>) {
        return Views{View(std::in_place_index<kind>)...};
    }
    (std::make_index_sequence<std::variant_size_v<View>>());
}

}  // namespace campuswalk::engine

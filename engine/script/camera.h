#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include <Eigen/Core>

#include "engine/script/mentions.h"

namespace campuswalk::engine {

/// What a camera looks at: a whole building or a point. Resolved by the loader.
struct CameraTarget {
    std::string label;                                ///< what the user wrote
    std::optional<std::size_t> building;              ///< index into the campus' buildings
    Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< if there is no building
    SourceMark mark = {};
};

/// What a view shows of the avatar and of the map around it. Each view says so itself: `kShows`.
struct ViewContents {
    bool figure = false;   ///< the avatar, unless the camera is at its eyes
    bool minimap = false;  ///< where one is switched on
    bool map = false;      ///< the path walked, a heading arrow, a scale bar and a north arrow
};

/// From the avatar's eyes.
struct FirstPersonView {
    static constexpr ViewContents kShows{.minimap = true};
};

/// From behind the avatar.
struct ThirdPersonView {
    static constexpr ViewContents kShows{.figure = true, .minimap = true};
    std::optional<double> distance = {};  ///< metres; none: 4
};

/// As a map, from above the avatar.
struct TopView {
    static constexpr ViewContents kShows{.map = true};
    double height_above = 40.0;  ///< metres
};

/// From outside, towards what it orbits.
struct OrbitView {
    static constexpr ViewContents kShows{.figure = true};
    std::optional<CameraTarget> around = {};  ///< none: the avatar
    /// Metres; none: a building fills the image, a point is 10 m away.
    std::optional<double> distance = {};
    std::optional<double> yaw = {};    ///< radians, the direction of view
    std::optional<double> pitch = {};  ///< radians, up positive
};

/// From a fixed point on the campus.
struct FixedView {
    static constexpr ViewContents kShows{.figure = true};
    std::optional<Eigen::Vector3d> position = {};  ///< none: the avatar's eyes
    std::optional<CameraTarget> look_at = {};      ///< instead of angles
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

/// What else is written of an image, as files of numbers.
struct ImageChannels {
    bool depth = false;
    bool ids = false;  ///< the building and object that each pixel shows
    bool normals = false;

    bool any() const { return depth || ids || normals; }
};

/// What is drawn over an image to show how the campus works.
struct ImageOverlays {
    bool path = false;       ///< walked so far
    bool contacts = false;   ///< where solid objects were touched
    bool colliders = false;  ///< edges of objects that are solid or seen
    bool triggers = false;   ///< edges of trigger volumes
    bool labels = false;     ///< titles of the buildings in the image
    bool compass = false;    ///< where north is
    bool grid = false;       ///< lines at round coordinates, from above only
    bool walkspace = false;  ///< ground that the avatar gets to from where it is
    /// The boxes at this level of the meshes' trees; 0 is the whole mesh's.
    std::optional<int> tree_level = {};
};

/// One view of each kind, in the variant's order.
using Views = std::array<View, std::variant_size_v<View>>;

inline Views default_views() {
    return []<std::size_t... kind>(std::index_sequence<kind...>) {
        return Views{View(std::in_place_index<kind>)...};
    }
    (std::make_index_sequence<std::variant_size_v<View>>());
}

}  // namespace campuswalk::engine

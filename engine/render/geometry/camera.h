#pragma once

#include <functional>
#include <optional>

#include <Eigen/Core>

#include "engine/record/tick_record.h"
#include "engine/script/avatar.h"
#include "engine/script/walk.h"
#include "scene/model/model.h"

namespace campuswalk::engine::render {

enum class Projection { perspective, orthographic };

/// A camera resolved to numbers: position, orientation and field of view. World frame, metres, radians.
struct Viewpoint {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    Eigen::Matrix3d R_world_camera = Eigen::Matrix3d::Identity();  ///< columns: right, up, backwards
    Projection projection = Projection::perspective;
    double fov = 1.0471975511965976;  ///< vertical; for Projection::perspective
    double height = 100.0;            ///< metres from the lower to the upper edge; for orthographic
    double near_distance = 0.1;       ///< nothing closer is drawn; see keep_near_plane_free
    double far_distance = 2000.0;     ///< for orthographic only; a perspective view extends to infinity
};

/// The distance in metres from `from` towards `to` that is free of solid objects, at most up to `to`.
/// Supplied by the owner of the collision world.
using FreeDistance = std::function<double(const Eigen::Vector3d& from, const Eigen::Vector3d& to)>;

/// The distance in metres from a point to the nearest solid object, at most `most`. Supplied likewise.
using FreeRadius = std::function<double(const Eigen::Vector3d& point, double most)>;

/// Moves the near plane of a perspective view so close that its corners are within the free space around the
/// camera, of an image of width / height = `aspect`: else it would show what is behind a wall, a floor or a
/// ceiling. Only where it is that narrow.
void keep_near_plane_free(Viewpoint& view, double aspect, const FreeRadius& free_radius);

/// At `position`, turned by yaw (0 along -Z, positive to the left) and pitch (up positive).
Viewpoint looking(const Eigen::Vector3d& position, double yaw, double pitch, double fov);

/// At `position`, turned to `target`; level and to the north if both are the same point.
Viewpoint looking_at(const Eigen::Vector3d& position, const Eigen::Vector3d& target, double fov);

/// Turned by yaw and pitch, with `centre` in the middle of the image, `distance` metres from the camera.
Viewpoint orbiting(const Eigen::Vector3d& centre, double distance, double yaw, double pitch, double fov);

/// Likewise around the centre of `box`, at the distance at which all of it fits, with a margin, into an image
/// of width / height = `aspect`.
Viewpoint orbiting(const scene::Bounds& box, double aspect, double yaw, double pitch, double fov);

/// Through the avatar's eyes.
Viewpoint first_person(const AvatarState& avatar, const AvatarProfile& profile, double fov);

/// From `distance` metres behind and a little above the avatar, closer if a wall is in between, lower under a
/// ceiling.
Viewpoint third_person(const AvatarState& avatar, const AvatarProfile& profile, double fov, double distance,
                       const FreeDistance& free_distance);

/// Straight down with north (-Z) up, as a map: orthographic, so that no tower hides its neighbours. Shows
/// what a perspective camera `height_above` metres over `ground` would see at the height of `ground`.
Viewpoint top(const Eigen::Vector3d& ground, double height_above, double fov, const scene::Bounds& campus);

/// The whole campus from above, fitted into an image of width / height = `aspect` with a margin.
Viewpoint plan(const scene::Bounds& campus, double aspect);

/// Maps world points (homogeneous) to clip space: depth 1 at the near plane falling to 0 at the far one,
/// so that floats are finest far away; y up.
Eigen::Matrix4d clip_from_world(const Viewpoint& view, double aspect);

/// Pixel coordinates of a world point (x right, y down, from the upper left corner), which may be outside the
/// image; nullopt if the point is behind the camera.
std::optional<Eigen::Vector2d> pixel_of(const Viewpoint& view, int width, int height,
                                        const Eigen::Vector3d& point);

}  // namespace campuswalk::engine::render

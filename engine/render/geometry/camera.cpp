#include "engine/render/geometry/camera.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace campuswalk::engine::render {
namespace {

// Third person: the camera looks over the avatar's head, down by this much.
constexpr double kBehindPitch = -0.17;
constexpr double kAboveEyes = 0.15;      // metres, of the point that it circles
constexpr double kWallClearance = 0.25;  // metres, so that the near plane's corners stay on this side
constexpr double kClosest = 0.3;         // metres, so that the camera stays out of the avatar's head
constexpr double kThisSide = 0.9;        // of the way to a wall that is nearer than that

constexpr double kRounding = 1e-9;  // metres
constexpr double kNearest = 1e-6;   // metres, of the near plane of a camera in a wall

constexpr double kOrbitMargin = 1.08;  // of the distance at which a building just fits into the image
constexpr double kClosestOrbit = 0.5;  // metres

constexpr double kPlanMargin = 1.06;    // of the campus' extent
constexpr double kAboveCampus = 10.0;   // metres over the highest roof
constexpr double kBelowCampus = 200.0;  // metres: a hole in the ground still has a bottom
constexpr double kSmallestPlan = 1.0;   // metres

Eigen::Matrix3d rotation(double yaw, double pitch) {
    return (Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitY()) *
            Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitX()))
        .toRotationMatrix();
}

Viewpoint downwards(const Eigen::Vector3d& over, double height, const scene::Bounds& campus) {
    Viewpoint view;
    view.projection = Projection::orthographic;
    view.R_world_camera = rotation(0.0, -1.5707963267948966);
    const double highest = campus.empty() ? over.y() : std::max(campus.max.y(), over.y());
    const double lowest = campus.empty() ? over.y() : std::min(campus.min.y(), over.y());
    view.position = {over.x(), highest + kAboveCampus, over.z()};
    view.height = height;
    view.near_distance = 0.0;
    view.far_distance = view.position.y() - lowest + kBelowCampus;
    return view;
}

}  // namespace

void keep_near_plane_free(Viewpoint& view, double aspect, const FreeRadius& free_radius) {
    if (!free_radius || view.projection != Projection::perspective) {
        return;
    }
    const double slope = std::tan(0.5 * view.fov);
    const double farthest =
        std::sqrt(1.0 + slope * slope * (1.0 + aspect * aspect));  // of the near plane, in near distances
    const double free = free_radius(view.position, view.near_distance * farthest);
    view.near_distance =
        std::clamp(free / farthest, std::min(kNearest, view.near_distance), view.near_distance);
}

Viewpoint looking(const Eigen::Vector3d& position, double yaw, double pitch, double fov) {
    Viewpoint view;
    view.position = position;
    view.R_world_camera = rotation(yaw, pitch);
    view.fov = fov;
    return view;
}

Viewpoint looking_at(const Eigen::Vector3d& position, const Eigen::Vector3d& target, double fov) {
    const Eigen::Vector3d offset = target - position;
    const double level = std::hypot(offset.x(), offset.z());
    const double yaw = level > 0.0 ? std::atan2(-offset.x(), -offset.z()) : 0.0;
    return looking(position, yaw, std::atan2(offset.y(), level), fov);
}

Viewpoint orbiting(const Eigen::Vector3d& centre, double distance, double yaw, double pitch, double fov) {
    Viewpoint view = looking(centre, yaw, pitch, fov);
    view.position += distance * view.R_world_camera.col(2);
    return view;
}

Viewpoint orbiting(const scene::Bounds& box, double aspect, double yaw, double pitch, double fov) {
    const Eigen::Vector3d centre = box.center();
    const Eigen::Matrix3d R_camera_world = rotation(yaw, pitch).transpose();
    const double slope = std::tan(0.5 * fov);
    double distance = kClosestOrbit;
    for (int i = 0; i < 8; ++i) {
        const Eigen::Vector3d vertex((i & 1) != 0 ? box.max.x() : box.min.x(),
                                     (i & 2) != 0 ? box.max.y() : box.min.y(),
                                     (i & 4) != 0 ? box.max.z() : box.min.z());
        const Eigen::Vector3d p = R_camera_world * (vertex - centre);  // right, up, backwards
        distance = std::max({distance, p.z() + kOrbitMargin * std::abs(p.x()) / (slope * aspect),
                             p.z() + kOrbitMargin * std::abs(p.y()) / slope});
    }
    return orbiting(centre, distance, yaw, pitch, fov);
}

Viewpoint first_person(const AvatarState& avatar, const AvatarProfile& profile, double fov) {
    const Eigen::Vector3d eyes =
        avatar.position + avatar.stature * profile.eye_height * Eigen::Vector3d::UnitY();
    return looking(eyes, avatar.yaw, avatar.pitch, fov);
}

Viewpoint third_person(const AvatarState& avatar, const AvatarProfile& profile, double fov, double distance,
                       const FreeDistance& free_distance) {
    const Eigen::Vector3d up = Eigen::Vector3d::UnitY();
    const Eigen::Vector3d eyes = avatar.position + avatar.stature * profile.eye_height * up;
    double above = kAboveEyes;
    if (free_distance) {
        const double free = free_distance(eyes, eyes + kAboveEyes * up);
        above = free < kAboveEyes - kRounding ? 0.5 * free : kAboveEyes;
    }
    const Eigen::Vector3d pivot = avatar.position + (avatar.stature * profile.eye_height + above) * up;
    // Half of the avatar's own pitch: looking up at a tower must not put the camera into the ground.
    Viewpoint view = looking(pivot, avatar.yaw, kBehindPitch + 0.5 * avatar.pitch, fov);
    const Eigen::Vector3d backwards = view.R_world_camera.col(2);
    double behind = distance;
    if (free_distance) {
        const double free = free_distance(pivot, pivot + (distance + kWallClearance) * backwards);
        const double closest = std::min({kClosest, distance, kThisSide * free});
        behind = std::clamp(free - kWallClearance, closest, distance);
    }
    view.position = pivot + behind * backwards;
    return view;
}

Viewpoint top(const Eigen::Vector3d& ground, double height_above, double fov, const scene::Bounds& campus) {
    return downwards(ground, 2.0 * height_above * std::tan(0.5 * fov), campus);
}

Viewpoint plan(const scene::Bounds& campus, double aspect) {
    if (campus.empty()) {
        return downwards(Eigen::Vector3d::Zero(), kSmallestPlan, campus);
    }
    const Eigen::Vector3d size = campus.max - campus.min;
    const double height = std::max({size.z(), size.x() / aspect, kSmallestPlan});
    return downwards(campus.center(), kPlanMargin * height, campus);
}

Eigen::Matrix4d clip_from_world(const Viewpoint& view, double aspect) {
    Eigen::Matrix4d clip_camera = Eigen::Matrix4d::Zero();
    if (view.projection == Projection::perspective) {
        const double focal = 1.0 / std::tan(0.5 * view.fov);
        clip_camera(0, 0) = focal / aspect;
        clip_camera(1, 1) = focal;
        clip_camera(2, 3) = view.near_distance;
        clip_camera(3, 2) = -1.0;
    } else {
        const double range = view.far_distance - view.near_distance;
        clip_camera(0, 0) = 2.0 / (view.height * aspect);
        clip_camera(1, 1) = 2.0 / view.height;
        clip_camera(2, 2) = 1.0 / range;
        clip_camera(2, 3) = view.far_distance / range;
        clip_camera(3, 3) = 1.0;
    }
    Eigen::Matrix4d camera_world = Eigen::Matrix4d::Identity();
    camera_world.topLeftCorner<3, 3>() = view.R_world_camera.transpose();
    camera_world.topRightCorner<3, 1>() = -view.R_world_camera.transpose() * view.position;
    return clip_camera * camera_world;
}

std::optional<Eigen::Vector2d> pixel_of(const Viewpoint& view, int width, int height,
                                        const Eigen::Vector3d& point) {
    const Eigen::Vector4d clip = clip_from_world(view, double(width) / height) * point.homogeneous();
    if (clip.w() <= 0.0 || clip.z() > clip.w()) {
        return std::nullopt;
    }
    return Eigen::Vector2d{(0.5 + 0.5 * clip.x() / clip.w()) * width,
                           (0.5 - 0.5 * clip.y() / clip.w()) * height};
}

}  // namespace campuswalk::engine::render

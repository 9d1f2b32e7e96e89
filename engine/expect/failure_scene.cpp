#include "engine/expect/failure_scene.h"

#include <algorithm>
#include <optional>

#include "collision/geometry/closest.h"
#include "collision/world/obstacle.h"
#include "engine/events/event_text.h"
#include "engine/script/avatar_body.h"

namespace campuswalk::engine {

using collision::Segment;
using Eigen::Vector3d;

namespace {

constexpr double kReach = 10.0;  // metres
/// Contacts at most this far above the feet are the ground that the avatar walks on, metres.
constexpr double kUnderfoot = 0.1;
/// Nothing farther from the body is what a failure is about, metres.
constexpr double kNearlyTouching = 0.5;

struct Nearest {
    std::optional<std::size_t> object;
    double distance = kReach;  ///< metres, from the body
    Vector3d at = Vector3d::Zero();
};

Nearest nearest_solid(const StateSnapshot& state, const scene::Campus& campus, const AvatarProfile& avatar) {
    const Segment axis =
        collision::upright_axis(state.avatar.position, avatar.radius, state.avatar.stature * avatar.height);
    const collision::QueryFilter filter{collision::Detection::solid, ignored_layers(campus, avatar),
                                        state.disabled.get()};
    std::vector<collision::Obstacle> obstacles;
    Nearest nearest;
    // Most walks end near something: small reaches first.
    for (const double reach : {0.5, 3.0, kReach}) {
        collision::gather_obstacles(campus.world, filter, axis, avatar.radius + reach, obstacles);
        for (const collision::Obstacle& obstacle : obstacles) {
            const collision::Closest closest = collision::closest(axis, obstacle);
            const double distance = std::max(0.0, closest.distance - avatar.radius);
            if (closest.on_shape.y() > state.avatar.position.y() + kUnderfoot &&
                distance < nearest.distance) {
                nearest = {index_of(obstacle.object), distance, closest.on_shape};
            }
        }
        if (nearest.object && nearest.distance <= reach) {
            break;
        }
    }
    return nearest;
}

/// By the bounding boxes of the buildings' objects.
std::optional<std::size_t> nearest_building(const Vector3d& point, const scene::Campus& campus) {
    std::optional<std::size_t> nearest;
    double least = 1e300;
    for (std::size_t i = 0; i < campus.objects.size(); ++i) {
        if (!campus.objects[i].building) {
            continue;
        }
        const collision::Aabb& box = campus.world.bounds(static_cast<collision::ObjectId>(i));
        const Vector3d inside = point.cwiseMax(box.min).cwiseMin(box.max);
        if (const double distance = (inside - point).norm(); distance < least) {
            least = distance;
            nearest = campus.objects[i].building;
        }
    }
    return nearest;
}

}  // namespace

FailureScene scene_of(const StateSnapshot& state, const scene::Campus& campus, const AvatarProfile& avatar) {
    FailureScene scene;
    scene.tick = state.tick;
    scene.time = state.time;
    scene.position = state.avatar.position;
    scene.yaw = state.avatar.yaw;
    scene.pitch = state.avatar.pitch;
    const auto building = state.building ? state.building : nearest_building(scene.position, campus);
    if (building) {
        scene.building = campus.description.buildings[*building].id;
    }
    if (const Nearest nearest = nearest_solid(state, campus, avatar); nearest.object) {
        scene.nearest = campus.objects[*nearest.object].id;
        scene.nearest_distance = nearest.distance;
        if (nearest.distance <= kNearlyTouching) {
            scene.contact = nearest.at;
        }
    }
    for (const auto& timed : state.events) {
        if (timed) {
            scene.last_events.push_back(text_line(timed->event, timed->time));
        }
    }
    return scene;
}

void add_obstacle(const StateSnapshot& state, Failure& failure) {
    if (!state.obstacle || failure.reason || !failure.object.empty()) {
        return;
    }
    if (const Reason* why = reason_of(state.obstacle->event)) {
        failure.reason = *why;
    }
    if (const auto* by = find_field<std::string>(state.obstacle->event, "by")) {
        failure.object = *by;
    }
}

}  // namespace campuswalk::engine

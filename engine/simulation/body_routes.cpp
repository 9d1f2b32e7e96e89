#include "engine/simulation/body_routes.h"

#include <utility>
#include <variant>

#include "engine/events/decimals.h"
#include "engine/script/travel.h"
#include "engine/simulation/cached_route.h"
#include "engine/walkspace/keep_out.h"
#include "engine/walkspace/route.h"
#include "engine/walkspace/tight_places.h"
#include "engine/walkspace/trial_walk.h"
#include "engine/walkspace/unreachable.h"

namespace campuswalk::engine {

namespace {

/// For a hint, no ground is walked over: nearly all routes are guessed from the geometry, and where none
/// leads that could take long.
constexpr std::size_t kMostNodesForHint = 1;
constexpr std::size_t kMostWaypoints = 3;
constexpr double kWaypointsApart = 1.0;  // metres at least: round a corner, a route has many

/// "[1.20, -3.40], [2.00, -5.10], …": where the route turns first.
std::string first_waypoints(const Route& route) {
    std::string text;
    std::size_t count = 0;
    Eigen::Vector3d last = route.path.front();
    for (std::size_t i = 0; i + 1 < route.pieces.size(); ++i) {
        const Eigen::Vector3d& point = route.pieces[i].target.point;
        if (route.pieces[i].stride || flat(point - last).norm() < kWaypointsApart) {
            continue;
        }
        if (++count > kMostWaypoints) {
            return text + ", …";
        }
        last = point;
        text += (text.empty() ? "[" : ", [") + fixed(point.x(), 2) + ", " + fixed(point.z(), 2) + "]";
    }
    return text;
}

}  // namespace

RouteSettings BodyRoutes::settings(double speed) const {
    RouteSettings settings;
    settings.strides.body = body_.mover_settings();
    settings.strides.seconds = 1.0 / sim_.ticks_per_second;
    settings.strides.walk_speed = speed;
    settings.solids = body_.solids();
    settings.ground = memory_ != nullptr ? &memory_->ground : nullptr;
    return settings;
}

PlannedRoute BodyRoutes::plan(const GoToStep& step, double speed) {
    const RouteSettings settings = this->settings(speed);
    const auto plan = [&] { return plan_anew(step, settings); };
    return memory_ != nullptr ? cached_route({step, body_.mover_state(), settings}, *memory_, plan) : plan();
}

PlannedRoute BodyRoutes::plan_anew(const GoToStep& step, RouteSettings settings) const {
    settings.avoided = step.avoid;
    settings.keep_out = keep_out_of(campus_, step.avoid, settings.strides.body);
    if (step.prefer == RoutePreference::wide) {
        settings.is_tight = tight_places(campus_.world, settings.solids, settings.strides.body);
    }
    RouteRequest request{body_.mover_state(), step.through, step.within};
    request.to.push_back(step.target);
    auto found = plan_route(campus_.world, settings, request);
    if (auto* route = std::get_if<Route>(&found)) {
        return {std::move(*route), ""};
    }
    UnreachableReason why = why_unreachable(campus_, settings, request, std::get<NoRoute>(found));
    return {{}, std::move(why.text), why.at, why.incomplete};
}

std::string BodyRoutes::describe_route_round(const Target& target, double within) const {
    return body_.mover_state().grounded ? describe_route(body_.mover_state(), target, within) : "";
}

std::string BodyRoutes::describe_route_round(const Target& target, double within,
                                             const Eigen::Vector3d& foot) const {
    const RouteSettings settings = this->settings(body_.profile().speed);
    const auto from = TrialWalk(campus_.world, settings.strides, settings.solids, {}).put_down(foot);
    return from && from->grounded ? describe_route(*from, target, within) : "";
}

std::string BodyRoutes::describe_route(const collision::MoverState& from, const Target& target,
                                       double within) const {
    RouteSettings settings = this->settings(body_.profile().speed);
    settings.max_nodes = kMostNodesForHint;
    const auto found = plan_route(campus_.world, settings, {from, {target}, within});
    const auto* route = std::get_if<Route>(&found);
    if (route == nullptr) {
        return "";
    }
    if (route->pieces.size() == 1) {
        return "";  // straight on, had there been more time
    }
    const std::string waypoints = first_waypoints(*route);
    return "; from there a route of " + fixed(route->length(), 1) + " m leads to " + target.label +
           (waypoints.empty() ? "" : " by " + waypoints) + ": use go_to";
}

}  // namespace campuswalk::engine

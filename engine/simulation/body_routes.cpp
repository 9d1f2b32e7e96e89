#include "engine/simulation/body_routes.h"

#include <utility>
#include <variant>

#include "engine/script/travel.h"
#include "engine/simulation/cached_route.h"
#include "engine/walkspace/route/keep_out.h"
#include "engine/walkspace/route/unreachable.h"
#include "engine/walkspace/stride/tight_places.h"
#include "engine/walkspace/stride/trial_walk.h"

namespace campuswalk::engine {

namespace {

/// For a hint, no ground is walked over: nearly all routes are guessed from the geometry, and where none
/// leads that could take long.
constexpr std::size_t kMostNodesForHint = 1;
constexpr std::size_t kMostWaypoints = 3;
constexpr double kWaypointsApart = 1.0;  // metres at least: round a corner, a route has many

/// Where the route turns first, and whether it does after that.
void find_first_turns(const Route& route, RouteHint& hint) {
    Eigen::Vector3d last = route.path.front();
    for (std::size_t i = 0; i + 1 < route.pieces.size(); ++i) {
        const Eigen::Vector3d& point = route.pieces[i].target.point;
        if (route.pieces[i].stride || flat(point - last).norm() < kWaypointsApart) {
            continue;
        }
        if (hint.by.size() == kMostWaypoints) {
            hint.turns_again = true;
            return;
        }
        last = point;
        hint.by.push_back(point);
    }
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
        return {std::move(*route)};
    }
    return {{}, why_unreachable(campus_, settings, request, std::get<NoRoute>(found))};
}

std::optional<RouteHint> BodyRoutes::route_round(const Target& target, double within) const {
    return body_.mover_state().grounded ? route_hint(body_.mover_state(), target, within) : std::nullopt;
}

std::optional<RouteHint> BodyRoutes::route_round(const Target& target, double within,
                                                 const Eigen::Vector3d& foot) const {
    const RouteSettings settings = this->settings(body_.profile().speed);
    const auto from = TrialWalk(campus_.world, settings.strides, settings.solids, {}).put_down(foot);
    return from && from->grounded ? route_hint(*from, target, within) : std::nullopt;
}

std::optional<RouteHint> BodyRoutes::route_hint(const collision::MoverState& from, const Target& target,
                                                double within) const {
    RouteSettings settings = this->settings(body_.profile().speed);
    settings.max_nodes = kMostNodesForHint;
    const auto found = plan_route(campus_.world, settings, {from, {target}, within});
    const auto* route = std::get_if<Route>(&found);
    if (route == nullptr || route->pieces.size() == 1) {  // straight on, had there been more time
        return std::nullopt;
    }
    RouteHint hint{target.label, route->length()};
    find_first_turns(*route, hint);
    return hint;
}

}  // namespace campuswalk::engine

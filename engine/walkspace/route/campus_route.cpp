#include "engine/walkspace/route/campus_route.h"

#include <utility>

#include "engine/script/walk.h"
#include "engine/walkspace/explore/campus_settings.h"
#include "engine/walkspace/stride/trial_walk.h"

namespace campuswalk::engine {

RouteSettings route_settings(const scene::Campus& campus, const AvatarProfile& avatar,
                             const std::vector<bool>* disabled) {
    const ExploreSettings exploration = explore_settings(campus, avatar, SimSettings().ticks_per_second);
    RouteSettings settings{exploration.strides, exploration.solids};
    settings.solids.disabled = disabled;
    return settings;
}

collision::Vec3 route_start(const Target& from, const scene::CampusDescription& campus) {
    collision::Vec3 at = from.point;
    if (!from.has_height && !campus.spawns.empty()) {
        at.y() = campus.spawns.front().position.y();
    }
    return at;
}

std::optional<collision::MoverState> body_at(const collision::Vec3& start, const scene::Campus& campus,
                                             const RouteSettings& settings) {
    return TrialWalk(campus.world, settings.strides, settings.solids, {}).put_down(start);
}

std::variant<Route, Reason> route_or_reason(const scene::Campus& campus, const RouteSettings& settings,
                                            const RouteRequest& request) {
    auto found = plan_route(campus.world, settings, request);
    if (auto* route = std::get_if<Route>(&found)) {
        return std::move(*route);
    }
    return why_unreachable(campus, settings, request, std::get<NoRoute>(found));
}

}  // namespace campuswalk::engine

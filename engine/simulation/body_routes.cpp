#include "engine/simulation/body_routes.h"

#include <utility>
#include <variant>

#include "engine/walkspace/keep_out.h"
#include "engine/walkspace/route.h"
#include "engine/walkspace/tight_places.h"
#include "engine/walkspace/unreachable.h"

namespace campuswalk::engine {

PlannedRoute BodyRoutes::plan(const GoToStep& step, double speed) {
    RouteSettings settings;
    settings.strides.body = body_.mover_settings();
    settings.strides.seconds = 1.0 / sim_.ticks_per_second;
    settings.strides.walk_speed = speed;
    settings.solids = body_.solids();
    settings.ground = ground_;
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
    return {{}, why_unreachable(campus_, settings, request, std::get<NoRoute>(found))};
}

}  // namespace campuswalk::engine

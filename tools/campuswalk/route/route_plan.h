#pragma once

#include <string>

#include "engine/render/plan/storey_plan.h"
#include "engine/script/route.h"
#include "engine/walkspace/route.h"
#include "engine/walkspace/unreachable.h"
#include "scene/campus/campus.h"

namespace campuswalk::tools::route {

/// The route on the ground around it that one can walk on, whatever its level.
engine::render::StoreyPlan route_plan(const scene::Campus& campus, const engine::RouteSettings& settings,
                                      const engine::Route& route, const std::string& from,
                                      const std::string& to);

/// Likewise, where there is no route: the ground that one gets to, the request's last place, and what is in
/// the way.
engine::render::StoreyPlan barrier_plan(const scene::Campus& campus, const engine::RouteSettings& settings,
                                        const engine::RouteRequest& request,
                                        const engine::UnreachableReason& why, const std::string& from,
                                        const std::string& to);

}  // namespace campuswalk::tools::route

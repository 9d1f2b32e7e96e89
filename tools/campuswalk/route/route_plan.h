#pragma once

#include <string>
#include <vector>

#include "engine/render/plan/storey_plan.h"
#include "engine/script/route.h"
#include "engine/walkspace/route/route.h"
#include "scene/campus/campus.h"

namespace campuswalk::tools::route {

/// The route on the ground around it that one can walk on: a plan of each storey that it leads over, from
/// below, with its part there.
std::vector<engine::render::StoreyPlan> route_plans(const scene::Campus& campus,
                                                    const engine::RouteSettings& settings,
                                                    const engine::Route& route, const std::string& from,
                                                    const std::string& to);

/// Likewise, where there is no route: the ground that one gets to, the request's last place, and what is in
/// the way, on the storeys of these.
std::vector<engine::render::StoreyPlan> barrier_plans(const scene::Campus& campus,
                                                      const engine::RouteSettings& settings,
                                                      const engine::RouteRequest& request,
                                                      const engine::Reason& why, const std::string& from,
                                                      const std::string& to);

}  // namespace campuswalk::tools::route

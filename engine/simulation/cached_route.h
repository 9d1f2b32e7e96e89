#pragma once

#include <functional>

#include "collision/mover/mover.h"
#include "engine/script/step.h"
#include "engine/simulation/route_memory.h"
#include "engine/walkspace/route.h"

namespace campuswalk::engine {

/// What a planned route depends on, besides the campus.
struct RouteInputs {
    const GoToStep& step;
    const collision::MoverState& from;
    const RouteSettings& settings;
};

/// The route that `plan` returned before for the same, to this process or another; else what it returns.
/// Between processes, only routes are shared that took walking everywhere, and reasons why there is none; if
/// another plans the same right now, this waits for it. What `plan` throws is thrown, and the next plans
/// anew. Leaves out `Route::path`.
PlannedRoute cached_route(const RouteInputs& inputs, RouteMemory& memory,
                          const std::function<PlannedRoute()>& plan);

}  // namespace campuswalk::engine

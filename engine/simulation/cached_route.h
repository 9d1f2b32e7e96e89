#pragma once

#include <functional>

#include "collision/mover/mover.h"
#include "engine/script/step.h"
#include "engine/simulation/route_memory.h"
#include "engine/walkspace/route/route.h"

namespace campuswalk::engine {

/// What a planned route depends on, besides the campus.
struct RouteInputs {
    const GoToStep& step;
    const collision::MoverState& from;
    const RouteSettings& settings;
};

/// The route that `plan` returned before for the same, to this process or to another with the same store;
/// else what it returns. What it throws is thrown. Leaves out `Route::path`.
PlannedRoute cached_route(const RouteInputs& inputs, RouteMemory& memory,
                          const std::function<PlannedRoute()>& plan);

}  // namespace campuswalk::engine

#pragma once

#include <functional>

#include "collision/mover/mover.h"
#include "engine/script/route_planner.h"
#include "engine/script/step.h"
#include "engine/walkspace/route.h"
#include "scene/cache/cache_folder.h"
#include "scene/cache/content_hash.h"

namespace campuswalk::engine {

/// What other processes, such as a run's other workers, found of a campus' routes.
struct RouteCache {
    const scene::CacheFolder* folder = nullptr;  ///< must outlive it
    scene::ContentHash campus;                   ///< of all that the campus was read from, and of the program
};

/// What a planned route depends on, besides the campus.
struct RouteInputs {
    const GoToStep& step;
    const collision::MoverState& from;
    const RouteSettings& settings;
};

/// The route that `plan` returned to another process for the same; else what it returns. Only routes that
/// took walking everywhere are cached, and reasons why there is none; they lack `Route::path`.
PlannedRoute cached_route(const RouteInputs& inputs, const RouteCache& cache,
                          const std::function<PlannedRoute()>& plan);

}  // namespace campuswalk::engine

#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "engine/script/route_planner.h"
#include "engine/walkspace/route/ground_map.h"

namespace campuswalk::engine {

/// What a planned route depends on, besides the campus: the same bytes for the same only.
using RouteKey = std::string;

/// What other processes, such as a run's other workers, found of a campus' routes.
class RouteStore {
public:
    virtual ~RouteStore() = default;

    /// What is stored for the key, without `Route::path`; else what `plan` returns.
    virtual PlannedRoute stored_or_planned(const RouteKey& key,
                                           const std::function<PlannedRoute()>& plan) const = 0;
};

/// What is remembered of a campus from one route to the next. It saves time and changes no route. For one
/// thread.
struct RouteMemory {
    GroundMaps ground = {};
    std::shared_ptr<const RouteStore> store = {};
    std::map<RouteKey, PlannedRoute> planned = {};
    std::size_t pieces = 0;  ///< of these routes, and some for each: see cached_route
};

}  // namespace campuswalk::engine

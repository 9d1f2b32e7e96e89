#pragma once

#include <optional>

#include "engine/simulation/cached_route.h"
#include "engine/walkspace/ground_map.h"

namespace campuswalk::engine {

/// What is remembered of a campus from one route to the next. It saves time and changes no route. For one
/// thread.
struct RouteMemory {
    GroundMaps ground = {};
    std::optional<RouteCache> cache = {};
};

}  // namespace campuswalk::engine

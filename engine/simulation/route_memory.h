#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>

#include "engine/script/route_planner.h"
#include "engine/walkspace/ground_map.h"
#include "scene/cache/cache_folder.h"
#include "scene/cache/content_hash.h"

namespace campuswalk::engine {

/// What other processes, such as a run's other workers, found of a campus' routes.
struct RouteCache {
    const scene::CacheFolder* folder = nullptr;  ///< must outlive it
    scene::ContentHash campus;                   ///< of all that the campus was read from, and of the program
};

/// What is remembered of a campus from one route to the next. It saves time and changes no route. For one
/// thread.
struct RouteMemory {
    GroundMaps ground = {};
    std::optional<RouteCache> cache = {};
    /// By the hash of what each depends on.
    std::map<std::array<std::uint8_t, 32>, PlannedRoute> planned = {};
    std::size_t pieces = 0;  ///< of these routes, and some for each: see cached_route
};

}  // namespace campuswalk::engine

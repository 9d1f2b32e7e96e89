#pragma once

#include <functional>

#include "engine/simulation/route_memory.h"
#include "scene/cache/cache_folder.h"
#include "scene/cache/content_hash.h"

namespace campuswalk::engine {

/// Routes of one campus in a cache's folder: those that took walking everywhere, and reasons why there is
/// none. If another process or thread plans the same right now, this waits for it. What planning throws is
/// thrown, and the next plans anew.
class RouteFolder : public RouteStore {
public:
    /// `folder` must outlive this; `campus`: the hash of all that the campus was read from, and of the
    /// program.
    RouteFolder(const scene::CacheFolder& folder, const scene::ContentHash& campus)
        : folder_(folder), campus_(campus) {}

    PlannedRoute stored_or_planned(const RouteKey& key,
                                   const std::function<PlannedRoute()>& plan) const override;

private:
    const scene::CacheFolder& folder_;
    scene::ContentHash campus_;
};

}  // namespace campuswalk::engine

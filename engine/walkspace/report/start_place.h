#pragma once

#include <functional>
#include <optional>

#include "engine/walkspace/explore/explore.h"
#include "engine/walkspace/stride/worker_worlds.h"

namespace campuswalk::engine {

/// What a good place to start from is like.
struct StartPreference {
    collision::Vec3 near = collision::Vec3::Zero();  ///< better near here
    /// Better where this is false: inside a building. May be empty.
    std::function<bool(const collision::Vec3& foot)> is_inside = {};
};

/// Where a visitor is put down.
struct StartPlace {
    collision::Vec3 foot = collision::Vec3::Zero();
    bool is_aside = false;  ///< above other ground or rooms, such as on a roof, or within a block of terrain
};

/// Where to put a visitor down on a campus that says nothing of it: on the connected walkable ground that
/// there is most of (under the open sky it counts four times, above other ground or rooms a sixteenth) within
/// `settings.within`. In this order: not above other ground nor within a block of terrain, under the open
/// sky, not inside, far from its edges (up to 8 m), near. None without walkable ground.
std::optional<StartPlace> best_start(const WorkerWorlds& worlds, const ExploreSettings& settings,
                                     const StartPreference& preference);

}  // namespace campuswalk::engine

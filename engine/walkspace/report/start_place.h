#pragma once

#include <functional>
#include <vector>

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
    double area = 0.0;      ///< m² of the connected walkable ground that it is on
};

/// Where to put visitors down on a campus that says nothing of it: the best place of each connected walkable
/// ground within `settings.within`, and not where `settings.keep_out` is true, that counts at least a quarter
/// of the largest; that one first, and at most four. Ground under the open sky counts four times, above other
/// ground or rooms a sixteenth. A place is better, in this order: not above other ground nor within a block
/// of terrain, under the open sky, not inside, far from its edges (up to 8 m), near. Empty without walkable
/// ground.
std::vector<StartPlace> best_starts(const WorkerWorlds& worlds, const ExploreSettings& settings,
                                    const StartPreference& preference);

}  // namespace campuswalk::engine

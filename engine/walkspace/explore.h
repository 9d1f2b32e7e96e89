#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "collision/world/broad_phase.h"
#include "collision/world/world.h"
#include "engine/walkspace/walk_space.h"

namespace campuswalk::engine {

/// What is explored, and by whom.
struct ExploreSettings {
    StrideSettings strides;
    collision::QueryFilter solids;  ///< what it points to must outlive the exploration
    std::vector<collision::Vec3> starts;
    bool run = false;    ///< may also run: off edges it gets farther
    bool jump = false;   ///< may also jump, forward at the speed of its run
    double cell = 0.25;  ///< metres; smaller for a body narrower than a cell's diagonal
    std::size_t max_nodes = 60'000'000;
    std::size_t workers = 1;
    /// A broad phase for each further worker: queries of Bullet's aren't thread-safe.
    std::function<std::unique_ptr<collision::BroadPhase>()> broad_phase;
    /// Called now and then, with the nodes so far. May be empty.
    std::function<void(std::size_t nodes)> progress;
    /// Ends the exploration once it returns true; called with the nodes that are new. May be empty.
    std::function<bool(const WalkSpace&)> done;
};

/// Walks everywhere: from each node to the cells around it that have none at its height, until nothing new is
/// reached. The body leaves the ground where it can, and what it lands on is explored as well. The same
/// result for any number of workers.
WalkSpace explore(const collision::World& world, const ExploreSettings& settings);

}  // namespace campuswalk::engine

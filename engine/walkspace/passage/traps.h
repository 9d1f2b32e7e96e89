#pragma once

#include <optional>
#include <vector>

#include "engine/walkspace/barrier/why_not.h"
#include "engine/walkspace/explore/explore.h"
#include "engine/walkspace/space/walk_space.h"
#include "engine/walkspace/stride/worker_worlds.h"

namespace campuswalk::engine {

/// Ground that one gets to and can't get away from.
struct Trap {
    std::vector<WalkNodeId> nodes;
    WalkNodeId entrance;   ///< the first of its nodes that was reached from outside
    collision::Vec3 edge;  ///< where the body stood before that, feet
    double drop = 0.0;     ///< from there down into it, metres; negative: up
    /// The smallest change that would let one out. If none is found, the edge if it is a ledge, or nothing.
    std::optional<Barrier> out = {};
};

/// The largest first. Each node's strides were tried in every direction, and walks of two legs from some of
/// them, and none leads away.
std::vector<Trap> find_traps(const WorkerWorlds& worlds, const ExploreSettings& settings,
                             const WalkSpace& space);

/// Finds `Trap::out` of the first traps, the largest of a space, of which these are all. They share the
/// workers. `nodes`: what the meshes consist of.
void find_trap_barriers(const WorkerWorlds& worlds, const ExploreSettings& settings, const WalkSpace& space,
                        const scene::NodeTriangles& nodes, std::vector<Trap>& traps);

}  // namespace campuswalk::engine

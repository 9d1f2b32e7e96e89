#pragma once

#include <optional>
#include <vector>

#include "engine/walkspace/explore.h"
#include "engine/walkspace/walk_space.h"
#include "engine/walkspace/why_not.h"
#include "engine/walkspace/worker_worlds.h"

namespace campuswalk::engine {

/// Ground that one gets to and can't get away from.
struct Trap {
    std::vector<WalkNodeId> nodes;
    WalkNodeId entrance;   ///< the first of its nodes that was reached
    collision::Vec3 edge;  ///< where the body stood before it, feet
    double drop = 0.0;     ///< from there down into it, metres; negative: up
    /// The smallest change that would let one out. If none is found, the edge if it is a ledge, or nothing.
    /// See find_trap_barriers.
    std::optional<Barrier> out = {};
};

/// Where one falls out of the world, along a connected edge.
struct Hole {
    struct Edge {
        WalkNodeId node;  ///< that the stride over the edge starts from
        Stride stride;
        collision::Vec3 at;  ///< where the body last stood, feet
    };
    std::vector<Edge> edges;  ///< one for each cell of the edge; the first reached first
    double length = 0.0;      ///< along the edge, roughly, metres
};

/// The largest first. Each node's strides were tried in every direction, and walks of two legs from some of
/// them, and none leads away.
std::vector<Trap> find_traps(const WorkerWorlds& worlds, const ExploreSettings& settings,
                             const WalkSpace& space);

/// The longest first.
std::vector<Hole> find_holes(const WalkSpace& space);

}  // namespace campuswalk::engine

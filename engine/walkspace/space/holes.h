#pragma once

#include <vector>

#include "engine/walkspace/space/walk_space.h"

namespace campuswalk::engine {

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

/// The longest first.
std::vector<Hole> find_holes(const WalkSpace& space);

}  // namespace campuswalk::engine

#pragma once

#include <cstddef>
#include <vector>

#include "collision/geometry/shapes.h"
#include "collision/geometry/triangle_mesh.h"
#include "engine/walkspace/space/walk_space.h"

namespace campuswalk::tools::bench {

/// Ground that only one of two reaches: cells side by side.
struct Cluster {
    std::size_t cells = 0;
    collision::Vec3 at = collision::Vec3::Zero();  ///< the middle of one of its cells, about its middle
    collision::Aabb bounds;                        ///< of the cells' middles
};

/// Ground that one reaches and the other doesn't, within a cell and half a metre's height.
struct OneSided {
    double area = 0.0;              ///< square metres
    std::vector<Cluster> clusters;  ///< the largest first
};

struct Disagreement {
    double polygon_area = 0.0;  ///< of all triangles, seen from above, square metres
    OneSided only_ours;
    OneSided only_peer;
};

/// A walk space against triangles that a peer takes for reachable, on the walk space's grid.
Disagreement compare(const engine::WalkSpace& space, const std::vector<collision::Triangle>& triangles);

}  // namespace campuswalk::tools::bench

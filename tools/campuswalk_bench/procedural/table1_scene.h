#pragma once

#include <cstdint>
#include <vector>

#include "collision/geometry/shapes.h"
#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::tools::bench {

/// A pose of the teapot and the number of overlapping triangle pairs.
struct Table1Placement {
    collision::Pose X_cylinder_teapot;
    std::uint32_t pairs = 0;
};

/// The test scene of the paper's Table I: a teapot that intersects a cylinder in ten placements.
///
/// The paper gives the shapes and the ten numbers of overlapping pairs, but neither sizes nor poses. We chose
/// sizes and found the poses by bisection along a line, so that the numbers of pairs are exactly the paper's.
/// Its vertex counts differ: they are those of patches that share no vertices.
struct Table1Scene {
    collision::TriangleMesh cylinder;
    collision::TriangleMesh teapot;
    std::vector<Table1Placement> placements;  ///< by ascending `pairs`
};

Table1Scene table1_scene();

}  // namespace campuswalk::tools::bench

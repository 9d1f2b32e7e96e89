#pragma once

#include <vector>

#include "collision/geometry/triangle_mesh.h"
#include "tools/campuswalk_bench/procedural/campus_run.h"
#include "tools/campuswalk_bench/procedural/walk_course.h"

namespace campuswalk::tools::bench {

struct WalkableCampus {
    collision::TriangleMesh mesh;  ///< centred, +Y up
    std::vector<WalkPath> paths;   ///< on up to nine lots spread over it
    std::vector<CampusRun> runs;   ///< the kinds of the mesh's triangles
};

/// The side of a lot, metres.
constexpr double kWalkableLot = 72.0;

/// `lots` x `lots` lots of 72 m on gentle hills, each with a course (walk_course.h) with a random yaw on
/// level ground, and trees, benches and lamps around it. From 3 x 3 lots on, `paths` covers all nine sizes of
/// courses. 3, 8 and 17 lots per side make 60 thousand, half a million and 2 million triangles. The same on
/// every platform.
WalkableCampus walkable_campus(int lots);

}  // namespace campuswalk::tools::bench

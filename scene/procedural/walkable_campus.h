#pragma once

#include <vector>

#include "collision/geometry/triangle_mesh.h"
#include "scene/procedural/campus_run.h"
#include "scene/procedural/walk_course.h"

namespace campuswalk::scene {

struct WalkableCampus {
    collision::TriangleMesh mesh;  ///< about the middle of the campus, +Y up
    std::vector<WalkPath> paths;   ///< on up to nine lots that are spread over it
    std::vector<CampusRun> runs;   ///< what the mesh's triangles are, in their order
};

/// A lot's side, metres.
constexpr double kWalkableLot = 72.0;

/// `lots` x `lots` plots of 72 m on gentle hills. On each stands a course (walk_course.h) on level ground of
/// its own, turned somehow, with trees, benches and lamps around it. Every size of a course is among those
/// that are walked as soon as there are 3 x 3 lots: 3, 8 and 17 a side make 60 thousand, half a million and 2
/// million triangles. The same everywhere.
WalkableCampus walkable_campus(int lots);

}  // namespace campuswalk::scene

#pragma once

#include <vector>

#include "collision/geometry/shapes.h"
#include "collision/geometry/triangle_mesh.h"
#include "tools/campuswalk_bench/procedural/campus_run.h"

namespace campuswalk::tools::bench {

struct GeneratedCampus {
    collision::TriangleMesh mesh;       ///< centred, +Y up
    std::vector<collision::Vec3> feet;  ///< outdoor places on the ground where a visitor can stand
    std::vector<CampusRun> runs;        ///< the kinds of the mesh's triangles
};

/// The side of a lot, metres.
constexpr double kGeneratedLot = 60.0;

/// `lots` x `lots` lots of 60 m on gentle hills, each with a house with modelled windows, trees with single
/// leaves, benches and lamps: large triangles beside small ones, many of them vertical, as in models of real
/// campuses. 8 lots per side make half a million triangles, 17 make two million. The same on every platform.
GeneratedCampus generated_campus(int lots);

}  // namespace campuswalk::tools::bench

#pragma once

#include <vector>

#include "collision/geometry/shapes.h"
#include "collision/geometry/triangle_mesh.h"
#include "scene/procedural/campus_run.h"

namespace campuswalk::scene {

struct GeneratedCampus {
    collision::TriangleMesh mesh;       ///< about the middle of the campus, +Y up
    std::vector<collision::Vec3> feet;  ///< places on the ground and outdoors where a visitor can stand
    std::vector<CampusRun> runs;        ///< what the mesh's triangles are, in their order
};

/// A lot's side, metres.
constexpr double kGeneratedLot = 60.0;

/// `lots` x `lots` plots of 60 m on gentle hills. On each stands a house whose walls are window by window,
/// among trees with single leaves, benches and lamps: large triangles beside small ones, many of them seen
/// edge-on, as in models of real campuses. 8 lots a side make half a million
/// triangles, 17 two million. The same everywhere.
GeneratedCampus generated_campus(int lots);

}  // namespace campuswalk::scene

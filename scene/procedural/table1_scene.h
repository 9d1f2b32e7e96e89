#pragma once

#include <cstdint>
#include <vector>

#include "collision/geometry/shapes.h"
#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::scene {

/// Where the teapot is and how many pairs of triangles then overlap.
struct Table1Placement {
    collision::Pose X_cylinder_teapot;
    std::uint32_t pairs = 0;
};

/// The test scene of the paper's Table I: a teapot that goes through a cylinder in ten placements.
///
/// The paper names the shapes and the ten numbers of overlapping triangles, but neither sizes nor poses. Here
/// sizes are chosen and the placements found by bisection along a line, so that the numbers are the paper's
/// to the pair. Its numbers of vertices are those of meshes whose patches share none, and differ.
struct Table1Scene {
    collision::TriangleMesh cylinder;
    collision::TriangleMesh teapot;
    std::vector<Table1Placement> placements;  ///< by ascending `pairs`
};

Table1Scene table1_scene();

}  // namespace campuswalk::scene

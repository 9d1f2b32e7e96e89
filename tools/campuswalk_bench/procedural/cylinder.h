#pragma once

#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::tools::bench {

/// Sizes in metres.
struct CylinderShape {
    double radius = 1.4;
    double height = 2.5;
    int sides = 64;
    int stacks = 62;
};

/// A closed cylinder along z, centred at the origin: quads of two triangles, and a fan for each end. 8,064
/// triangles by default.
collision::TriangleMesh cylinder(const CylinderShape& shape = {});

}  // namespace campuswalk::tools::bench

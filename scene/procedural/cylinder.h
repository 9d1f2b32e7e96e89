#pragma once

#include "collision/geometry/triangle_mesh.h"

namespace campuswalk::scene {

/// Sizes in metres.
struct CylinderShape {
    double radius = 1.4;
    double height = 2.5;
    int sides = 64;
    int stacks = 62;
};

/// A closed cylinder about the origin and along z: two triangles a quad of its side, and a fan about the
/// middle of each end. 8,064 triangles as it stands.
collision::TriangleMesh cylinder(const CylinderShape& shape = {});

}  // namespace campuswalk::scene

#pragma once

#include <vector>

#include "collision/geometry/triangle_mesh.h"
#include "collision/geometry/triangle_pair.h"
#include "tests/support/dice.h"

/// Meshes whose contacts are hard to find, and the reference result. Metres.
namespace campuswalk::support {

/// Every triangle against every triangle by the exact predicate, ascending.
std::vector<collision::TrianglePair> loop_contacts(const collision::TriangleMesh& a,
                                                   const collision::TriangleMesh& b,
                                                   const collision::Pose& X_a_b);

/// Triangles with integer coordinates, 0 to 6 from `at`: they touch at vertices, along edges and in planes;
/// some are segments.
collision::TriangleMesh lattice_soup(Dice& dice, int triangles, const collision::Vec3& at);

/// One of the rotations that map the axes onto each other.
collision::Mat3 lattice_turn(Dice& dice);

/// A sphere of radius 1 in 2 n (n - 1) triangles that share vertices.
collision::TriangleMesh ball(int n);

/// Needles of a metre to ten kilometres, as thin as float32 allows, crossing or nearly parallel.
collision::TriangleMesh needles(Dice& dice, int count);

}  // namespace campuswalk::support

#pragma once

#include <vector>

#include "collision/geometry/triangle_mesh.h"
#include "collision/geometry/triangle_pair.h"
#include "tests/support/dice.h"

/// Meshes that are hard to hold against each other, and what the answer is. Metres.
namespace campuswalk::support {

/// Every triangle against every triangle by the exact predicate, ascending.
std::vector<collision::TrianglePair> loop_contacts(const collision::TriangleMesh& a,
                                                   const collision::TriangleMesh& b,
                                                   const collision::Pose& X_a_b);

/// Triangles with whole coordinates, 0 to 6 from `at`: they touch in corners, along edges and in planes, some
/// are segments.
collision::TriangleMesh lattice_soup(Dice& dice, int triangles, const collision::Vec3& at);

/// One of the turns that map the axes onto each other.
collision::Mat3 lattice_turn(Dice& dice);

/// A sphere of radius 1 in 2 n (n - 1) triangles that share corners.
collision::TriangleMesh ball(int n);

/// Needles of a metre to ten kilometres, as thin as float32 allows, across each other or nearly along.
collision::TriangleMesh needles(Dice& dice, int count);

}  // namespace campuswalk::support

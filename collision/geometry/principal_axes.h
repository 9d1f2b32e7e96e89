#pragma once

#include "collision/geometry/shapes.h"

namespace campuswalk::collision {

/// The eigenvectors of a symmetric matrix as the columns of a rotation, by ascending eigenvalue. Accurate to
/// one part in 1e9, more than axes in float32 can represent. Uses Jacobi rotations, the same operations
/// everywhere: trees must be the same on every machine.
Mat3 principal_axes(const Mat3& symmetric);

}  // namespace campuswalk::collision

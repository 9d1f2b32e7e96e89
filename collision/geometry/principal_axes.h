#pragma once

#include "collision/geometry/shapes.h"

namespace campuswalk::collision {

/// The eigenvectors of a symmetric matrix as the columns of a rotation, those of small eigenvalues first. To
/// one part in 1e9, which is what axes in float32 can show. By Jacobi's rotations, in the same few operations
/// everywhere: trees must be the same on every machine.
Mat3 principal_axes(const Mat3& symmetric);

}  // namespace campuswalk::collision

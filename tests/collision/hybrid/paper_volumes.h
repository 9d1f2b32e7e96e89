#pragma once

#include <cstdint>
#include <span>

#include <gtest/gtest.h>

#include "collision/geometry/fitting.h"

/// The paper's definitions of a node's volumes (III.A), computed from the vertices in extended precision by
/// other methods than fitting.cpp uses, and compared with the tree's.
namespace campuswalk::collision {

using Triangles = std::span<const std::uint32_t>;

/// Centre = mean of the incentres; radius = distance of the farthest vertex.
::testing::AssertionResult is_outer_sphere(const BoundingSphere& sphere, const TriangleMesh& mesh,
                                           Triangles triangles);

/// Axes = orthonormal eigenvectors of the covariance about the mean; extents and centre by projection; sphere
/// about that centre to the farthest vertex.
::testing::AssertionResult is_inner_box(const OrientedBox& box, const TriangleMesh& mesh,
                                        Triangles triangles);

}  // namespace campuswalk::collision

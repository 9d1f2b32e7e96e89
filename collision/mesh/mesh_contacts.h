#pragma once

#include <optional>
#include <vector>

#include "collision/base/query_statistics.h"
#include "collision/base/simd_target.h"
#include "collision/geometry/shapes.h"
#include "collision/geometry/triangle_pair.h"
#include "collision/mesh/mesh_collider.h"

namespace campuswalk::collision {

/// Mesh against mesh, the paper's Table I. Triangles count as closed surfaces: touching is contact. The
/// answer is exact: a pair is in it if and only if the triangles share a point, where a's corners are taken
/// as they are (float32, exact in double) and b's are `b_vertex_in_a`.
///
/// Both meshes have the same kind of tree, or std::invalid_argument is thrown; with the paper's, pairs come
/// in the order of hybrid_tree_contacts.h and `instructions` don't matter.
///
/// X_a_b maps b's frame to a's. Throws std::invalid_argument if it isn't finite or its matrix is no rotation
/// (farther from one than 1e-3, or a reflection). What a matrix lacks of a rotation makes the query slower,
/// never wrong.

/// Replaces `out` by all overlapping pairs. The order depends on the two meshes and the pose alone, not on
/// the instructions. Volume tests: of pairs of boxes; primitive tests: of pairs of triangles that their boxes
/// and planes left open; a transform is updated for each pair of nodes brought into one frame. In the hybrid
/// tree, see HybridContactStatistics.
void all_contacts(const MeshCollider& a, const MeshCollider& b, const Pose& X_a_b,
                  std::vector<TrianglePair>& out, QueryStatistics* statistics = nullptr,
                  SimdTarget simd_target = default_simd_target());

/// One overlapping pair, the same whatever the instructions; none if the surfaces are apart. Looks where
/// boxes reach deepest into each other first.
std::optional<TrianglePair> first_contact(const MeshCollider& a, const MeshCollider& b, const Pose& X_a_b,
                                          QueryStatistics* statistics = nullptr,
                                          SimdTarget simd_target = default_simd_target());

}  // namespace campuswalk::collision

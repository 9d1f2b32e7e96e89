#pragma once

#include <optional>
#include <vector>

#include "collision/base/query_statistics.h"
#include "collision/base/simd_target.h"
#include "collision/geometry/shapes.h"
#include "collision/geometry/triangle_pair.h"
#include "collision/mesh/mesh_collider.h"

namespace campuswalk::collision {

// Mesh against mesh, the paper's Table I. Triangles count as closed surfaces: touching is contact. The result
// is exact: it contains a pair if and only if the triangles share a point, where a's vertices are taken as
// they are (float32, exact in double) and b's are `b_vertex_in_a`.
//
// Both meshes must have the same kind of tree, or std::invalid_argument is thrown; with the paper's, the
// pairs are in the order of hybrid_tree_contacts.h, and `simd_target` has no effect.
//
// X_a_b maps b's frame to a's. Throws std::invalid_argument if it isn't finite or if its matrix isn't a
// rotation (farther from one than 1e-3, or a reflection). A smaller deviation from a rotation makes the query
// slower, never wrong.

/// Replaces `out` by all overlapping pairs. Their order depends on the two meshes and the pose alone, not on
/// `simd_target`. Volume tests: of pairs of boxes; primitive tests: of pairs of triangles that their boxes
/// and planes leave open; one transform update for each pair of nodes brought into one frame. For the hybrid
/// tree, see HybridContactStatistics.
void all_contacts(const MeshCollider& a, const MeshCollider& b, const Pose& X_a_b,
                  std::vector<TrianglePair>& out, QueryStatistics* statistics = nullptr,
                  SimdTarget simd_target = default_simd_target());

/// One overlapping pair, the same for every `simd_target`; none if the surfaces are apart. Looks first where
/// boxes overlap most deeply.
std::optional<TrianglePair> first_contact(const MeshCollider& a, const MeshCollider& b, const Pose& X_a_b,
                                          QueryStatistics* statistics = nullptr,
                                          SimdTarget simd_target = default_simd_target());

}  // namespace campuswalk::collision

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "collision/base/query_statistics.h"
#include "collision/geometry/triangle_pair.h"
#include "collision/hybrid/hybrid_tree.h"

namespace campuswalk::collision {

// Mesh against mesh with the paper's tree. The results are those of mesh_contacts.h, the same set.

/// A mesh and its tree.
struct HybridMesh {
    const TriangleMesh& mesh;
    const HybridTree& tree;
};

/// Volume tests: of pairs of nodes; primitive tests: of pairs of triangles; transform updates: nodes of b
/// transformed into a's frame, the cost of a rigid move: once each time that the traversal reaches a node,
/// not again for each smaller node of a that it is tested against.
///
/// The traversal descends from the pairs that no layer separates: volume_tests - outer - inner - box.
struct HybridContactStatistics : QueryStatistics {
    std::uint64_t outer = 0;  ///< pairs of nodes that the outer spheres separated
    std::uint64_t inner = 0;  ///< of the others, those that an inner sphere and a box separated
    std::uint64_t box = 0;    ///< of the others, those that the boxes separated
};

/// Replaces `out` by all overlapping pairs.
void all_contacts(const HybridMesh& a, const HybridMesh& b, const Pose& X_a_b, std::vector<TrianglePair>& out,
                  HybridContactStatistics& work);

/// The pair that all_contacts finds first.
std::optional<TrianglePair> first_contact(const HybridMesh& a, const HybridMesh& b, const Pose& X_a_b,
                                          HybridContactStatistics& work);

}  // namespace campuswalk::collision

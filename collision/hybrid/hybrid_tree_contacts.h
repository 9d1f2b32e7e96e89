#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "collision/base/query_statistics.h"
#include "collision/geometry/triangle_pair.h"
#include "collision/hybrid/hybrid_tree.h"

namespace campuswalk::collision {

// Mesh against mesh with the paper's tree, and with the trees that it is compared with. The results are those
// of mesh_contacts.h, the same set with every node test.

/// How two nodes are tested; the rest of the query is the same.
enum class NodeTest : std::uint8_t {
    hybrid,  ///< the paper's: outer spheres, each inner sphere against the other's box, box against box
    box,     ///< only the boxes: RAPID's design
    sphere,  ///< only the outer spheres
    mixed,   ///< the other reading of the paper's text: outer spheres, then a's box against b's inner sphere
};

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
void all_contacts(const HybridMesh& a, const HybridMesh& b, const Pose& X_a_b, NodeTest test,
                  std::vector<TrianglePair>& out, HybridContactStatistics& work);

/// The pair that all_contacts finds first.
std::optional<TrianglePair> first_contact(const HybridMesh& a, const HybridMesh& b, const Pose& X_a_b,
                                          NodeTest test, HybridContactStatistics& work);

}  // namespace campuswalk::collision

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "collision/base/query_statistics.h"
#include "collision/geometry/triangle_pair.h"
#include "collision/hybrid/hybrid_tree.h"

namespace campuswalk::collision {

/// Mesh against mesh on the paper's tree, and on the trees it is compared with. The answers are those of
/// mesh_contacts.h, and the same set whatever the node test.

/// How two nodes are tested; the rest of the query is the same.
enum class NodeTest : std::uint8_t {
    hybrid,  ///< the paper's: outer spheres, each inner sphere against the other's box, box against box
    box,     ///< boxes alone: RAPID's design
    sphere,  ///< outer spheres alone
    mixed,   ///< the paper's text read the other way: outer spheres, then a's box against b's inner sphere
};

/// One body: `tree` is that of `mesh`.
struct HybridMesh {
    const TriangleMesh& mesh;
    const HybridTree& tree;
};

/// Volume tests: of pairs of nodes; primitive tests: of pairs of triangles; transform updates: nodes of b
/// brought into a's frame, the cost of a rigid move: a node each time that it is descended to, but not while
/// it is held against ever smaller nodes of a.
///
/// What the three layers don't part, volume_tests - outer - inner - box, is descended from.
struct HybridContactStatistics : QueryStatistics {
    std::uint64_t outer = 0;  ///< pairs of nodes that the outer spheres parted
    std::uint64_t inner = 0;  ///< of the others, those that an inner sphere and a box parted
    std::uint64_t box = 0;    ///< of the others, those that the boxes parted
};

/// Replaces `out` by all overlapping pairs.
void all_contacts(const HybridMesh& a, const HybridMesh& b, const Pose& X_a_b, NodeTest test,
                  std::vector<TrianglePair>& out, HybridContactStatistics& work);

/// The pair that all_contacts finds first.
std::optional<TrianglePair> first_contact(const HybridMesh& a, const HybridMesh& b, const Pose& X_a_b,
                                          NodeTest test, HybridContactStatistics& work);

}  // namespace campuswalk::collision

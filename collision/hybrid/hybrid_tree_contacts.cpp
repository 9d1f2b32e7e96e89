#include "collision/hybrid/hybrid_tree_contacts.h"

#include "collision/hybrid/pair_traversal.h"

namespace campuswalk::collision {

void all_contacts(const HybridMesh& a, const HybridMesh& b, const Pose& X_a_b, std::vector<TrianglePair>& out,
                  HybridContactStatistics& work) {
    all_contacts_by<HybridNodeTest>(a, b, X_a_b, out, work);
}

std::optional<TrianglePair> first_contact(const HybridMesh& a, const HybridMesh& b, const Pose& X_a_b,
                                          HybridContactStatistics& work) {
    return first_contact_by<HybridNodeTest>(a, b, X_a_b, work);
}

}  // namespace campuswalk::collision

#include "collision/mesh/mesh_contacts.h"

#include <stdexcept>

#include <Eigen/Geometry>

#include "collision/bvh8/kernels/bvh8_contacts.h"
#include "collision/hybrid/hybrid_tree_contacts.h"

namespace campuswalk::collision {

namespace {

/// How far the pose's matrix is from a rotation.
double checked_tilt(const Pose& X_a_b) {
    const Mat3& R = X_a_b.rotation;
    if (!R.allFinite() || !X_a_b.translation.allFinite()) {
        throw std::invalid_argument("a pose isn't finite");
    }
    const double tilt = (R * R.transpose() - Mat3::Identity()).cwiseAbs().maxCoeff();
    constexpr double kMaxTilt = 1e-3;
    if (tilt > kMaxTilt || R.determinant() < 0.0) {
        throw std::invalid_argument("a pose's matrix isn't a rotation");
    }
    return tilt;
}

/// Eq. (1) on whole meshes, with slack for the few roundings of the coordinates.
bool spheres_overlap(const BoundingSphere& a, const BoundingSphere& b, const Pose& X_a_b, double tilt) {
    const Vec3 center = X_a_b * b.center;
    const double size =
        a.center.norm() + a.radius + b.center.norm() + b.radius + X_a_b.translation.stableNorm();
    const double reach = a.radius + b.radius + (3.0 * tilt + 1e-14) * size;
    return (center - a.center).stableNorm() <= reach;
}

void find_hybrid_contacts(const HybridMesh& a, const HybridMesh& b, const Pose& X_a_b, SearchMode mode,
                          std::vector<TrianglePair>& out, QueryStatistics* statistics) {
    HybridContactStatistics work;
    if (mode == SearchMode::all) {
        all_contacts(a, b, X_a_b, out, work);
    } else if (const auto pair = first_contact(a, b, X_a_b, work)) {
        out.push_back(*pair);
    }
    add_to(statistics, work);
}

void find_contacts(const MeshCollider& a, const MeshCollider& b, const Pose& X_a_b, SearchMode mode,
                   SimdTarget simd_target, std::vector<TrianglePair>& out, QueryStatistics* statistics) {
    out.clear();
    if (a.tree_kind() != b.tree_kind()) {
        throw std::invalid_argument("the two meshes have different kinds of tree");
    }
    const double tilt = checked_tilt(X_a_b);
    if (a.tree_kind() == TreeKind::hybrid) {
        find_hybrid_contacts({a.mesh(), a.hybrid_tree()}, {b.mesh(), b.hybrid_tree()}, X_a_b, mode, out,
                             statistics);
        return;
    }
    QueryStatistics work{.transform_updates = 1, .sphere_tests = 1};
    if (spheres_overlap(a.bvh8().outer, b.bvh8().outer, X_a_b, tilt)) {
        const Bvh8Pair pair{a.mesh(), b.mesh(), a.bvh8(), b.bvh8(), X_a_b, tilt};
        find_bvh8_contacts(pair, mode, simd_target, out, work);
    }
    work.volume_tests = work.sphere_tests + work.box_tests;
    add_to(statistics, work);
}

}  // namespace

void all_contacts(const MeshCollider& a, const MeshCollider& b, const Pose& X_a_b,
                  std::vector<TrianglePair>& out, QueryStatistics* statistics, SimdTarget simd_target) {
    find_contacts(a, b, X_a_b, SearchMode::all, simd_target, out, statistics);
}

std::optional<TrianglePair> first_contact(const MeshCollider& a, const MeshCollider& b, const Pose& X_a_b,
                                          QueryStatistics* statistics, SimdTarget simd_target) {
    thread_local std::vector<TrianglePair> found;
    find_contacts(a, b, X_a_b, SearchMode::first, simd_target, found, statistics);
    return found.empty() ? std::nullopt : std::optional(found.front());
}

}  // namespace campuswalk::collision

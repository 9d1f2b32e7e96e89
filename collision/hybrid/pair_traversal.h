#pragma once

#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "collision/geometry/triangle_overlap.h"
#include "collision/hybrid/hybrid_tree_contacts.h"
#include "collision/hybrid/volume_overlap.h"

namespace campuswalk::collision {

/// The volumes of a node of b, in a's frame, as far as a node test needs them.
struct PosedNode {
    BoundingSphere outer;
    OrientedBox inner;
};

/// Transforms nodes of b into a's frame.
///
/// The result concerns the vertices R x + t (b_vertex_in_a), whatever R is, and no R in floating point is
/// exactly a rotation. So a node's centres are transformed by R and t, its axes by a rotation near R, and its
/// sizes grow by as much as R moves points away from that rotation.
///
/// kOutward (volume_overlap.h) covers the rounding here, too: that of vertices and centres is some u times R
/// x and t, and t, however large, is no longer than R x and a's coordinates together where the two overlap.
class NodePose {
public:
    explicit NodePose(const Pose& X_a_b)
        : X_(X_a_b),
          rotation_(Eigen::Quaterniond(X_a_b.rotation).normalized().toRotationMatrix()),
          stretch_((X_a_b.rotation - rotation_).norm()) {}

    void set_outer(const HybridNode& node, PosedNode& posed) const {
        posed.outer = {X_ * node.outer.center, (1.0 + stretch_) * node.outer.radius};
    }
    void set_inner_sphere(const HybridNode& node, PosedNode& posed) const {
        posed.inner.center = X_ * node.inner.center;
        posed.inner.radius = (1.0 + stretch_) * node.inner.radius;
    }
    void set_box(const HybridNode& node, PosedNode& posed) const {
        set_inner_sphere(node, posed);
        posed.inner.axes = rotation_ * node.inner.axes;
        posed.inner.half_extents = node.inner.half_extents.array() + stretch_ * node.inner.radius;
    }

private:
    const Pose& X_;
    Mat3 rotation_;
    double stretch_ = 0.0;
};

/// Whether the outer spheres separate two nodes. Counts that.
inline bool separates_outer(const HybridNode& a, const PosedNode& b, HybridContactStatistics& work) {
    ++work.sphere_tests;
    const bool separate = apart(a.outer, b.outer);
    work.outer += separate ? 1U : 0U;
    return separate;
}

/// Traverses two trees at once, the larger of two nodes first as RAPID does, and calls `visit` for each
/// overlapping pair, which returns whether to go on. NodeTest says how two nodes are tested; see
/// HybridNodeTest.
///
/// Recursive, with stack frames of half a kilobyte, as many as both trees are deep together: some dozens, and
/// some hundreds in the worst trees that kMinSideDivisor allows.
template <typename NodeTest, typename Visit>
class PairTraversal {
public:
    PairTraversal(const HybridMesh& a, const HybridMesh& b, const Pose& X_a_b, Visit visit,
                  HybridContactStatistics& work)
        : a_(a), b_(b), X_a_b_(X_a_b), pose_(X_a_b), visit_(visit), work_(work) {}

    void run() {
        if (a_.tree.nodes.empty() || b_.tree.nodes.empty()) {
            return;
        }
        const HybridNode& a = a_.tree.nodes[0];
        const HybridNode& b = b_.tree.nodes[0];
        const PosedNode posed = pose(b);
        if (may_overlap(a, posed)) {
            descend(a, b, posed);
        }
    }

private:
    /// False once `visit` has returned false.
    bool descend(const HybridNode& a, const HybridNode& b, const PosedNode& posed) {
        if (a.is_leaf() && b.is_leaf()) {
            return test_triangles(a, b);
        }
        if (b.is_leaf() || (!a.is_leaf() && a.inner.radius >= b.inner.radius)) {
            for (std::uint32_t i = 0; i < 2; ++i) {
                const HybridNode& child = a_.tree.nodes[a.first + i];
                if (may_overlap(child, posed) && !descend(child, b, posed)) {
                    return false;
                }
            }
            return true;
        }
        for (std::uint32_t i = 0; i < 2; ++i) {
            const HybridNode& child = b_.tree.nodes[b.first + i];
            const PosedNode posed_child = pose(child);
            if (may_overlap(a, posed_child) && !descend(a, child, posed_child)) {
                return false;
            }
        }
        return true;
    }

    PosedNode pose(const HybridNode& b) {
        ++work_.transform_updates;
        return NodeTest::posed(pose_, b);
    }

    bool may_overlap(const HybridNode& a, const PosedNode& b) {
        ++work_.volume_tests;
        return NodeTest::may_overlap(a, b, work_);
    }

    bool test_triangles(const HybridNode& a, const HybridNode& b) {
        for (std::uint32_t j = b.first; j < b.first + b.count; ++j) {
            const std::uint32_t tb = b_.tree.order[j];
            const auto& v = b_.mesh.triangles[tb];
            const auto vertex = [&](std::uint32_t k) { return b_vertex_in_a(X_a_b_, b_.mesh.positions[k]); };
            const Triangle moved{vertex(v[0]), vertex(v[1]), vertex(v[2])};
            for (std::uint32_t i = a.first; i < a.first + a.count; ++i) {
                const std::uint32_t ta = a_.tree.order[i];
                ++work_.primitive_tests;
                if (overlap(vertices(a_.mesh, ta), moved) && !visit_(TrianglePair{ta, tb})) {
                    return false;
                }
            }
        }
        return true;
    }

    const HybridMesh& a_;
    const HybridMesh& b_;
    const Pose& X_a_b_;
    NodePose pose_;
    Visit visit_;
    HybridContactStatistics& work_;
};

/// Replaces `out` by all overlapping pairs.
template <typename NodeTest>
void all_contacts_by(const HybridMesh& a, const HybridMesh& b, const Pose& X_a_b,
                     std::vector<TrianglePair>& out, HybridContactStatistics& work) {
    out.clear();
    const auto add = [&out](const TrianglePair& pair) {
        out.push_back(pair);
        return true;
    };
    PairTraversal<NodeTest, decltype(add)>(a, b, X_a_b, add, work).run();
}

/// The pair that all_contacts_by() finds first.
template <typename NodeTest>
std::optional<TrianglePair> first_contact_by(const HybridMesh& a, const HybridMesh& b, const Pose& X_a_b,
                                             HybridContactStatistics& work) {
    std::optional<TrianglePair> first;
    const auto stop_at = [&first](const TrianglePair& pair) {
        first = pair;
        return false;
    };
    PairTraversal<NodeTest, decltype(stop_at)>(a, b, X_a_b, stop_at, work).run();
    return first;
}

/// The paper's: outer spheres, each inner sphere against the other's box, box against box.
struct HybridNodeTest {
    /// Sets only what the test needs.
    static PosedNode posed(const NodePose& pose, const HybridNode& node) {
        PosedNode posed;
        pose.set_outer(node, posed);
        pose.set_box(node, posed);
        return posed;
    }

    /// Counts what it tests, and what separated the nodes.
    static bool may_overlap(const HybridNode& a, const PosedNode& b, HybridContactStatistics& work) {
        if (separates_outer(a, b, work)) {
            return false;
        }
        ++work.box_tests;
        const BoxOffset offset = offset_between(a.inner, b.inner);
        if (apart(a.inner, offset.in_a, b.inner.radius) || apart(b.inner, offset.in_b, a.inner.radius)) {
            ++work.inner;
            return false;
        }
        const bool separate = apart(a.inner, b.inner, offset);
        work.box += separate ? 1U : 0U;
        return !separate;
    }
};

}  // namespace campuswalk::collision

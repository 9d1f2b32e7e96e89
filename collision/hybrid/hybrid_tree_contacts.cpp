#include "collision/hybrid/hybrid_tree_contacts.h"

#include <Eigen/Geometry>

#include "collision/geometry/triangle_overlap.h"
#include "collision/hybrid/volume_overlap.h"

namespace campuswalk::collision {

namespace {

/// The volumes of a node of b, in a's frame.
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

    /// Sets only what the test needs.
    template <NodeTest kTest>
    PosedNode pose(const HybridNode& node) const {
        PosedNode posed;
        if constexpr (kTest != NodeTest::box) {
            posed.outer = {X_ * node.outer.center, (1.0 + stretch_) * node.outer.radius};
        }
        if constexpr (kTest != NodeTest::sphere) {
            posed.inner.center = X_ * node.inner.center;
            posed.inner.radius = (1.0 + stretch_) * node.inner.radius;
        }
        if constexpr (kTest == NodeTest::hybrid || kTest == NodeTest::box) {
            posed.inner.axes = rotation_ * node.inner.axes;
            posed.inner.half_extents = node.inner.half_extents.array() + stretch_ * node.inner.radius;
        }
        return posed;
    }

private:
    const Pose& X_;
    Mat3 rotation_;
    double stretch_ = 0.0;
};

/// Traverses two trees at once, the larger of two nodes first as RAPID does, and calls `visit` for each
/// overlapping pair, which returns whether to go on.
///
/// Recursive, with stack frames of half a kilobyte, as many as both trees are deep together: some dozens, and
/// some hundreds in the worst trees that kMinSideDivisor allows.
template <NodeTest kTest, typename Visit>
class Traversal {
public:
    Traversal(const HybridMesh& a, const HybridMesh& b, const Pose& X_a_b, Visit visit,
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
        return pose_.template pose<kTest>(b);
    }

    bool may_overlap(const HybridNode& a, const PosedNode& b) {
        ++work_.volume_tests;
        if constexpr (kTest != NodeTest::box) {
            ++work_.sphere_tests;
            if (apart(a.outer, b.outer)) {
                ++work_.outer;
                return false;
            }
        }
        if constexpr (kTest != NodeTest::sphere) {
            ++work_.box_tests;
        }
        if constexpr (kTest == NodeTest::mixed) {
            const Vec3 offset = a.inner.axes.transpose() * (b.inner.center - a.inner.center);
            if (apart(a.inner, offset, b.inner.radius)) {
                ++work_.inner;
                return false;
            }
        }
        if constexpr (kTest == NodeTest::hybrid || kTest == NodeTest::box) {
            const BoxOffset offset = offset_between(a.inner, b.inner);
            if (kTest == NodeTest::hybrid && (apart(a.inner, offset.in_a, b.inner.radius) ||
                                              apart(b.inner, offset.in_b, a.inner.radius))) {
                ++work_.inner;
                return false;
            }
            if (apart(a.inner, b.inner, offset)) {
                ++work_.box;
                return false;
            }
        }
        return true;
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

template <typename Visit>
void traverse(const HybridMesh& a, const HybridMesh& b, const Pose& X_a_b, NodeTest test, Visit visit,
              HybridContactStatistics& work) {
    switch (test) {
        case NodeTest::hybrid:
            return Traversal<NodeTest::hybrid, Visit>(a, b, X_a_b, visit, work).run();
        case NodeTest::box:
            return Traversal<NodeTest::box, Visit>(a, b, X_a_b, visit, work).run();
        case NodeTest::sphere:
            return Traversal<NodeTest::sphere, Visit>(a, b, X_a_b, visit, work).run();
        case NodeTest::mixed:
            return Traversal<NodeTest::mixed, Visit>(a, b, X_a_b, visit, work).run();
    }
}

}  // namespace

void all_contacts(const HybridMesh& a, const HybridMesh& b, const Pose& X_a_b, NodeTest test,
                  std::vector<TrianglePair>& out, HybridContactStatistics& work) {
    out.clear();
    const auto add = [&out](const TrianglePair& pair) {
        out.push_back(pair);
        return true;
    };
    traverse(a, b, X_a_b, test, add, work);
}

std::optional<TrianglePair> first_contact(const HybridMesh& a, const HybridMesh& b, const Pose& X_a_b,
                                          NodeTest test, HybridContactStatistics& work) {
    std::optional<TrianglePair> first;
    const auto stop_at = [&first](const TrianglePair& pair) {
        first = pair;
        return false;
    };
    traverse(a, b, X_a_b, test, stop_at, work);
    return first;
}

}  // namespace campuswalk::collision

#include "collision/hybrid/hybrid_tree_contacts.h"

#include <Eigen/Geometry>

#include "collision/geometry/triangle_overlap.h"
#include "collision/hybrid/volume_overlap.h"

namespace campuswalk::collision {

namespace {

/// The volumes of a node of b in a's frame.
struct PosedNode {
    BoundingSphere outer;
    OrientedBox inner;
};

/// Brings nodes of b into a's frame.
///
/// The answer is about the corners R x + t (b_vertex_in_a), whatever R is, and no R in floating point is
/// quite a rotation. So a node's centres go through R and t and its axes through a rotation near R, and its
/// sizes grow by what R moves points off that rotation.
///
/// What rounding does here, volume_overlap.h's kOutward covers too: the corners' and centres' is some u times
/// R x and t, and t, however large, is no longer than R x and a's coordinates together where the two meet.
class NodePose {
public:
    explicit NodePose(const Pose& X_a_b)
        : X_(X_a_b),
          turn_(Eigen::Quaterniond(X_a_b.rotation).normalized().toRotationMatrix()),
          stretch_((X_a_b.rotation - turn_).norm()) {}

    /// What the test doesn't look at is left as it is.
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
            posed.inner.axes = turn_ * node.inner.axes;
            posed.inner.half_extents = node.inner.half_extents.array() + stretch_ * node.inner.radius;
        }
        return posed;
    }

private:
    const Pose& X_;
    Mat3 turn_;
    double stretch_ = 0.0;
};

/// Descends two trees at once, the larger of two nodes first as RAPID does, and hands each overlapping pair
/// to `found`, which says whether to go on.
///
/// The stack is the machine's: frames of half a kilobyte, as many as both trees are deep. That is some
/// dozens, and some hundreds in the worst trees that kLeastPart allows.
template <NodeTest kTest, typename Found>
class Search {
public:
    Search(const HybridMesh& a, const HybridMesh& b, const Pose& X_a_b, Found found,
           HybridContactStatistics& work)
        : a_(a), b_(b), X_a_b_(X_a_b), pose_(X_a_b), found_(found), work_(work) {}

    void run() {
        if (a_.tree.nodes.empty() || b_.tree.nodes.empty()) {
            return;
        }
        const HybridNode& a = a_.tree.nodes[0];
        const HybridNode& b = b_.tree.nodes[0];
        const PosedNode posed = pose(b);
        if (may_meet(a, posed)) {
            descend(a, b, posed);
        }
    }

private:
    /// False once `found` has asked to stop.
    bool descend(const HybridNode& a, const HybridNode& b, const PosedNode& posed) {
        if (a.is_leaf() && b.is_leaf()) {
            return test_triangles(a, b);
        }
        if (b.is_leaf() || (!a.is_leaf() && a.inner.radius >= b.inner.radius)) {
            for (std::uint32_t i = 0; i < 2; ++i) {
                const HybridNode& child = a_.tree.nodes[a.first + i];
                if (may_meet(child, posed) && !descend(child, b, posed)) {
                    return false;
                }
            }
            return true;
        }
        for (std::uint32_t i = 0; i < 2; ++i) {
            const HybridNode& child = b_.tree.nodes[b.first + i];
            const PosedNode posed_child = pose(child);
            if (may_meet(a, posed_child) && !descend(a, child, posed_child)) {
                return false;
            }
        }
        return true;
    }

    PosedNode pose(const HybridNode& b) {
        ++work_.transform_updates;
        return pose_.template pose<kTest>(b);
    }

    bool may_meet(const HybridNode& a, const PosedNode& b) {
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
                if (overlap(vertices(a_.mesh, ta), moved) && !found_(TrianglePair{ta, tb})) {
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
    Found found_;
    HybridContactStatistics& work_;
};

template <typename Found>
void search(const HybridMesh& a, const HybridMesh& b, const Pose& X_a_b, NodeTest test, Found found,
            HybridContactStatistics& work) {
    switch (test) {
        case NodeTest::hybrid:
            return Search<NodeTest::hybrid, Found>(a, b, X_a_b, found, work).run();
        case NodeTest::box:
            return Search<NodeTest::box, Found>(a, b, X_a_b, found, work).run();
        case NodeTest::sphere:
            return Search<NodeTest::sphere, Found>(a, b, X_a_b, found, work).run();
        case NodeTest::mixed:
            return Search<NodeTest::mixed, Found>(a, b, X_a_b, found, work).run();
    }
}

}  // namespace

void all_contacts(const HybridMesh& a, const HybridMesh& b, const Pose& X_a_b, NodeTest test,
                  std::vector<TrianglePair>& out, HybridContactStatistics& work) {
    out.clear();
    const auto keep = [&out](const TrianglePair& pair) {
        out.push_back(pair);
        return true;
    };
    search(a, b, X_a_b, test, keep, work);
}

std::optional<TrianglePair> first_contact(const HybridMesh& a, const HybridMesh& b, const Pose& X_a_b,
                                          NodeTest test, HybridContactStatistics& work) {
    std::optional<TrianglePair> first;
    const auto keep = [&first](const TrianglePair& pair) {
        first = pair;
        return false;
    };
    search(a, b, X_a_b, test, keep, work);
    return first;
}

}  // namespace campuswalk::collision

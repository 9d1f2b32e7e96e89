#pragma once

#include "collision/hybrid/pair_traversal.h"

namespace campuswalk::tools::bench {

// Node tests that the paper's is compared with; the rest of the query is the same. With each, the overlapping
// pairs are the same set.

/// Only the boxes: RAPID's design.
struct BoxNodeTest {
    static collision::PosedNode posed(const collision::NodePose& pose, const collision::HybridNode& node) {
        collision::PosedNode posed;
        pose.set_box(node, posed);
        return posed;
    }
    static bool may_overlap(const collision::HybridNode& a, const collision::PosedNode& b,
                            collision::HybridContactStatistics& work) {
        ++work.box_tests;
        const bool separate = apart(a.inner, b.inner, offset_between(a.inner, b.inner));
        work.box += separate ? 1U : 0U;
        return !separate;
    }
};

/// Only the outer spheres.
struct SphereNodeTest {
    static collision::PosedNode posed(const collision::NodePose& pose, const collision::HybridNode& node) {
        collision::PosedNode posed;
        pose.set_outer(node, posed);
        return posed;
    }
    static bool may_overlap(const collision::HybridNode& a, const collision::PosedNode& b,
                            collision::HybridContactStatistics& work) {
        return !separates_outer(a, b, work);
    }
};

/// The other reading of the paper's text: outer spheres, then a's box against b's inner sphere.
struct MixedNodeTest {
    static collision::PosedNode posed(const collision::NodePose& pose, const collision::HybridNode& node) {
        collision::PosedNode posed;
        pose.set_outer(node, posed);
        pose.set_inner_sphere(node, posed);
        return posed;
    }
    static bool may_overlap(const collision::HybridNode& a, const collision::PosedNode& b,
                            collision::HybridContactStatistics& work) {
        if (separates_outer(a, b, work)) {
            return false;
        }
        ++work.box_tests;
        const collision::Vec3 offset = a.inner.axes.transpose() * (b.inner.center - a.inner.center);
        const bool separate = apart(a.inner, offset, b.inner.radius);
        work.inner += separate ? 1U : 0U;
        return !separate;
    }
};

}  // namespace campuswalk::tools::bench

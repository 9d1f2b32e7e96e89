#include "collision/bvh8/kernels/bvh8_rays.h"

// Compiled once for each instruction set: see bvh8_contacts.cpp.
#define HWY_IS_DEBUG_BUILD 0
#ifdef __x86_64__
#define HWY_BASELINE_TARGETS HWY_SSE4
#else
#define HWY_COMPILE_ONLY_STATIC
#endif
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collision/bvh8/kernels/bvh8_rays.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "collision/bvh8/kernels/prefetch.h"
#include "collision/bvh8/kernels/ray_leaf_inl.h"
#include "collision/bvh8/kernels/ray_node_inl.h"

HWY_BEFORE_NAMESPACE();
namespace campuswalk::collision {
namespace HWY_NAMESPACE {

/// A node or a leaf that is still to be visited, as one number: ordered by where the ray may enter it, then
/// by its index.
class StackEntry {
public:
    /// Uninitialized, so that a ray doesn't set all 512 first.
    StackEntry() {}
    HWY_INLINE StackEntry(float entry, std::uint32_t index, bool leaf)
        : key_(static_cast<std::uint64_t>(std::bit_cast<std::uint32_t>(entry)) << 32 | index << 1 |
               (leaf ? 1U : 0U)) {}

    float entry() const { return std::bit_cast<float>(static_cast<std::uint32_t>(key_ >> 32)); }
    bool is_leaf() const { return (key_ & 1U) != 0; }
    std::uint32_t index() const { return static_cast<std::uint32_t>(key_) >> 1; }
    bool before(const StackEntry& o) const { return key_ < o.key_; }

private:
    std::uint64_t key_;  ///< a float's bits are ordered like it where it isn't negative
};

/// Nodes and leaves that are still to be visited; of one node's children, the nearest on top.
class RayStack {
public:
    /// Pushes a child of the node whose children start at `first`.
    HWY_INLINE void push(const StackEntry& part, std::size_t first) {
        std::size_t at = depth_++;
        for (; at > first && entries_[at - 1].before(part); --at) {
            entries_[at] = entries_[at - 1];
        }
        entries_[at] = part;
    }
    std::size_t depth() const { return depth_; }
    StackEntry pop() { return entries_[--depth_]; }

private:
    std::array<StackEntry, 512> entries_;  ///< enough: see tree_traversal.h
    std::size_t depth_ = 0;
};

/// The traversal of a tree by a ray.
class RayTraversal {
public:
    RayTraversal(const TriangleMesh& mesh, const Bvh8& tree, const Ray& ray, const RayVisitor& visit,
                 QueryStatistics& work)
        : mesh_(mesh),
          tree_(tree),
          visit_(visit),
          work_(work),
          ray_(ray),
          shear_(ray),
          reach_(ray_.reach(limit_)) {}

    HWY_INLINE void run() {
        StackEntry next(0.0F, 0, false);
        for (;;) {
            if (next.is_leaf()) {
                open_leaf(tree_.leaves[next.index()]);
            } else if (open_node(tree_.nodes[next.index()], next)) {
                continue;
            }
            do {
                if (stack_.depth() == 0) {
                    return;
                }
                next = stack_.pop();
            } while (next.entry() > reach_);
        }
    }

private:
    /// Returns the nearest child on the ray, if there is one, and pushes the others. Most nodes have only
    /// one.
    HWY_INLINE bool open_node(const Bvh8Node& node, StackEntry& nearest) {
        work_.box_tests += node.count;
        HWY_ALIGN float entry[kBvh8Children];
        std::uint32_t on_ray = children_on_ray(ray_, node, reach_, entry);
        if (on_ray == 0) {
            return false;
        }
        const auto child = [&](std::uint32_t bits) {
            const auto i = static_cast<std::size_t>(std::countr_zero(bits));
            return StackEntry(entry[i], node.child[i], (node.leaves >> i & 1) != 0);
        };
        nearest = child(on_ray);
        const std::size_t first = stack_.depth();
        while ((on_ray &= on_ray - 1) != 0) {
            StackEntry other = child(on_ray);
            if (other.before(nearest)) {
                std::swap(other, nearest);
            }
            prefetch_part(other);
            stack_.push(other, first);
        }
        return true;
    }

    HWY_INLINE void open_leaf(const Bvh8Leaf& leaf) {
        for (std::uint32_t candidates = shear_.triangles_on_ray(leaf); candidates != 0;
             candidates &= candidates - 1) {
            const auto slot = static_cast<std::size_t>(std::countr_zero(candidates));
            ++work_.primitive_tests;
            limit_ = visit_(leaf.triangle[slot], vertices(mesh_, leaf, slot), limit_);
            reach_ = ray_.reach(limit_);
        }
    }

    /// In a large mesh, half of a ray's time is waiting for memory: prefetches what is on the stack.
    HWY_INLINE void prefetch_part(const StackEntry& part) const {
        constexpr std::size_t kReadFirst = 256;  // a node without its axes, or a leaf's vertices
        if (part.is_leaf()) {
            prefetch(tree_.leaves[part.index()], kReadFirst);
        } else {
            prefetch(tree_.nodes[part.index()], kReadFirst);
        }
    }

    const TriangleMesh& mesh_;
    const Bvh8& tree_;
    const RayVisitor& visit_;
    QueryStatistics& work_;
    PreparedRay ray_;
    Shear shear_;
    double limit_ = 1.0;
    float reach_;
    RayStack stack_;
};

void trace(const TriangleMesh& mesh, const Bvh8& tree, const Ray& ray, const RayVisitor& visit,
           QueryStatistics& work) {
    RayTraversal(mesh, tree, ray, visit, work).run();
}

}  // namespace HWY_NAMESPACE
}  // namespace campuswalk::collision
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace campuswalk::collision {

bool fits_bvh8_rays(const Ray& ray) {
    constexpr double kFarthest = 0x1p60;
    return ray.from != ray.to &&
           std::max(ray.from.cwiseAbs().maxCoeff(), ray.to.cwiseAbs().maxCoeff()) < kFarthest;
}

void trace_bvh8_ray(const TriangleMesh& mesh, const Bvh8& tree, const Ray& ray, SimdTarget simd_target,
                    const RayVisitor& visit, QueryStatistics& work) {
    switch (simd_target) {
#ifdef __aarch64__
        case SimdTarget::neon:
            return N_NEON::trace(mesh, tree, ray, visit, work);
#else
        case SimdTarget::sse42:
            return N_SSE4::trace(mesh, tree, ray, visit, work);
        case SimdTarget::avx2:
            return N_AVX2::trace(mesh, tree, ray, visit, work);
        case SimdTarget::avx512:
            return N_AVX3::trace(mesh, tree, ray, visit, work);
#endif
    }
}

}  // namespace campuswalk::collision
#endif

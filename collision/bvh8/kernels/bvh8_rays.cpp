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

/// A node or a leaf that is still to be looked at, as one number: first by where the ray may enter it, then
/// by which it is.
class Waiting {
public:
    /// Without initialiser: each ray would set all that could wait.
    Waiting() {}
    HWY_INLINE Waiting(float entry, std::uint32_t index, bool leaf)
        : key_(static_cast<std::uint64_t>(std::bit_cast<std::uint32_t>(entry)) << 32 | index << 1 |
               (leaf ? 1U : 0U)) {}

    float entry() const { return std::bit_cast<float>(static_cast<std::uint32_t>(key_ >> 32)); }
    bool is_leaf() const { return (key_ & 1U) != 0; }
    std::uint32_t index() const { return static_cast<std::uint32_t>(key_) >> 1; }
    bool before(const Waiting& o) const { return key_ < o.key_; }

private:
    std::uint64_t key_;  ///< an entry's bits are ordered as it is, for it is no less than 0
};

/// What waits, of one node's children the nearest last.
class TraversalStack {
public:
    /// Adds one of those that have been added from `first` on.
    HWY_INLINE void add(const Waiting& part, std::size_t first) {
        std::size_t at = depth_++;
        for (; at > first && waiting_[at - 1].before(part); --at) {
            waiting_[at] = waiting_[at - 1];
        }
        waiting_[at] = part;
    }
    std::size_t depth() const { return depth_; }
    Waiting take() { return waiting_[--depth_]; }

private:
    std::array<Waiting, 512> waiting_;  ///< enough: see tree_traversal.h
    std::size_t depth_ = 0;
};

/// A ray on its way down.
class Descent {
public:
    Descent(const TriangleMesh& mesh, const Bvh8& tree, const Ray& ray, const RayVisitor& meet,
            QueryStatistics& work)
        : mesh_(mesh),
          tree_(tree),
          meet_(meet),
          work_(work),
          course_(ray),
          shear_(ray),
          reach_(course_.reach(limit_)) {}

    HWY_INLINE void run() {
        Waiting next(0.0F, 0, false);
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
                next = stack_.take();
            } while (next.entry() > reach_);
        }
    }

private:
    /// Puts off what the ray meets but for the nearest, if there is one. Most nodes have no more.
    HWY_INLINE bool open_node(const Bvh8Node& node, Waiting& nearest) {
        work_.box_tests += node.count;
        HWY_ALIGN float entry[kBvh8Children];
        std::uint32_t met = children_on_ray(course_, node, reach_, entry);
        if (met == 0) {
            return false;
        }
        const auto child = [&](std::uint32_t bits) {
            const auto i = static_cast<std::size_t>(std::countr_zero(bits));
            return Waiting(entry[i], node.child[i], (node.leaves >> i & 1) != 0);
        };
        nearest = child(met);
        const std::size_t first = stack_.depth();
        while ((met &= met - 1) != 0) {
            Waiting other = child(met);
            if (other.before(nearest)) {
                std::swap(other, nearest);
            }
            fetch(other);
            stack_.add(other, first);
        }
        return true;
    }

    HWY_INLINE void open_leaf(const Bvh8Leaf& leaf) {
        for (std::uint32_t seen = shear_.triangles_seen(leaf); seen != 0; seen &= seen - 1) {
            const auto slot = static_cast<std::size_t>(std::countr_zero(seen));
            ++work_.primitive_tests;
            limit_ = meet_(leaf.triangle[slot], vertices(mesh_, leaf, slot), limit_);
            reach_ = course_.reach(limit_);
        }
    }

    /// Half of the time of a ray in a large mesh is waiting for memory: what waits is fetched meanwhile.
    HWY_INLINE void fetch(const Waiting& part) const {
        constexpr std::size_t kReadFirst = 256;  // of a node all but a turned frame, of a leaf its corners
        if (part.is_leaf()) {
            prefetch(tree_.leaves[part.index()], kReadFirst);
        } else {
            prefetch(tree_.nodes[part.index()], kReadFirst);
        }
    }

    const TriangleMesh& mesh_;
    const Bvh8& tree_;
    const RayVisitor& meet_;
    QueryStatistics& work_;
    Course course_;
    Shear shear_;
    double limit_ = 1.0;
    float reach_;
    TraversalStack stack_;
};

void follow(const TriangleMesh& mesh, const Bvh8& tree, const Ray& ray, const RayVisitor& meet,
            QueryStatistics& work) {
    Descent(mesh, tree, ray, meet, work).run();
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
                    const RayVisitor& meet, QueryStatistics& work) {
    switch (simd_target) {
#ifdef __aarch64__
        case SimdTarget::neon:
            return N_NEON::follow(mesh, tree, ray, meet, work);
#else
        case SimdTarget::sse42:
            return N_SSE4::follow(mesh, tree, ray, meet, work);
        case SimdTarget::avx2:
            return N_AVX2::follow(mesh, tree, ray, meet, work);
        case SimdTarget::avx512:
            return N_AVX3::follow(mesh, tree, ray, meet, work);
#endif
    }
}

}  // namespace campuswalk::collision
#endif

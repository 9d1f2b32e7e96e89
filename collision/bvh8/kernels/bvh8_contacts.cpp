#include "collision/bvh8/kernels/bvh8_contacts.h"

#include <bit>

// Highway compiles this file once for each instruction set. We choose which to run, so that Highway's library
// needn't be linked. Its assertions are off even in debug builds: they would need that library.
#define HWY_IS_DEBUG_BUILD 0
#ifdef __x86_64__
#define HWY_BASELINE_TARGETS HWY_SSE4
#else
#define HWY_COMPILE_ONLY_STATIC
#endif
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collision/bvh8/kernels/bvh8_contacts.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "collision/bvh8/kernels/leaf_pair_inl.h"
#include "collision/bvh8/kernels/node_pair_inl.h"
#include "collision/bvh8/kernels/prefetch.h"
#include "collision/bvh8/kernels/relative_pose_inl.h"

HWY_BEFORE_NAMESPACE();
namespace campuswalk::collision {
namespace HWY_NAMESPACE {

/// Two nodes with children that are still to be tested against each other. A leaf isn't a node: it is
/// represented by its parent, with that leaf as the only child left.
struct NodePair {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    std::uint32_t rows = 0;     ///< one bit per child of a
    std::uint32_t columns = 0;  ///< and of b
};

HWY_INLINE std::uint32_t all_children(const Bvh8Node& node) {
    return (1U << node.count) - 1U;
}

/// Bits 8 i to 8 i + 7 for each bit i.
HWY_INLINE std::uint64_t whole_rows(std::uint64_t bits) {
    const std::uint64_t spread = (bits * 0x0101010101010101ULL) & 0x8040201008040201ULL;
    // A byte with any bit set becomes 0xFF.
    const std::uint64_t ones = (((spread & 0x7F7F7F7F7F7F7F7FULL) + 0x7F7F7F7F7F7F7F7FULL) | spread) >> 7;
    return (ones & 0x0101010101010101ULL) * 0xFF;
}

/// The traversal of two trees, from pairs of nodes to pairs of leaves.
class PairTraversal {
public:
    PairTraversal(const Bvh8Pair& pair, std::vector<TrianglePair>& out, QueryStatistics& work)
        : a_(pair.a), b_(pair.b), pose_(pair), leaf_pairs_(pair, pose_, out, work), work_(work) {
        // For trees that don't fit the caches of a core, the next nodes and leaves are prefetched.
        constexpr std::size_t kNodesInCache = 2048;
        prefetches_ = a_.nodes.size() + b_.nodes.size() > kNodesInCache;
    }

    static NodePair roots(const Bvh8Pair& pair) {
        return {0, 0, all_children(pair.a.nodes[0]), all_children(pair.b.nodes[0])};
    }

    /// The overlapping children: bit 8 i + j for child i of a and child j of b.
    template <class Output>
    HWY_INLINE std::uint64_t overlapping(const NodePair& item, Output& output) {
        ++work_.transform_updates;
        work_.box_tests += static_cast<std::uint64_t>(std::popcount(item.rows) * std::popcount(item.columns));
        return overlapping_children(pose_, a_.nodes[item.a], b_.nodes[item.b], item.rows, item.columns,
                                    output);
    }

    /// Those pairs of children of which both are leaves.
    std::uint64_t leaves(const NodePair& item) const {
        return whole_rows(a_.nodes[item.a].leaves) & (0x0101010101010101ULL * b_.nodes[item.b].leaves);
    }

    HWY_INLINE void find(const NodePair& item, std::size_t bit) {
        leaf_pairs_.find(leaf_a(item, bit), leaf_b(item, bit));
    }

    HWY_INLINE void prefetch_leaves(const NodePair& item, std::size_t bit) const {
        if (prefetches_) {
            prefetch(leaf_a(item, bit));
            prefetch(leaf_b(item, bit));
        }
    }

    HWY_INLINE NodePair child_pair(const NodePair& item, std::size_t bit) const {
        const std::size_t i = bit / 8;
        const std::size_t j = bit % 8;
        const Bvh8Node& a = a_.nodes[item.a];
        const Bvh8Node& b = b_.nodes[item.b];
        NodePair next{item.a, item.b, 1U << i, 1U << j};
        if ((a.leaves >> i & 1) == 0) {
            next.a = a.child[i];
            next.rows = all_children(a_.nodes[next.a]);
        }
        if ((b.leaves >> j & 1) == 0) {
            next.b = b.child[j];
            next.columns = all_children(b_.nodes[next.b]);
        }
        if (prefetches_) {
            prefetch(a_.nodes[next.a]);
            prefetch(b_.nodes[next.b]);
        }
        return next;
    }

private:
    const Bvh8Leaf& leaf_a(const NodePair& item, std::size_t bit) const {
        return a_.leaves[a_.nodes[item.a].child[bit / 8]];
    }
    const Bvh8Leaf& leaf_b(const NodePair& item, std::size_t bit) const {
        return b_.leaves[b_.nodes[item.b].child[bit % 8]];
    }

    const Bvh8& a_;
    const Bvh8& b_;
    RelativePose pose_;
    LeafPairs leaf_pairs_;
    QueryStatistics& work_;
    bool prefetches_ = false;
};

std::size_t lowest_bit(std::uint64_t bits) {
    return static_cast<std::size_t>(std::countr_zero(bits));
}

void find_all(PairTraversal& traversal, const NodePair& roots) {
    thread_local std::vector<NodePair> stack;
    stack.assign(1, roots);
    ChildOverlaps overlaps;
    while (!stack.empty()) {
        const NodePair item = stack.back();
        stack.pop_back();
        const std::uint64_t overlapping = traversal.overlapping(item, overlaps);
        const std::uint64_t leaves = traversal.leaves(item);
        for (std::uint64_t m = overlapping & leaves; m != 0; m &= m - 1) {
            if (const std::uint64_t rest = m & (m - 1); rest != 0) {
                traversal.prefetch_leaves(item, lowest_bit(rest));
            }
            traversal.find(item, lowest_bit(m));
        }
        for (std::uint64_t m = overlapping & ~leaves; m != 0; m &= m - 1) {
            stack.push_back(traversal.child_pair(item, lowest_bit(m)));
        }
    }
}

std::size_t deepest(const OverlapDepths& depths, std::uint64_t pairs) {
    std::size_t best = lowest_bit(pairs);
    for (std::uint64_t m = pairs & (pairs - 1); m != 0; m &= m - 1) {
        best = depths.of_pair(lowest_bit(m)) > depths.of_pair(best) ? lowest_bit(m) : best;
    }
    return best;
}

/// Deepest first: boxes with deep overlaps are likely to have intersecting triangles. Visits less than half
/// as many pairs of nodes as in the order of children.
void find_first(PairTraversal& traversal, const NodePair& item, std::vector<TrianglePair>& out) {
    OverlapDepths depths;
    const std::uint64_t overlapping = traversal.overlapping(item, depths);
    const std::uint64_t leaves = traversal.leaves(item);
    for (std::uint64_t left = overlapping; left != 0 && out.empty();) {
        const std::size_t next = deepest(depths, left);
        left &= ~(1ULL << next);
        if ((leaves >> next & 1) != 0) {
            traversal.find(item, next);
        } else {
            find_first(traversal, traversal.child_pair(item, next), out);
        }
    }
}

void search(const Bvh8Pair& pair, SearchMode mode, std::vector<TrianglePair>& out, QueryStatistics& work) {
    PairTraversal traversal(pair, out, work);
    if (mode == SearchMode::all) {
        find_all(traversal, PairTraversal::roots(pair));
    } else {
        find_first(traversal, PairTraversal::roots(pair), out);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace campuswalk::collision
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace campuswalk::collision {

void find_bvh8_contacts(const Bvh8Pair& pair, SearchMode mode, SimdTarget simd_target,
                        std::vector<TrianglePair>& out, QueryStatistics& work) {
    switch (simd_target) {
#ifdef __aarch64__
        case SimdTarget::neon:
            return N_NEON::search(pair, mode, out, work);
#else
        case SimdTarget::sse42:
            return N_SSE4::search(pair, mode, out, work);
        case SimdTarget::avx2:
            return N_AVX2::search(pair, mode, out, work);
        case SimdTarget::avx512:
            return N_AVX3::search(pair, mode, out, work);
#endif
    }
}

}  // namespace campuswalk::collision
#endif

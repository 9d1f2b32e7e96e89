#include "collision/bvh8/kernels/bvh8_contacts.h"

#include <bit>

// Highway compiles this file once for each instruction set; which to run is ours to say, so nothing of its
// library is linked. Its own assertions are off even in debug builds: they'd need that library.
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

/// Two nodes of which some children are still to be held against each other. A leaf has no node of its own:
/// it waits as the one child of its node that is left.
struct NodePair {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    std::uint32_t rows = 0;     ///< bits of a's children
    std::uint32_t columns = 0;  ///< bits of b's
};

HWY_INLINE std::uint32_t all_children(const Bvh8Node& node) {
    return (1U << node.count) - 1U;
}

/// Bits 8 i to 8 i + 7 for each bit i.
HWY_INLINE std::uint64_t whole_rows(std::uint64_t bits) {
    const std::uint64_t spread = (bits * 0x0101010101010101ULL) & 0x8040201008040201ULL;
    // a byte that has a bit becomes 0xFF
    const std::uint64_t ones = (((spread & 0x7F7F7F7F7F7F7F7FULL) + 0x7F7F7F7F7F7F7F7FULL) | spread) >> 7;
    return (ones & 0x0101010101010101ULL) * 0xFF;
}

/// A way down two trees, from pairs of nodes to pairs of leaves.
class Descent {
public:
    Descent(const Bvh8Pair& pair, std::vector<TrianglePair>& out, QueryStatistics& work)
        : a_(pair.a), b_(pair.b), pose_(pair), leaf_pairs_(pair, pose_, out, work), work_(work) {
        // Of trees that the caches next to a core can't hold, what comes next is fetched ahead.
        constexpr std::size_t kNodesInCache = 2048;
        far_ = a_.nodes.size() + b_.nodes.size() > kNodesInCache;
    }

    static NodePair roots(const Bvh8Pair& pair) {
        return {0, 0, all_children(pair.a.nodes[0]), all_children(pair.b.nodes[0])};
    }

    /// Bit 8 i + j: child i of a and child j of b.
    template <class Asked>
    HWY_INLINE std::uint64_t children(const NodePair& item, Asked& asked) {
        ++work_.transform_updates;
        work_.box_tests += static_cast<std::uint64_t>(std::popcount(item.rows) * std::popcount(item.columns));
        return overlapping_children(pose_, a_.nodes[item.a], b_.nodes[item.b], item.rows, item.columns,
                                    asked);
    }

    /// Those of them that are leaves both.
    std::uint64_t leaves(const NodePair& item) const {
        return whole_rows(a_.nodes[item.a].leaves) & (0x0101010101010101ULL * b_.nodes[item.b].leaves);
    }

    HWY_INLINE void find(const NodePair& item, std::size_t bit) {
        leaf_pairs_.find(leaf_a(item, bit), leaf_b(item, bit));
    }

    HWY_INLINE void fetch(const NodePair& item, std::size_t bit) const {
        if (far_) {
            prefetch(leaf_a(item, bit));
            prefetch(leaf_b(item, bit));
        }
    }

    HWY_INLINE NodePair below(const NodePair& item, std::size_t bit) const {
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
        if (far_) {
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
    bool far_ = false;
};

std::size_t first_place(std::uint64_t bits) {
    return static_cast<std::size_t>(std::countr_zero(bits));
}

void find_all(Descent& descent, const NodePair& roots) {
    thread_local std::vector<NodePair> stack;
    stack.assign(1, roots);
    ChildOverlaps asked;
    while (!stack.empty()) {
        const NodePair item = stack.back();
        stack.pop_back();
        const std::uint64_t met = descent.children(item, asked);
        const std::uint64_t leaves = descent.leaves(item);
        for (std::uint64_t m = met & leaves; m != 0; m &= m - 1) {
            if (const std::uint64_t rest = m & (m - 1); rest != 0) {
                descent.fetch(item, first_place(rest));
            }
            descent.find(item, first_place(m));
        }
        for (std::uint64_t m = met & ~leaves; m != 0; m &= m - 1) {
            stack.push_back(descent.below(item, first_place(m)));
        }
    }
}

std::size_t deepest(const OverlapDepths& depths, std::uint64_t pairs) {
    std::size_t best = first_place(pairs);
    for (std::uint64_t m = pairs & (pairs - 1); m != 0; m &= m - 1) {
        best = depths.of_pair(first_place(m)) > depths.of_pair(best) ? first_place(m) : best;
    }
    return best;
}

/// Deep first: boxes that reach far into each other are likely to have triangles that cross. Less than half
/// of the pairs of nodes are visited that there would be in the order of children.
void find_first(Descent& descent, const NodePair& item, std::vector<TrianglePair>& out) {
    OverlapDepths depths;
    const std::uint64_t met = descent.children(item, depths);
    const std::uint64_t leaves = descent.leaves(item);
    for (std::uint64_t left = met; left != 0 && out.empty();) {
        const std::size_t next = deepest(depths, left);
        left &= ~(1ULL << next);
        if ((leaves >> next & 1) != 0) {
            descent.find(item, next);
        } else {
            find_first(descent, descent.below(item, next), out);
        }
    }
}

void search(const Bvh8Pair& pair, SearchMode wanted, std::vector<TrianglePair>& out, QueryStatistics& work) {
    Descent descent(pair, out, work);
    if (wanted == SearchMode::all) {
        find_all(descent, Descent::roots(pair));
    } else {
        find_first(descent, Descent::roots(pair), out);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace campuswalk::collision
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace campuswalk::collision {

void find_bvh8_contacts(const Bvh8Pair& pair, SearchMode wanted, SimdTarget simd_target,
                        std::vector<TrianglePair>& out, QueryStatistics& work) {
    switch (simd_target) {
#ifdef __aarch64__
        case SimdTarget::neon:
            return N_NEON::search(pair, wanted, out, work);
#else
        case SimdTarget::sse42:
            return N_SSE4::search(pair, wanted, out, work);
        case SimdTarget::avx2:
            return N_AVX2::search(pair, wanted, out, work);
        case SimdTarget::avx512:
            return N_AVX3::search(pair, wanted, out, work);
#endif
    }
}

}  // namespace campuswalk::collision
#endif

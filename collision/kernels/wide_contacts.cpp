#include "collision/kernels/wide_contacts.h"

// Highway compiles this file once for each instruction set; which to run is ours to say, so nothing of its
// library is linked. Its own assertions are off even in debug builds: they'd need that library.
#define HWY_IS_DEBUG_BUILD 0
#define HWY_BASELINE_TARGETS HWY_SSE4
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collision/kernels/wide_contacts.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "collision/kernels/leaf_pair_inl.h"
#include "collision/kernels/node_pair_inl.h"
#include "collision/kernels/prefetch.h"
#include "collision/kernels/relative_pose_inl.h"

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

HWY_INLINE std::uint32_t all_children(const WideNode& node) {
    return (1U << node.count) - 1U;
}

/// Bits 8 i to 8 i + 7 for each bit i.
HWY_INLINE std::uint64_t whole_rows(std::uint64_t bits) {
    const std::uint64_t spread = (bits * 0x0101010101010101ULL) & 0x8040201008040201ULL;
    // a byte that has a bit becomes 0xFF
    const std::uint64_t ones = (((spread & 0x7F7F7F7F7F7F7F7FULL) + 0x7F7F7F7F7F7F7F7FULL) | spread) >> 7;
    return (ones & 0x0101010101010101ULL) * 0xFF;
}

void search(const WidePair& pair, Wanted wanted, std::vector<TrianglePair>& out, QueryCounters& counters) {
    // Of trees that the caches next to a core can't hold, what comes next is fetched ahead.
    constexpr std::size_t kNodesInCache = 2048;
    const bool far = pair.a.nodes.size() + pair.b.nodes.size() > kNodesInCache;
    const RelativePose pose(pair);
    LeafPairs leaf_pairs(pair, pose, out, counters);
    thread_local std::vector<NodePair> stack;
    stack.clear();
    stack.push_back({0, 0, all_children(pair.a.nodes[0]), all_children(pair.b.nodes[0])});
    while (!stack.empty()) {
        const NodePair item = stack.back();
        stack.pop_back();
        const WideNode& a = pair.a.nodes[item.a];
        const WideNode& b = pair.b.nodes[item.b];
        ++counters.nu;
        counters.nv += static_cast<std::uint64_t>(std::popcount(item.rows) * std::popcount(item.columns));
        const std::uint64_t met = children_met(pose, a, b, item.rows, item.columns);
        const std::uint64_t leaves = whole_rows(a.leaves) & (0x0101010101010101ULL * b.leaves);
        for (std::uint64_t m = met & leaves; m != 0; m &= m - 1) {
            const auto bit = static_cast<std::size_t>(std::countr_zero(m));
            if (const std::uint64_t rest = m & (m - 1); far && rest != 0) {
                const auto next = static_cast<std::size_t>(std::countr_zero(rest));
                prefetch(pair.a.leaves[a.child[next / 8]]);
                prefetch(pair.b.leaves[b.child[next % 8]]);
            }
            leaf_pairs.find(pair.a.leaves[a.child[bit / 8]], pair.b.leaves[b.child[bit % 8]]);
            if (wanted == Wanted::first && !out.empty()) {
                return;
            }
        }
        for (std::uint64_t m = met & ~leaves; m != 0; m &= m - 1) {
            const auto bit = static_cast<std::size_t>(std::countr_zero(m));
            const std::size_t i = bit / 8;
            const std::size_t j = bit % 8;
            NodePair next{item.a, item.b, 1U << i, 1U << j};
            if ((a.leaves >> i & 1) == 0) {
                next.a = a.child[i];
                next.rows = all_children(pair.a.nodes[next.a]);
            }
            if ((b.leaves >> j & 1) == 0) {
                next.b = b.child[j];
                next.columns = all_children(pair.b.nodes[next.b]);
            }
            if (far) {
                prefetch(pair.a.nodes[next.a]);
                prefetch(pair.b.nodes[next.b]);
            }
            stack.push_back(next);
        }
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace campuswalk::collision
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace campuswalk::collision {

void find_wide_contacts(const WidePair& pair, Wanted wanted, Instructions instructions,
                        std::vector<TrianglePair>& out, QueryCounters& counters) {
    switch (instructions) {
        case Instructions::sse42:
            return N_SSE4::search(pair, wanted, out, counters);
        case Instructions::avx2:
            return N_AVX2::search(pair, wanted, out, counters);
        case Instructions::avx512:
            return N_AVX3::search(pair, wanted, out, counters);
    }
}

}  // namespace campuswalk::collision
#endif

#include "collision/bvh8/kernels/area_split.h"

#include <algorithm>
#include <cstring>
#include <limits>

// As in bvh8_contacts.cpp, but without AVX-512: the same code on eight lanes takes a tenth longer with it.
#define HWY_IS_DEBUG_BUILD 0
#ifdef __x86_64__
#define HWY_BASELINE_TARGETS HWY_SSE4
#else
#define HWY_COMPILE_ONLY_STATIC
#endif
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collision/bvh8/kernels/area_split.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace campuswalk::collision {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Four = hn::FixedTag<float, 4>;
using Vec4 = hn::Vec<Four>;

constexpr std::size_t kBins = 16;

/// The expected number of triangles per leaf: its vertex slots are usually full before its sixteen triangles.
constexpr float kTypicalLeaf = 14.0F;

/// SplitItem::ends, of one item or merged from many.
struct Ends {
    using Tag = hn::CappedTag<float, 8>;
    static constexpr std::size_t kParts = 8 / hn::MaxLanes(Tag());
    hn::Vec<Tag> part[kParts];

    static HWY_INLINE Ends load(const float* from) {
        Ends made;
        for (std::size_t i = 0; i < kParts; ++i) {
            made.part[i] = hn::Load(Tag(), from + i * hn::MaxLanes(Tag()));
        }
        return made;
    }
    static HWY_INLINE Ends none() {
        Ends made;
        for (auto& part : made.part) {
            part = hn::Set(Tag(), std::numeric_limits<float>::max());
        }
        return made;
    }
    HWY_INLINE void store(float* to) const {
        for (std::size_t i = 0; i < kParts; ++i) {
            hn::Store(part[i], Tag(), to + i * hn::MaxLanes(Tag()));
        }
    }
    HWY_INLINE void extend(const Ends& o) {
        for (std::size_t i = 0; i < kParts; ++i) {
            part[i] = hn::Min(part[i], o.part[i]);
        }
    }
    /// The lengths of the box, negated: their products aren't.
    HWY_INLINE Vec4 lengths() const { return lower_and_upper(part); }

private:
    template <class V>
    static HWY_INLINE Vec4 lower_and_upper(const V (&whole)[1]) {
        return hn::Add(hn::LowerHalf(whole[0]), hn::UpperHalf(Four(), whole[0]));
    }
    template <class V>
    static HWY_INLINE Vec4 lower_and_upper(const V (&halves)[2]) {
        return hn::Add(halves[0], halves[1]);
    }
};

HWY_INLINE Vec4 center(const SplitItem& item) {
    return hn::Sub(hn::Load(Four(), item.ends.data()), hn::Load(Four(), item.ends.data() + 4));
}

/// Maps centres to bins along the three axes.
struct Binning {
    HWY_ALIGN float low[4];
    HWY_ALIGN float scale[4];

    explicit Binning(std::span<const SplitItem> items) {
        const Four d;
        Vec4 least = center(items.front());
        Vec4 greatest = least;
        Vec4 least_of_right = least;
        Vec4 greatest_of_right = least;
        const std::size_t half = items.size() / 2;
        for (std::size_t i = 0; i < half; ++i) {
            const Vec4 left = center(items[i]);
            const Vec4 right = center(items[half + i]);
            least = hn::Min(least, left);
            greatest = hn::Max(greatest, left);
            least_of_right = hn::Min(least_of_right, right);
            greatest_of_right = hn::Max(greatest_of_right, right);
        }
        const Vec4 last = center(items.back());
        least = hn::Min(hn::Min(least, least_of_right), last);
        greatest = hn::Max(hn::Max(greatest, greatest_of_right), last);
        const Vec4 extent = hn::Sub(greatest, least);
        hn::Store(least, d, low);
        // Slightly less than the number of bins, so that the greatest centre falls into the last. Centres
        // closer than 1e-35 count as one place: the quotient must be finite.
        const auto apart = hn::Gt(extent, hn::Set(d, 1e-35F));
        const Vec4 quotient = hn::Div(hn::Set(d, kBins * 0.9999F), extent);
        hn::Store(hn::IfThenElseZero(apart, quotient), d, scale);
    }
};

/// The contents of the bins of the three axes.
struct Bins {
    HWY_ALIGN float ends[3][kBins][8];
    HWY_ALIGN std::int32_t counts[kBins][4];  ///< by axis, the fourth is 0

    HWY_INLINE Bins(std::span<const SplitItem> items, const Binning& binning) {
        for (auto& along : ends) {
            for (auto& bin : along) {
                Ends::none().store(bin);
            }
        }
        std::memset(counts, 0, sizeof counts);
        // Alternates between both halves: neighbouring items mostly fall into the same bins, and each would
        // have to wait for the previous one.
        const std::size_t half = items.size() / 2;
        for (std::size_t i = 0; i < half; ++i) {
            add(items[i], binning);
            add(items[half + i], binning);
        }
        if (2 * half < items.size()) {
            add(items.back(), binning);
        }
    }

private:
    HWY_INLINE void add(const SplitItem& item, const Binning& binning) {
        const Four d;
        const hn::RebindToSigned<Four> di;
        const Vec4 from_low = hn::Sub(center(item), hn::Load(d, binning.low));
        const auto at = hn::ConvertTo(di, hn::Mul(from_low, hn::Load(d, binning.scale)));
        // Four times the bin: the remaining factor fits x86's addressing modes.
        const auto bins = hn::BitCast(hn::RebindToUnsigned<Four>(), hn::ShiftLeft<2>(at));
        const Ends by = Ends::load(item.ends.data());
        add<0>(hn::ExtractLane(bins, 0), by);
        add<1>(hn::ExtractLane(bins, 1), by);
        add<2>(hn::ExtractLane(bins, 2), by);
    }

    template <std::size_t kAxis>
    HWY_INLINE void add(std::size_t four_bins, Ends by) {
        float* bin = &ends[kAxis][0][0] + 2 * four_bins;
        by.extend(Ends::load(bin));
        by.store(bin);
        ++*(&counts[0][kAxis] + four_bins);
    }
};

/// Half the surface areas of three boxes.
HWY_INLINE Vec4 half_areas(const Ends* ends) {
    const Four d;
    const Vec4 a = ends[0].lengths();
    const Vec4 b = ends[1].lengths();
    const Vec4 c = ends[2].lengths();
    const Vec4 xxyy = hn::InterleaveLower(d, a, b);
    const Vec4 x = hn::ConcatLowerLower(d, c, xxyy);
    const Vec4 y = hn::ConcatUpperUpper(d, hn::InterleaveLower(d, c, c), xxyy);
    const Vec4 z = hn::ConcatUpperLower(d, c, hn::InterleaveUpper(d, a, b));
    return hn::Add(hn::Mul(x, y), hn::Add(hn::Mul(y, z), hn::Mul(z, x)));
}

/// The number of leaves for so many triangles. The half triangle avoids the next integer.
HWY_INLINE Vec4 leaves(Vec4 triangles) {
    const Four d;
    const Vec4 full = hn::Add(triangles, hn::Set(d, kTypicalLeaf - 0.5F));
    return hn::Trunc(hn::Mul(full, hn::Set(d, 1.0F / kTypicalLeaf)));
}

/// Everything below `bin` goes to the left.
struct Cut {
    std::size_t axis = 0;
    std::size_t bin = 0;  ///< 0: no cut
};

/// Handles the three axes in parallel, one per lane. A cut with an empty side costs NaN, which is never less.
Cut best_cut(const Bins& bins, std::size_t items) {
    const Four d;
    HWY_ALIGN float right_areas[kBins][4];
    Ends right[3] = {Ends::none(), Ends::none(), Ends::none()};
    for (std::size_t k = kBins - 1; k > 0; --k) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            right[axis].extend(Ends::load(bins.ends[axis][k]));
        }
        hn::Store(half_areas(right), d, right_areas[k]);
    }
    Ends left[3] = {Ends::none(), Ends::none(), Ends::none()};
    const hn::RebindToSigned<Four> di;
    auto counts = hn::Zero(di);
    Vec4 least = hn::Set(d, std::numeric_limits<float>::max());
    Vec4 best = hn::Zero(d);
    for (std::size_t k = 1; k < kBins; ++k) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            left[axis].extend(Ends::load(bins.ends[axis][k - 1]));
        }
        counts = hn::Add(counts, hn::Load(di, bins.counts[k - 1]));
        const Vec4 count = hn::ConvertTo(d, counts);
        const Vec4 others = hn::Sub(hn::Set(d, static_cast<float>(items)), count);
        const Vec4 cost = hn::Add(hn::Mul(half_areas(left), leaves(count)),
                                  hn::Mul(hn::Load(d, right_areas[k]), leaves(others)));
        const auto better = hn::Lt(cost, least);
        least = hn::IfThenElse(better, cost, least);
        best = hn::IfThenElse(better, hn::Set(d, static_cast<float>(k)), best);
    }
    HWY_ALIGN float costs[4];
    HWY_ALIGN float at[4];
    hn::Store(least, d, costs);
    hn::Store(best, d, at);
    const auto axis = static_cast<std::size_t>(std::min_element(costs, costs + 3) - costs);
    return {axis, static_cast<std::size_t>(at[axis])};
}

/// Branch prediction can't guess the side, so each item is written to both, and counted only where it
/// belongs.
void partition(std::span<SplitItem> items, std::span<SplitItem> spare, const Binning& binning,
               const Cut& cut) {
    const std::size_t axis = cut.axis;
    const float low = binning.low[axis];
    const float scale = binning.scale[axis];
    const auto bin = static_cast<float>(cut.bin);
    std::size_t left = 0;
    std::size_t right = 0;
    for (const SplitItem& item : items) {
        const bool to_left = (item.center(axis) - low) * scale < bin;
        const Ends ends = Ends::load(item.ends.data());
        ends.store(items[left].ends.data());
        ends.store(spare[right].ends.data());
        left += to_left ? 1 : 0;
        right += to_left ? 0 : 1;
    }
    std::copy_n(spare.begin(), right, items.begin() + static_cast<std::ptrdiff_t>(left));
}

std::size_t split_by_area(std::span<SplitItem> items, std::span<SplitItem> spare, std::size_t least) {
    const Binning binning(items);
    const Bins bins(items, binning);
    const Cut cut = best_cut(bins, items.size());
    std::size_t left = 0;
    for (std::size_t k = 0; k < cut.bin; ++k) {
        left += static_cast<std::size_t>(bins.counts[k][cut.axis]);
    }
    if (cut.bin == 0 || left < least || items.size() - left < least) {
        return 0;
    }
    partition(items, spare, binning, cut);
    return left;
}

}  // namespace HWY_NAMESPACE
}  // namespace campuswalk::collision
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace campuswalk::collision {

std::size_t split_by_area(std::span<SplitItem> items, std::span<SplitItem> spare, std::size_t least,
                          SimdTarget simd_target) {
    switch (simd_target) {
#ifdef __aarch64__
        case SimdTarget::neon:
            return N_NEON::split_by_area(items, spare, least);
#else
        case SimdTarget::sse42:
            return N_SSE4::split_by_area(items, spare, least);
        case SimdTarget::avx2:
        case SimdTarget::avx512:
            return N_AVX2::split_by_area(items, spare, least);
#endif
    }
    return 0;
}

}  // namespace campuswalk::collision
#endif

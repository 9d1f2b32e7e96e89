#if defined(CAMPUSWALK_COLLISION_KERNELS_NODE_PAIR_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAMPUSWALK_COLLISION_KERNELS_NODE_PAIR_INL_H
#undef CAMPUSWALK_COLLISION_KERNELS_NODE_PAIR_INL_H
#else
#define CAMPUSWALK_COLLISION_KERNELS_NODE_PAIR_INL_H
#endif

#include <bit>

#include "collision/bvh8/kernels/lanes_inl.h"
#include "collision/bvh8/kernels/relative_pose_inl.h"

HWY_BEFORE_NAMESPACE();
namespace campuswalk::collision {
namespace HWY_NAMESPACE {

using BoxTag = hn::CappedTag<float, 8>;
using BoxReal = hn::Vec<BoxTag>;
inline constexpr std::size_t kBoxLanes = hn::MaxLanes(BoxTag());

struct BoxReal3 {
    BoxReal x, y, z;
};

struct BoxSlabs {
    BoxReal3 low, high;
};

inline constexpr std::uint32_t kAllBoxes = (1U << kBoxLanes) - 1U;

// What is computed for two nodes: which of their children may overlap,
struct ChildOverlaps : Fused {
    static constexpr bool kDepths = false;
    /// Negative if either is.
    static HWY_INLINE BoxReal join(BoxReal a, BoxReal b) { return hn::Or(a, b); }
};

// or also how deeply: along the axis where it is least, relative to their thickness. The depth is the same on
// every instruction set, because it decides which pair is found first.
struct OverlapDepths : Unfused {
    static constexpr bool kDepths = true;
    static HWY_INLINE BoxReal join(BoxReal a, BoxReal b) { return hn::Min(a, b); }

    float of_pair(std::size_t bit) const { return of[bit / 8][bit % 8]; }

    HWY_ALIGN float of[kBvh8Children][kBvh8Children];  ///< by child of a, then of b
};

/// Negative where one box is apart from others along one of three axes.
template <class Output>
HWY_INLINE BoxReal gap(const float low[3], const float high[3], const BoxSlabs& others) {
    const BoxTag d;
    const auto along = [&](std::size_t k, BoxReal others_low, BoxReal others_high) {
        return Output::join(hn::Sub(hn::Set(d, high[k]), others_low),
                            hn::Sub(others_high, hn::Set(d, low[k])));
    };
    return Output::join(
        Output::join(along(0, others.low.x, others.high.x), along(1, others.low.y, others.high.y)),
        along(2, others.low.z, others.high.z));
}

/// The ends of eight boxes along three axes.
struct SlabTable {
    HWY_ALIGN float low[3][8];
    HWY_ALIGN float high[3][8];

    HWY_INLINE void set(const BoxSlabs& s, std::size_t c) {
        const BoxTag d;
        hn::Store(s.low.x, d, low[0] + c);
        hn::Store(s.low.y, d, low[1] + c);
        hn::Store(s.low.z, d, low[2] + c);
        hn::Store(s.high.x, d, high[0] + c);
        hn::Store(s.high.y, d, high[1] + c);
        hn::Store(s.high.z, d, high[2] + c);
    }

    /// Between box i and others.
    template <class Output>
    HWY_INLINE BoxReal gap(std::size_t i, const BoxSlabs& others) const {
        const float i_low[3] = {low[0][i], low[1][i], low[2][i]};
        const float i_high[3] = {high[0][i], high[1][i], high[2][i]};
        return HWY_NAMESPACE::gap<Output>(i_low, i_high, others);
    }
};

HWY_INLINE BoxReal3 load_boxes(const std::array<std::array<float, kBvh8Children>, 3>& from, std::size_t c) {
    const BoxTag d;
    return {hn::Load(d, from[0].data() + c), hn::Load(d, from[1].data() + c),
            hn::Load(d, from[2].data() + c)};
}

HWY_INLINE BoxSlabs slabs(const BoxReal3& center, const BoxReal3& half) {
    return {{hn::Sub(center.x, half.x), hn::Sub(center.y, half.y), hn::Sub(center.z, half.z)},
            {hn::Add(center.x, half.x), hn::Add(center.y, half.y), hn::Add(center.z, half.z)}};
}

HWY_INLINE BoxReal least(const BoxReal3& half) {
    return hn::Min(half.x, hn::Min(half.y, half.z));
}

/// Projects boxes onto an axis m of another frame: adds m . center to `middle` and |m| . half to `reach`.
template <class Arithmetic>
HWY_INLINE void project(const float m[3], const BoxReal3& center, const BoxReal3& half, BoxReal& middle,
                        BoxReal& reach) {
    const BoxTag d;
    const BoxReal x = hn::Set(d, m[0]);
    const BoxReal y = hn::Set(d, m[1]);
    const BoxReal z = hn::Set(d, m[2]);
    const auto add = [](BoxReal a, BoxReal b, BoxReal sum) { return Arithmetic::multiply_add(a, b, sum); };
    middle = add(x, center.x, add(y, center.y, add(z, center.z, middle)));
    reach = add(hn::Abs(x), half.x, add(hn::Abs(y), half.y, add(hn::Abs(z), half.z, reach)));
}

/// From b's frame to a's: y_a = M y_b + s.
template <class Arithmetic>
struct FrameChange {
    float row[3][3];     ///< M
    float column[3][3];  ///< its transpose
    float s[3];

    FrameChange(const RelativePose& pose, const Bvh8Node& a, const Bvh8Node& b) {
        const hn::FixedTag<float, 4> d;
        const auto r0 = hn::Load(d, pose.column[0]);
        const auto r1 = hn::Load(d, pose.column[1]);
        const auto r2 = hn::Load(d, pose.column[2]);
        const auto a0 = hn::LoadU(d, a.axes[0].data());
        const auto a1 = hn::LoadU(d, a.axes[1].data());
        const auto a2 = hn::LoadU(d, a.axes[2].data());
        HWY_ALIGN float rotated[4];
        for (std::size_t k = 0; k < 3; ++k) {
            auto g = hn::Mul(r0, hn::Set(d, b.axes[0][k]));
            g = Arithmetic::multiply_add(r1, hn::Set(d, b.axes[1][k]), g);
            g = Arithmetic::multiply_add(r2, hn::Set(d, b.axes[2][k]), g);
            auto m = hn::Mul(a0, hn::Broadcast<0>(g));
            m = Arithmetic::multiply_add(a1, hn::Broadcast<1>(g), m);
            m = Arithmetic::multiply_add(a2, hn::Broadcast<2>(g), m);
            hn::Store(m, d, rotated);
            for (std::size_t i = 0; i < 3; ++i) {
                row[i][k] = rotated[i];
                column[k][i] = rotated[i];
            }
        }
        float t[4];
        pose.offset<Arithmetic>(a.origin, b.origin, t);
        auto v = hn::Mul(a0, hn::Set(d, t[0]));
        v = Arithmetic::multiply_add(a1, hn::Set(d, t[1]), v);
        v = Arithmetic::multiply_add(a2, hn::Set(d, t[2]), v);
        hn::Store(v, d, rotated);
        for (std::size_t i = 0; i < 3; ++i) {
            s[i] = rotated[i];
        }
    }
};

/// Bit 8 i + j: child i of a and child j of b may overlap; only those in `rows` and `columns`. Tests six
/// axes, three per frame: the nine edge axes separate too few to pay off.
///
/// Rounding: an entry of M is off by 10 u (two products of three, of rows no longer than 1), which moves a
/// box by 18 u r, since its coordinates add up to at most sqrt(3) r; evaluating three products and a sum adds
/// 7 u, the frames' deviation from rotations 7 u, the offset's rounding 11 u, the last additions 2 u: less
/// than 48 u L. 64 u L are added to each box.
template <class Output>
HWY_INLINE std::uint64_t overlapping_children(const RelativePose& pose, const Bvh8Node& a, const Bvh8Node& b,
                                              std::uint32_t rows, std::uint32_t columns, Output& output) {
    const BoxTag d;
    const FrameChange<Output> change(pose, a, b);
    const BoxReal slack = hn::Set(d, pose.bound(64.0F, a.radius + b.radius + length_of(change.s)));

    // Most boxes of a miss all of b's at once; those left in `rows` are tested against each.
    std::uint32_t candidates = 0;
    SlabTable a_own;
    SlabTable a_in_b;
    HWY_ALIGN float a_thickness[kBvh8Children];
    for (std::size_t c = 0; c < kBvh8Children; c += kBoxLanes) {
        BoxReal3 center = load_boxes(a.center, c);
        const BoxReal3 half = load_boxes(a.half, c);
        a_own.set(slabs(center, half), c);
        if constexpr (Output::kDepths) {
            hn::Store(hn::Add(least(half), slack), d, a_thickness + c);  // never 0
        }
        center = {hn::Sub(center.x, hn::Set(d, change.s[0])), hn::Sub(center.y, hn::Set(d, change.s[1])),
                  hn::Sub(center.z, hn::Set(d, change.s[2]))};
        BoxReal3 middle = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
        BoxReal3 reach = {slack, slack, slack};
        project<Output>(change.column[0], center, half, middle.x, reach.x);
        project<Output>(change.column[1], center, half, middle.y, reach.y);
        project<Output>(change.column[2], center, half, middle.z, reach.z);
        const BoxSlabs in_b = slabs(middle, reach);
        a_in_b.set(in_b, c);
        candidates |= (~sign_bits(d, gap<Output>(b.low.data(), b.high.data(), in_b)) & kAllBoxes) << c;
    }
    rows &= candidates;
    if (rows == 0) {
        return 0;
    }
    std::uint64_t overlapping = 0;
    for (std::size_t c = 0; c < kBvh8Children; c += kBoxLanes) {
        const BoxReal3 center = load_boxes(b.center, c);
        const BoxReal3 half = load_boxes(b.half, c);
        BoxReal3 middle = {hn::Set(d, change.s[0]), hn::Set(d, change.s[1]), hn::Set(d, change.s[2])};
        BoxReal3 reach = {slack, slack, slack};
        project<Output>(change.row[0], center, half, middle.x, reach.x);
        project<Output>(change.row[1], center, half, middle.y, reach.y);
        project<Output>(change.row[2], center, half, middle.z, reach.z);
        const BoxSlabs b_own = slabs(center, half);
        const BoxSlabs b_in_a = slabs(middle, reach);
        for (std::uint32_t m = rows; m != 0; m &= m - 1) {
            const auto i = static_cast<std::size_t>(std::countr_zero(m));
            const BoxReal gaps = Output::join(a_own.gap<Output>(i, b_in_a), a_in_b.gap<Output>(i, b_own));
            if constexpr (Output::kDepths) {
                const BoxReal thickness = hn::Add(hn::Set(d, a_thickness[i]), least(half));
                hn::Store(hn::Div(gaps, thickness), d, output.of[i] + c);
            }
            const std::uint64_t together = ~sign_bits(d, gaps) & kAllBoxes;
            overlapping |= together << (8 * i + c);
        }
    }
    return overlapping & (0x0101010101010101ULL * columns);
}

}  // namespace HWY_NAMESPACE
}  // namespace campuswalk::collision
HWY_AFTER_NAMESPACE();

#endif

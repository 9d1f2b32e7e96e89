// Compiled once for each instruction set, by the file that includes it: Highway's pattern for such headers.
#if defined(CAMPUSWALK_COLLISION_KERNELS_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAMPUSWALK_COLLISION_KERNELS_LANES_INL_H
#undef CAMPUSWALK_COLLISION_KERNELS_LANES_INL_H
#else
#define CAMPUSWALK_COLLISION_KERNELS_LANES_INL_H
#endif

#include <cstdint>
#include <type_traits>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace campuswalk::collision {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// As many float32 as the instruction set takes, at most eight: sixteen lower the clock rate of many
/// processors, which costs more than they gain.
using Floats = hn::CappedTag<float, 8>;
using Real = hn::Vec<Floats>;
inline constexpr std::size_t kLanes = hn::MaxLanes(Floats());

/// Sixteen bytes.
using ByteTag = hn::FixedTag<std::uint8_t, 16>;
using Bytes = hn::Vec<ByteTag>;

/// Bit i: lane i of the mask. Up to sixteen lanes.
template <class D, class Mask>
HWY_INLINE std::uint32_t bits_of(D d, Mask mask) {
    static_assert(hn::MaxLanes(d) <= 16);
    std::uint8_t bytes[2] = {};
    hn::StoreMaskBits(d, mask, bytes);
    return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8;
}

/// Bit i: the sign of lane i.
template <class D, class V>
HWY_INLINE std::uint32_t sign_bits(D d, V v) {
#if HWY_TARGET == HWY_AVX3
    // Going through a mask register takes three instructions instead of one.
    if constexpr (hn::MaxLanes(d) == 8 && sizeof(hn::TFromD<D>) == sizeof(float)) {
        return static_cast<std::uint32_t>(_mm256_movemask_ps(hn::BitCast(hn::Rebind<float, D>(), v).raw));
    } else if constexpr (hn::MaxLanes(d) == 16 && sizeof(hn::TFromD<D>) == 1) {
        return static_cast<std::uint32_t>(_mm_movemask_epi8(v.raw));
    } else
#endif
#if HWY_TARGET == HWY_NEON
        // Masks there are lanes of all ones or all zeros, and MaskFromVec doesn't convert.
        v = hn::BitCast(d, hn::BroadcastSignBit(hn::BitCast(hn::RebindToSigned<D>(), v)));
#endif
    // On x86 up to AVX2 a mask is its lanes' sign bits; later ones convert it to that.
    return bits_of(d, hn::MaskFromVec(v));
}

/// The numbers of a table of sixteen that the bytes index, as many as there are lanes.
template <class D>
HWY_INLINE hn::Vec<D> pick(D d, const float* table, const std::uint8_t* bytes) {
    constexpr std::size_t kCount = hn::MaxLanes(D());
    if constexpr (kCount == 4) {
        HWY_ALIGN float picked[kCount];
        for (std::size_t lane = 0; lane < kCount; ++lane) {
            picked[lane] = table[bytes[lane]];
        }
        return hn::Load(d, picked);
    } else {
        const hn::RebindToSigned<D> di;
        const auto index = hn::PromoteTo(di, hn::LoadU(hn::Rebind<std::uint8_t, decltype(di)>(), bytes));
        const auto low = hn::Load(d, table);
        const auto high = hn::Load(d, table + 8);
#if HWY_TARGET == HWY_AVX3
        return hn::Vec<D>{_mm256_permutex2var_ps(low.raw, index.raw, high.raw)};
#else
        const auto at = hn::IndicesFromVec(d, hn::And(index, hn::Set(di, 7)));
        const auto upper = hn::RebindMask(d, hn::Gt(index, hn::Set(di, 7)));
        return hn::IfThenElse(upper, hn::TableLookupLanes(high, at), hn::TableLookupLanes(low, at));
#endif
    }
}

/// Rounds a b + c once, where the instruction set can.
struct Fused {
    template <class V>
    static HWY_INLINE V multiply_add(V a, V b, V c) {
        return hn::MulAdd(a, b, c);
    }
};
/// Rounds a b + c twice, with the same result on every instruction set.
struct Unfused {
    template <class V>
    static HWY_INLINE V multiply_add(V a, V b, V c) {
        return hn::Add(hn::Mul(a, b), c);
    }
};

struct Real3 {
    Real x, y, z;
};

HWY_INLINE Real3 subtract(const Real3& a, const Real3& b) {
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

HWY_INLINE Real3 cross(const Real3& a, const Real3& b) {
    return {hn::MulSub(a.y, b.z, hn::Mul(a.z, b.y)), hn::MulSub(a.z, b.x, hn::Mul(a.x, b.z)),
            hn::MulSub(a.x, b.y, hn::Mul(a.y, b.x))};
}

HWY_INLINE Real dot(const Real3& a, const Real3& b) {
    return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}

HWY_INLINE Real largest(const Real3& a) {
    return hn::Max(hn::Abs(a.x), hn::Max(hn::Abs(a.y), hn::Abs(a.z)));
}

}  // namespace HWY_NAMESPACE
}  // namespace campuswalk::collision
HWY_AFTER_NAMESPACE();

#endif

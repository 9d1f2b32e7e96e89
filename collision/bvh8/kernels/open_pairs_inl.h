#if defined(CAMPUSWALK_COLLISION_KERNELS_OPEN_PAIRS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAMPUSWALK_COLLISION_KERNELS_OPEN_PAIRS_INL_H
#undef CAMPUSWALK_COLLISION_KERNELS_OPEN_PAIRS_INL_H
#else
#define CAMPUSWALK_COLLISION_KERNELS_OPEN_PAIRS_INL_H
#endif

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "collision/bvh8/kernels/lanes_inl.h"
#include "collision/bvh8/kernels/plane_sides_inl.h"

HWY_BEFORE_NAMESPACE();
namespace campuswalk::collision {
namespace HWY_NAMESPACE {

/// For each byte, the positions of its set bits, lowest first, one per byte: turns a mask into a list without
/// a branch for each bit.
inline constexpr std::array<std::uint64_t, 256> kBitPositions = [] {
    std::array<std::uint64_t, 256> positions{};
    for (unsigned byte = 0; byte < 256; ++byte) {
        unsigned found = 0;
        for (unsigned bit = 0; bit < 8; ++bit) {
            if ((byte >> bit & 1U) != 0) {
                positions[byte] |= static_cast<std::uint64_t>(bit) << (8 * found++);
            }
        }
    }
    return positions;
}();

/// The pairs of triangles that may overlap: bit j of row i for triangle i of a and j of b.
struct OpenPairs {
    HWY_ALIGN std::uint16_t rows[16];

    /// The pairs that are open in both: `columns` by b's triangle, `of_a` by a's.
    HWY_INLINE OpenPairs(const ByteRows& columns, const ByteRows& of_a) {
        const ByteTag d;
        Bytes low;
        Bytes high;
        transpose(columns, low, high);
        low = hn::And(low, hn::InterleaveLower(d, of_a.low, of_a.high));
        high = hn::And(high, hn::InterleaveUpper(d, of_a.low, of_a.high));
        hn::Store(low, d, bytes());
        hn::Store(high, d, bytes() + 16);
    }

    std::uint8_t* bytes() { return reinterpret_cast<std::uint8_t*>(rows); }
    const std::uint8_t* bytes() const { return reinterpret_cast<const std::uint8_t*>(rows); }

    HWY_INLINE std::size_t count() const {
        std::size_t sum = 0;
        for (std::size_t at = 0; at < 32; at += 8) {
            std::uint64_t word = 0;
            std::memcpy(&word, bytes() + at, sizeof word);
            sum += static_cast<std::size_t>(std::popcount(word));
        }
        return sum;
    }

    /// Bit i: row i has open pairs.
    HWY_INLINE std::uint32_t live_rows() const {
        const hn::CappedTag<std::uint16_t, 16> d;
        std::uint32_t live = 0;
        for (std::size_t c = 0; c < 16; c += hn::MaxLanes(d)) {
            live |= bits_of(d, hn::Ne(hn::Load(d, rows + c), hn::Zero(d))) << c;
        }
        return live;
    }
};

/// Pairs of triangles, one byte each: a's index in the upper half, b's in the lower.
class PairList {
public:
    std::size_t size() const { return count_; }
    const std::uint8_t* operator+(std::size_t first) const { return ij_ + first; }

    HWY_INLINE void add_all(const OpenPairs& open) {
        // A local, because a member would be stored and loaded at each step: bytes may alias anything.
        std::size_t count = 0;
        for (std::uint32_t live = open.live_rows(); live != 0; live &= live - 1) {
            const auto row = static_cast<std::size_t>(std::countr_zero(live));
            for (std::size_t half = 0; half < 2; ++half) {
                const std::uint64_t bits = open.bytes()[2 * row + half];
                const std::uint64_t first = 16 * row + 8 * half;
                const std::uint64_t eight = kBitPositions[bits] + first * 0x0101010101010101ULL;
                std::memcpy(ij_ + count, &eight, sizeof eight);
                count += static_cast<std::size_t>(std::popcount(bits));
            }
        }
        const ByteTag d;
        hn::StoreU(hn::Zero(d), d, ij_ + count);
        count_ = count;
    }

    /// Adds those of eight pairs whose bit is set.
    HWY_INLINE void add_some(const std::uint8_t* eight, std::uint64_t bits) {
        const hn::FixedTag<std::uint8_t, 8> d;
        const auto positions = hn::BitCast(d, hn::Set(hn::FixedTag<std::uint64_t, 1>(), kBitPositions[bits]));
        const auto chosen = hn::TableLookupBytes(hn::LoadU(d, eight), positions);
        hn::StoreU(chosen, d, ij_ + count_);
        count_ += static_cast<std::size_t>(std::popcount(bits));
    }

private:
    HWY_ALIGN std::uint8_t ij_[16 * 16 + 16];  // with room for writes beyond the last
    std::size_t count_ = 0;
};

}  // namespace HWY_NAMESPACE
}  // namespace campuswalk::collision
HWY_AFTER_NAMESPACE();

#endif

#if defined(CAMPUSWALK_COLLISION_KERNELS_PLANE_SIDES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAMPUSWALK_COLLISION_KERNELS_PLANE_SIDES_INL_H
#undef CAMPUSWALK_COLLISION_KERNELS_PLANE_SIDES_INL_H
#else
#define CAMPUSWALK_COLLISION_KERNELS_PLANE_SIDES_INL_H
#endif

#include <algorithm>
#include <bit>

#include "collision/bvh8/bvh8.h"
#include "collision/bvh8/kernels/lanes_inl.h"

HWY_BEFORE_NAMESPACE();
namespace campuswalk::collision {
namespace HWY_NAMESPACE {

/// What is kept of a corner's distance from a plane.
enum class Sides {
    signs,    ///< above or below; good if no distance is near zero
    certain,  ///< above, below, or too near to say
};

/// By triangle of one leaf, bits of triangles of the other: 0 to 7 and 8 to 15.
struct ByteRows {
    Bytes low;
    Bytes high;
};

/// The corners of sixteen triangles, the one alone on its side of a plane first, in cyclic order.
struct ArrangedVertices {
    Bytes p, q, r;
    Bytes lone_below;  ///< all bits where the lone corner is below the plane
    Bytes sure;        ///< all bits where no side is in doubt

    HWY_INLINE void turn_over(Bytes where) {
        const Bytes old_q = q;
        q = hn::IfVecThenElse(where, r, q);
        r = hn::IfVecThenElse(where, old_q, r);
    }
    HWY_INLINE void store(std::uint8_t order[3][16]) const {
        const ByteTag d;
        hn::Store(p, d, order[0]);
        hn::Store(q, d, order[1]);
        hn::Store(r, d, order[2]);
    }
};

/// The sides of one leaf's corners as seen from the planes of another, bits 0 to 7 and 8 to 15.
template <Sides kSides>
class SideTable {
public:
    /// `corners` are in the frame of `planes`. Distances up to `error` are near zero. Whether the table is
    /// good.
    HWY_INLINE bool fill(const Bvh8Leaf& planes, const float vertices[3][16], std::size_t count,
                         float error) {
        const Floats d;
        const ByteTag d8;
        for (std::size_t half = 0; half < 2; ++half) {
            hn::Store(hn::Zero(d8), d8, below_[half]);
            hn::Store(hn::Zero(d8), d8, above_[half]);
        }
        Bits nearest = hn::Set(Unsigned(), 0xFFFFFFFFU);
        for (std::size_t c = 0; c < planes.triangles; c += kPlanesAtOnce) {
            nearest = fill_planes(planes, vertices, count, error, c, nearest);
        }
        const Bits doubtful = hn::BitCast(Unsigned(), hn::Set(d, 2.0F * error));
        const auto in_doubt = hn::Eq(hn::Min(nearest, doubtful), nearest);
        return kSides == Sides::certain || bits_of(Unsigned(), in_doubt) == 0;
    }

    /// For each triangle of the corners' leaf, which of the first `planes` it isn't clear of.
    HWY_INLINE ByteRows not_clear(const Bvh8Leaf& leaf, std::size_t planes) const {
        return {not_clear(leaf, planes, 0), not_clear(leaf, planes, 1)};
    }

    /// By lane, the corners of a triangle as seen from a plane.
    HWY_INLINE ArrangedVertices arrange(const Bvh8Leaf& leaf, Bytes triangle, Bytes plane) const {
        const ByteTag d;
        const Bytes p = lookup(leaf.vertex_of[0].data(), triangle);
        const Bytes q = lookup(leaf.vertex_of[1].data(), triangle);
        const Bytes r = lookup(leaf.vertex_of[2].data(), triangle);
        const Bytes sp = side(below_, p, plane);
        const Bytes sq = side(below_, q, plane);
        const Bytes sr = side(below_, r, plane);
        const Bytes pq = hn::Xor(sp, sq);
        const Bytes pr = hn::Xor(sp, sr);
        const Bytes q_alone = hn::AndNot(pr, pq);
        const Bytes r_alone = hn::AndNot(pq, pr);
        const auto choose = [&](Bytes if_p, Bytes if_q, Bytes if_r) {
            return hn::IfVecThenElse(q_alone, if_q, hn::IfVecThenElse(r_alone, if_r, if_p));
        };
        ArrangedVertices c;
        c.p = choose(p, q, r);
        c.q = choose(q, r, p);
        c.r = choose(r, p, q);
        c.lone_below = choose(sp, sq, sr);
        if constexpr (kSides == Sides::certain) {
            c.sure = hn::And(hn::Or(sp, side(above_, p, plane)),
                             hn::And(hn::Or(sq, side(above_, q, plane)), hn::Or(sr, side(above_, r, plane))));
        } else {
            c.sure = hn::Set(d, 0xFF);
        }
        return c;
    }

private:
    /// Two vectors at a time, so that a corner is fetched once for both.
    static constexpr std::size_t kPlanesAtOnce = 2 * kLanes;

    using Table = std::uint8_t[2][kLeafVertices];
    using Unsigned = hn::RebindToUnsigned<Floats>;
    using Bits = hn::Vec<Unsigned>;

    static HWY_INLINE Bytes lookup(const std::uint8_t* table, Bytes at) {
        return hn::TableLookupBytes(hn::Load(ByteTag(), table), at);
    }

    static HWY_INLINE void record(Table& table, std::size_t vertex, std::uint32_t bits, std::size_t c) {
        table[c / 8][vertex] = static_cast<std::uint8_t>(bits);
    }

    /// The planes from c on. Returns `nearest` or what is nearer.
    ///
    /// Planes are moved up by `error`, so that a negative distance is below for certain, and one up to twice
    /// that is in doubt. As unsigned numbers, negative distances are the greatest: the least of all tells
    /// whether any is in doubt.
    HWY_INLINE Bits fill_planes(const Bvh8Leaf& planes, const float vertices[3][16], std::size_t count,
                                float error, std::size_t c, Bits nearest) {
        const Floats d;
        const std::size_t c2 = c + kLanes;
        const auto part = [&](std::size_t k, std::size_t at) {
            return hn::Load(d, planes.plane[k].data() + at);
        };
        const Real3 n1{part(0, c), part(1, c), part(2, c)};
        const Real3 n2{part(0, c2), part(1, c2), part(2, c2)};
        const Real d1 = hn::Sub(part(3, c), hn::Set(d, error));
        const Real d2 = hn::Sub(part(3, c2), hn::Set(d, error));
        const auto distance = [](const Real3& n, const Real3& x, Real offset) {
            return hn::MulAdd(n.x, x.x, hn::MulAdd(n.y, x.y, hn::MulSub(n.z, x.z, offset)));
        };
        const Real far = hn::Set(d, 2.0F * error);
        const auto is_above = [&](Real f) {
            return kSides == Sides::certain ? bits_of(d, hn::Gt(f, far)) : 0U;
        };
        const auto see = [&](std::size_t v) {
            const Real3 x{hn::Set(d, vertices[0][v]), hn::Set(d, vertices[1][v]), hn::Set(d, vertices[2][v])};
            const Real f1 = distance(n1, x, d1);
            nearest = hn::Min(nearest, hn::BitCast(Unsigned(), f1));
            std::uint32_t below = sign_bits(d, f1);
            std::uint32_t above = is_above(f1);
            const Real f2 = distance(n2, x, d2);
            nearest = hn::Min(nearest, hn::BitCast(Unsigned(), f2));
            if constexpr (kLanes == 4) {
                below |= sign_bits(d, f2) << 4;
                above |= is_above(f2) << 4;
            } else {
                record(below_, v, sign_bits(d, f2), c2);
                record_above(v, is_above(f2), c2);
            }
            record(below_, v, below, c);
            record_above(v, above, c);
        };
        // By fours: leaves differ in how many corners they have, and a jump that can't be foreseen costs more
        // than to see a corner again (see Bvh8Leaf).
        for (std::size_t v = 0; v < count; v += 4) {
            see(v);
            see(v + 1);
            see(v + 2);
            see(v + 3);
        }
        return nearest;
    }

    HWY_INLINE void record_above(std::size_t vertex, std::uint32_t bits, std::size_t c) {
        if constexpr (kSides == Sides::certain) {
            record(above_, vertex, bits, c);
        }
    }

    HWY_INLINE Bytes not_clear(const Bvh8Leaf& leaf, std::size_t planes, std::size_t half) const {
        const ByteTag d;
        const Bytes p = hn::Load(d, leaf.vertex_of[0].data());
        const Bytes q = hn::Load(d, leaf.vertex_of[1].data());
        const Bytes r = hn::Load(d, leaf.vertex_of[2].data());
        const auto all = [&](const std::uint8_t* table) {
            return hn::And(lookup(table, p), hn::And(lookup(table, q), lookup(table, r)));
        };
        Bytes clear = all(below_[half]);
        if constexpr (kSides == Sides::certain) {
            clear = hn::Or(clear, all(above_[half]));
        } else {
            const std::uint8_t* table = below_[half];
            clear =
                hn::Or(clear, hn::Not(hn::Or(lookup(table, p), hn::Or(lookup(table, q), lookup(table, r)))));
        }
        const auto there = hn::Lt(hn::Iota(d, 0), hn::Set(d, leaf.triangles));
        const auto mask = static_cast<std::uint8_t>(((1U << planes) - 1U) >> (8 * half));
        return hn::IfThenElseZero(there, hn::AndNot(clear, hn::Set(d, mask)));
    }

    /// By lane, all bits if the corner is on that side of the plane.
    static HWY_INLINE Bytes side(const Table& table, Bytes vertex, Bytes plane) {
        const ByteTag d;
        alignas(16) static constexpr std::uint8_t kBits[16] = {1, 2, 4, 8, 16, 32, 64, 128,
                                                               1, 2, 4, 8, 16, 32, 64, 128};
        const Bytes bit = lookup(kBits, plane);
        const auto upper = hn::Gt(plane, hn::Set(d, 7));
        const Bytes planes = hn::IfThenElse(upper, lookup(table[1], vertex), lookup(table[0], vertex));
        return hn::VecFromMask(d, hn::Eq(hn::And(planes, bit), bit));
    }

    HWY_ALIGN Table below_;
    HWY_ALIGN Table above_;
};

/// Bit j of row i, sixteen bits a row, rows 0 to 7 and 8 to 15: bit i of `columns`' row j.
HWY_INLINE void transpose(const ByteRows& columns, Bytes& low, Bytes& high) {
    const ByteTag d;
    const hn::FixedTag<std::uint64_t, 1> word;
    for (Bytes* to : {&low, &high}) {
        Bytes bytes = to == &low ? columns.low : columns.high;
        std::uint64_t words[2] = {};
        for (std::size_t w = 2; w-- > 0;) {
            for (std::size_t row = 0; row < 4; ++row) {
                words[w] = words[w] << 16 | sign_bits(d, bytes);
                bytes = hn::Add(bytes, bytes);  // the next bit becomes the sign
            }
        }
        *to = hn::BitCast(d, hn::Combine(hn::FixedTag<std::uint64_t, 2>(), hn::Set(word, words[1]),
                                         hn::Set(word, words[0])));
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace campuswalk::collision
HWY_AFTER_NAMESPACE();

#endif

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

/// How a vertex's distance from a plane is classified.
enum class Sides {
    signs,    ///< above or below; only valid if no distance is near zero
    certain,  ///< above, below, or uncertain
};

/// For each triangle of one leaf, one bit per triangle of the other: 0 to 7 and 8 to 15.
struct ByteRows {
    Bytes low;
    Bytes high;
};

/// The vertices of sixteen triangles in cyclic order, starting with the one alone on its side of a plane.
struct ArrangedVertices {
    Bytes p, q, r;
    Bytes lone_below;  ///< all bits where the lone vertex is below the plane
    Bytes certain;     ///< all bits where all sides are certain

    /// Reverses the winding.
    HWY_INLINE void flip(Bytes where) {
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

/// The sides of another leaf's planes that a leaf's vertices are on, bits 0 to 7 and 8 to 15.
template <Sides kSides>
class SideTable {
public:
    /// `vertices` are in the frame of `planes`. Distances up to `error` are near zero. Returns whether the
    /// table is valid.
    HWY_INLINE bool fill(const Bvh8Leaf& planes, const float vertices[3][16], std::size_t count,
                         float error) {
        const Floats d;
        const ByteTag d8;
        for (std::size_t half = 0; half < 2; ++half) {
            hn::Store(hn::Zero(d8), d8, below_[half]);
            hn::Store(hn::Zero(d8), d8, above_[half]);
        }
        Bits nearest = hn::Set(Unsigned(), 0xFFFFFFFFU);
        for (std::size_t c = 0; c < planes.triangle_count; c += kPlanesAtOnce) {
            nearest = fill_planes(planes, vertices, count, error, c, nearest);
        }
        const Bits uncertain = hn::BitCast(Unsigned(), hn::Set(d, 2.0F * error));
        const auto any_uncertain = hn::Eq(hn::Min(nearest, uncertain), nearest);
        return kSides == Sides::certain || bits_of(Unsigned(), any_uncertain) == 0;
    }

    /// For each triangle of the vertices' leaf, which of the first `planes` it may intersect.
    HWY_INLINE ByteRows may_intersect(const Bvh8Leaf& leaf, std::size_t planes) const {
        return {may_intersect(leaf, planes, 0), may_intersect(leaf, planes, 1)};
    }

    /// For each lane, the vertices of a triangle arranged by a plane.
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
            c.certain =
                hn::And(hn::Or(sp, side(above_, p, plane)),
                        hn::And(hn::Or(sq, side(above_, q, plane)), hn::Or(sr, side(above_, r, plane))));
        } else {
            c.certain = hn::Set(d, 0xFF);
        }
        return c;
    }

private:
    /// Two vectors at a time, so that a vertex is loaded once for both.
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

    /// The planes from c on. Returns the least of `nearest` and the distances.
    ///
    /// Planes are moved up by `error`, so that a negative distance is certainly below, and one up to twice
    /// `error` is uncertain. As unsigned numbers, negative distances are the greatest: the least of all tells
    /// whether any is uncertain.
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
        const auto classify = [&](std::size_t v) {
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
        // In fours: the number of vertices varies, and a mispredicted branch costs more than classifying a
        // vertex again (unused slots repeat the last one, see Bvh8Leaf).
        for (std::size_t v = 0; v < count; v += 4) {
            classify(v);
            classify(v + 1);
            classify(v + 2);
            classify(v + 3);
        }
        return nearest;
    }

    HWY_INLINE void record_above(std::size_t vertex, std::uint32_t bits, std::size_t c) {
        if constexpr (kSides == Sides::certain) {
            record(above_, vertex, bits, c);
        }
    }

    HWY_INLINE Bytes may_intersect(const Bvh8Leaf& leaf, std::size_t planes, std::size_t half) const {
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
        const auto there = hn::Lt(hn::Iota(d, 0), hn::Set(d, leaf.triangle_count));
        const auto mask = static_cast<std::uint8_t>(((1U << planes) - 1U) >> (8 * half));
        return hn::IfThenElseZero(there, hn::AndNot(clear, hn::Set(d, mask)));
    }

    /// For each lane, all bits if the vertex is on that side of the plane.
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

/// Sets bit j of row i to bit i of `columns`' row j; sixteen bits per row, rows 0 to 7 and 8 to 15.
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

#if defined(CAMPUSWALK_COLLISION_KERNELS_LEAF_PAIR_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAMPUSWALK_COLLISION_KERNELS_LEAF_PAIR_INL_H
#undef CAMPUSWALK_COLLISION_KERNELS_LEAF_PAIR_INL_H
#else
#define CAMPUSWALK_COLLISION_KERNELS_LEAF_PAIR_INL_H
#endif

#include <algorithm>
#include <bit>

#include "collision/kernels/lanes_inl.h"
#include "collision/kernels/plane_sides_inl.h"
#include "collision/kernels/relative_pose_inl.h"
#include "collision/triangle_overlap.h"

HWY_BEFORE_NAMESPACE();
namespace campuswalk::collision {
namespace HWY_NAMESPACE {

/// Corners of a leaf, by axis.
using CornerTable = float[3][kLeafCorners];

/// Finds the overlapping triangles of two leaves, up to sixteen a leaf, about the origin of a's.
///
/// A leaf's triangles mostly lie side by side in a surface, and share corners: so all corners of one are held
/// against all planes of the other, both ways, before any triangle is held against any other. What is left is
/// settled by the two intervals of Guigue & Devillers 2003 in float32, and what rounding leaves open by the
/// exact predicate.
///
/// Rounding: a corner's difference from its origin is off by u r, its place beside the other leaf by 6 u L;
/// a plane's normal by 2 u and its offset by 4 u r. A corner's distance from a plane is thus off by at most
/// 25 u L: sides are certain beyond 32 u L, and two corners' distances along any direction of that length are
/// in order beyond as much.
class LeafPairs {
public:
    LeafPairs(const WidePair& pair, const RelativePose& pose, std::vector<TrianglePair>& out,
              QueryCounters& counters)
        : pair_(pair), pose_(pose), out_(out), counters_(counters) {}

    void find(const WideLeaf& a, const WideLeaf& b) {
        ++counters_.nu;
        float t[4];
        pose_.offset(a.origin, b.origin, t);
        const float error = pose_.bound(32.0F, a.radius + b.radius + length_of(t));
        if (!slabs_meet(a, b, t, error)) {
            return;
        }
        const Sight sight(pose_, a, b, t, error);
        // Signs alone settle nearly all pairs of leaves; where a corner is as good as on a plane, they don't.
        if (!find<Sides::signs>(sight)) {
            find<Sides::certain>(sight);
        }
    }

private:
    /// Two leaves, each in its own frame and in the other's.
    struct Sight {
        const WideLeaf& a;
        const WideLeaf& b;
        float error;
        HWY_ALIGN CornerTable b_in_a;
        HWY_ALIGN CornerTable a_in_b;

        HWY_INLINE Sight(const RelativePose& pose, const WideLeaf& leaf_a, const WideLeaf& leaf_b,
                         const float t[4], float bound)
            : a(leaf_a), b(leaf_b), error(bound) {
            const Floats d;
            for (std::size_t c = 0; c < b.corners; c += kLanes) {
                const Real3 p = load(b.corner, c);
                for (std::size_t k = 0; k < 3; ++k) {
                    Real v = hn::MulAdd(hn::Set(d, pose.column[0][k]), p.x, hn::Set(d, t[k]));
                    v = hn::MulAdd(hn::Set(d, pose.column[1][k]), p.y, v);
                    v = hn::MulAdd(hn::Set(d, pose.column[2][k]), p.z, v);
                    hn::Store(v, d, b_in_a[k] + c);
                }
            }
            for (std::size_t c = 0; c < a.corners; c += kLanes) {
                const Real3 p =
                    subtract(load(a.corner, c), {hn::Set(d, t[0]), hn::Set(d, t[1]), hn::Set(d, t[2])});
                for (std::size_t k = 0; k < 3; ++k) {
                    Real v = hn::Mul(hn::Set(d, pose.column[k][0]), p.x);
                    v = hn::MulAdd(hn::Set(d, pose.column[k][1]), p.y, v);
                    v = hn::MulAdd(hn::Set(d, pose.column[k][2]), p.z, v);
                    hn::Store(v, d, a_in_b[k] + c);
                }
            }
        }
    };

    /// Open pairs: bit j of row i, sixteen bits a row, is triangle i of a and j of b.
    struct OpenPairs {
        HWY_ALIGN std::uint64_t rows[4];

        HWY_INLINE std::size_t count() const {
            std::size_t sum = 0;
            for (const std::uint64_t word : rows) {
                sum += static_cast<std::size_t>(std::popcount(word));
            }
            return sum;
        }
        HWY_INLINE std::uint64_t row(std::size_t i) const { return rows[i / 4] >> (16 * (i % 4)) & 0xFFFFU; }
        HWY_INLINE void keep(std::size_t i, std::uint64_t which) {
            const std::size_t place = 16 * (i % 4);
            rows[i / 4] &= which << place | ~(0xFFFFULL << place);
        }
    };

    template <class Table>
    static HWY_INLINE Real3 load(const Table& corners, std::size_t c) {
        const Floats d;
        return {hn::Load(d, &corners[0][c]), hn::Load(d, &corners[1][c]), hn::Load(d, &corners[2][c])};
    }

    static HWY_INLINE Real along(const float direction[3], const Real3& p) {
        const Floats d;
        return dot({hn::Set(d, direction[0]), hn::Set(d, direction[1]), hn::Set(d, direction[2])}, p);
    }

    /// Whether corners lie neither all beyond `high` nor all before `low` along a direction.
    static HWY_INLINE bool reaches(const float direction[3], float low, float high, const WideLeaf& leaf) {
        const Floats d;
        std::uint32_t above = 0;
        std::uint32_t below = 0;
        for (std::size_t c = 0; c < leaf.corners; c += kLanes) {
            const Real f = along(direction, load(leaf.corner, c));
            above |= bits_of(d, hn::Gt(f, hn::Set(d, high))) << c;
            below |= bits_of(d, hn::Lt(f, hn::Set(d, low))) << c;
        }
        const std::uint32_t all = (1U << leaf.corners) - 1U;
        return (~above & all) != 0 && (~below & all) != 0;
    }

    /// Each leaf between two planes at right angles to its mean normal.
    HWY_INLINE bool slabs_meet(const WideLeaf& a, const WideLeaf& b, const float t[4], float error) const {
        float a_facing_in_b[3];
        float b_facing_in_a[3];
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& c = pose_.column;
            a_facing_in_b[k] = c[k][0] * a.facing[0] + c[k][1] * a.facing[1] + c[k][2] * a.facing[2];
            b_facing_in_a[k] = c[0][k] * b.facing[0] + c[1][k] * b.facing[1] + c[2][k] * b.facing[2];
        }
        const float shift_a = a.facing[0] * t[0] + a.facing[1] * t[1] + a.facing[2] * t[2];
        const float shift_b = b_facing_in_a[0] * t[0] + b_facing_in_a[1] * t[1] + b_facing_in_a[2] * t[2];
        const bool b_reaches_a = reaches(a_facing_in_b, a.low - shift_a - error, a.high - shift_a + error, b);
        const bool a_reaches_b = reaches(b_facing_in_a, b.low + shift_b - error, b.high + shift_b + error, a);
        // Either is as likely as not: one jump instead of two.
        return (static_cast<int>(b_reaches_a) & static_cast<int>(a_reaches_b)) != 0;
    }

    /// False if sides are in doubt that must not be.
    template <Sides kSides>
    HWY_INLINE bool find(const Sight& s) {
        SideTable<kSides> of_b;
        SideTable<kSides> of_a;
        const bool sure_b = of_b.fill(s.a, s.b_in_a, s.b.corners, s.error);
        const bool sure_a = of_a.fill(s.b, s.a_in_b, s.a.corners, s.error);
        if (!sure_a || !sure_b) {
            return false;
        }
        OpenPairs open;
        transpose(of_b.not_clear(s.b, s.a.triangles), open.rows);
        HWY_ALIGN std::uint64_t other[4];
        store_rows(of_a.not_clear(s.a, s.b.triangles), other);
        for (std::size_t w = 0; w < 4; ++w) {
            open.rows[w] &= other[w];
        }
        std::size_t count = open.count();
        // Fewer are settled as quickly as they are parted.
        constexpr std::size_t kFew = 8;
        if (count > kFew) {
            part_along_line(s, open);
            count = open.count();
        }
        if (count > 0) {
            settle<kSides>(s, of_a, of_b, open);
        }
        return true;
    }

    /// The span of each triangle along a line, from those of its corners.
    static HWY_INLINE void spans(const WideLeaf& leaf, const float corners[16], float margin, float low[16],
                                 float high[16]) {
        const Floats d;
        for (std::size_t c = 0; c < leaf.triangles; c += kLanes) {
            const Real p = pick(corners, indices(leaf.corner_of[0].data() + c));
            const Real q = pick(corners, indices(leaf.corner_of[1].data() + c));
            const Real r = pick(corners, indices(leaf.corner_of[2].data() + c));
            hn::Store(hn::Sub(hn::Min(p, hn::Min(q, r)), hn::Set(d, margin)), d, low + c);
            hn::Store(hn::Add(hn::Max(p, hn::Max(q, r)), hn::Set(d, margin)), d, high + c);
        }
    }

    /// Two surfaces cross along a line, and each triangle there straddles the planes of all others: what is
    /// left of those far from each other on the line is parted here. Any line would be right; that of the
    /// first open pair's planes parts most.
    HWY_INLINE void part_along_line(const Sight& s, OpenPairs& open) const {
        const Floats d;
        const hn::CappedTag<std::uint16_t, 16> d16;
        std::uint32_t live = 0;
        for (std::size_t c = 0; c < 16; c += hn::MaxLanes(d16)) {
            const auto rows = hn::Load(d16, reinterpret_cast<const std::uint16_t*>(open.rows) + c);
            live |= bits_of(d16, hn::Ne(rows, hn::Zero(d16))) << c;
        }
        const auto i = static_cast<std::size_t>(std::countr_zero(live));
        const auto j = static_cast<std::size_t>(std::countr_zero(open.row(i)));
        const float m[3] = {s.a.plane[0][i], s.a.plane[1][i], s.a.plane[2][i]};
        float n[3];
        for (std::size_t k = 0; k < 3; ++k) {
            n[k] = pose_.column[0][k] * s.b.plane[0][j] + pose_.column[1][k] * s.b.plane[1][j] +
                   pose_.column[2][k] * s.b.plane[2][j];
        }
        const float line[3] = {m[1] * n[2] - m[2] * n[1], m[2] * n[0] - m[0] * n[2],
                               m[0] * n[1] - m[1] * n[0]};
        HWY_ALIGN float corners_a[16];
        HWY_ALIGN float corners_b[16];
        for (std::size_t c = 0; c < s.a.corners; c += kLanes) {
            hn::Store(along(line, load(s.a.corner, c)), d, corners_a + c);
        }
        for (std::size_t c = 0; c < s.b.corners; c += kLanes) {
            hn::Store(along(line, load(s.b_in_a, c)), d, corners_b + c);
        }
        HWY_ALIGN float low_a[16];
        HWY_ALIGN float high_a[16];
        HWY_ALIGN float low_b[16];
        HWY_ALIGN float high_b[16];
        spans(s.a, corners_a, 0.0F, low_a, high_a);
        spans(s.b, corners_b, s.error, low_b, high_b);
        for (; live != 0; live &= live - 1) {
            const auto at = static_cast<std::size_t>(std::countr_zero(live));
            const Real low = hn::Set(d, low_a[at]);
            const Real high = hn::Set(d, high_a[at]);
            std::uint64_t near = 0;
            for (std::size_t c = 0; c < s.b.triangles; c += kLanes) {
                near |= static_cast<std::uint64_t>(bits_of(d, hn::And(hn::Le(low, hn::Load(d, high_b + c)),
                                                                      hn::Ge(high, hn::Load(d, low_b + c)))))
                        << c;
            }
            open.keep(at, near);
        }
    }

    /// Six times the volume of three edges, and the most that rounding can have added to it. The edges'
    /// coordinates are off by `error` at most, and by u of themselves: six products of three move by no more
    /// than 6 error (AB + MA + MB), lengths taken with the error on them, and round by 54 u MAB.
    struct Volume {
        Real value;
        Real doubt;

        HWY_INLINE Volume(const Real3& m, const Real3& u, const Real3& v, Real error) {
            const Floats d;
            value = dot(m, cross(u, v));
            const Real M = hn::Add(largest(m), error);
            const Real A = hn::Add(largest(u), error);
            const Real B = hn::Add(largest(v), error);
            const Real AB = hn::Mul(A, B);
            doubt = hn::MulAdd(hn::Mul(hn::Set(d, 64.0F * kFloatUnit), M), AB,
                               hn::MulAdd(hn::Mul(hn::Set(d, 8.0F), error), hn::MulAdd(M, hn::Add(A, B), AB),
                                          hn::Set(d, 0x1p-120F)));
        }
    };

    /// Settles the open pairs, sixteen at a time, and adds those that overlap to the result.
    template <Sides kSides>
    HWY_INLINE void settle(const Sight& s, const SideTable<kSides>& of_a, const SideTable<kSides>& of_b,
                           const OpenPairs& open) {
        HWY_ALIGN std::uint8_t ij[16 * 16 + 16];
        std::size_t count = 0;
        for (std::size_t w = 0; w < 4; ++w) {
            for (std::uint64_t m = open.rows[w]; m != 0; m &= m - 1) {
                ij[count++] =
                    static_cast<std::uint8_t>(64 * w + static_cast<std::size_t>(std::countr_zero(m)));
            }
        }
        counters_.np += count;
        const ByteTag d8;
        const hn::FixedTag<std::uint16_t, 8> d16;
        hn::StoreU(hn::Zero(d8), d8, ij + count);
        for (std::size_t first = 0; first < count; first += 16) {
            const Bytes at = hn::LoadU(d8, ij + first);
            const Bytes low_bits = hn::Set(d8, 15);
            const Bytes i = hn::And(hn::BitCast(d8, hn::ShiftRight<4>(hn::BitCast(d16, at))), low_bits);
            const Bytes j = hn::And(at, low_bits);
            ArrangedCorners a = of_a.arrange(s.a, i, j);
            ArrangedCorners b = of_b.arrange(s.b, j, i);
            // Seen from a lone corner below its plane, the other triangle turns the other way.
            a.turn_over(b.lone_below);
            b.turn_over(a.lone_below);
            const std::uint32_t sure = sign_bits(d8, hn::And(a.sure, b.sure));
            HWY_ALIGN std::uint8_t order[6][16];
            a.store(order);
            b.store(order + 3);
            const std::size_t here = std::min<std::size_t>(16, count - first);
            for (std::size_t c = 0; c < here; c += kLanes) {
                settle_lanes(s, order, c, sure >> c, ij + first + c, std::min(kLanes, here - c));
            }
        }
    }

    /// With p the lone corners and q, r turned alike, the edges pq and pr of one triangle pass those of the
    /// other on the right sides if and only if their intervals on the common line overlap.
    HWY_INLINE void settle_lanes(const Sight& s, const std::uint8_t order[6][16], std::size_t c,
                                 std::uint32_t sure, const std::uint8_t* ij, std::size_t lanes) {
        const Floats d;
        const auto of_a = [&](std::size_t k) {
            const Index at = indices(order[k] + c);
            return Real3{pick(s.a.corner[0].data(), at), pick(s.a.corner[1].data(), at),
                         pick(s.a.corner[2].data(), at)};
        };
        const auto of_b = [&](std::size_t k) {
            const Index at = indices(order[3 + k] + c);
            return Real3{pick(s.b_in_a[0], at), pick(s.b_in_a[1], at), pick(s.b_in_a[2], at)};
        };
        const Real error = hn::Set(d, s.error);
        const Real3 p = of_a(0);
        const Real3 m = subtract(of_b(0), p);
        const Volume first(m, subtract(of_a(1), p), subtract(of_b(1), p), error);
        const Volume second(m, subtract(of_b(2), p), subtract(of_a(2), p), error);
        const std::uint32_t apart = bits_of(d, hn::Or(hn::Lt(first.value, hn::Neg(first.doubt)),
                                                      hn::Lt(second.value, hn::Neg(second.doubt))));
        const std::uint32_t meet =
            bits_of(d, hn::And(hn::Gt(first.value, first.doubt), hn::Gt(second.value, second.doubt)));
        const std::uint32_t there = (1U << lanes) - 1U;
        const std::uint32_t open = there & (~sure | ~(apart | meet));
        for (std::uint32_t bits = open | (there & sure & meet); bits != 0; bits &= bits - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
            const TrianglePair pair{s.a.triangle[ij[lane] >> 4], s.b.triangle[ij[lane] & 15]};
            if ((open >> lane & 1U) == 0 || exactly_overlap(pair)) {
                out_.push_back(pair);
            }
        }
    }

    HWY_NOINLINE bool exactly_overlap(const TrianglePair& pair) const {
        const auto& t = pair_.mesh_b.triangles[pair.b];
        const auto corner = [&](std::size_t c) {
            return b_corner_in_a(pair_.X_a_b, pair_.mesh_b.positions[t[c]]);
        };
        return overlap(corners(pair_.mesh_a, pair.a), {corner(0), corner(1), corner(2)});
    }

    const WidePair& pair_;
    const RelativePose& pose_;
    std::vector<TrianglePair>& out_;
    QueryCounters& counters_;
};

}  // namespace HWY_NAMESPACE
}  // namespace campuswalk::collision
HWY_AFTER_NAMESPACE();

#endif

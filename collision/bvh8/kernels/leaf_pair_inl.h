#if defined(CAMPUSWALK_COLLISION_KERNELS_LEAF_PAIR_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAMPUSWALK_COLLISION_KERNELS_LEAF_PAIR_INL_H
#undef CAMPUSWALK_COLLISION_KERNELS_LEAF_PAIR_INL_H
#else
#define CAMPUSWALK_COLLISION_KERNELS_LEAF_PAIR_INL_H
#endif

#include <algorithm>
#include <bit>

#include "collision/bvh8/kernels/lanes_inl.h"
#include "collision/bvh8/kernels/open_pairs_inl.h"
#include "collision/bvh8/kernels/plane_sides_inl.h"
#include "collision/bvh8/kernels/relative_pose_inl.h"
#include "collision/geometry/triangle_overlap.h"

HWY_BEFORE_NAMESPACE();
namespace campuswalk::collision {
namespace HWY_NAMESPACE {

/// Vertices of a leaf, by axis.
using VertexTable = float[3][kLeafVertices];

/// Finds the overlapping triangles of two leaves, up to sixteen each, relative to the origin of a's.
///
/// A leaf's triangles are mostly neighbours in a surface and share vertices: so all vertices of one leaf are
/// tested against all planes of the other, both ways, before any triangle is tested against another. The
/// remaining pairs are decided by the two intervals of Guigue & Devillers 2003 in float32, and what rounding
/// leaves open by the exact predicate.
///
/// Rounding: a vertex's difference from its origin is off by u r, its position relative to the other leaf by
/// 6 u L; a plane's normal by 2 u and its offset by 5 u r. A vertex's distance from a plane is thus off by at
/// most 26 u L: sides are certain beyond 32 u L, and so is the order of two vertices' distances along a
/// direction of length 1.
class LeafPairs {
public:
    LeafPairs(const Bvh8Pair& pair, const RelativePose& pose, std::vector<TrianglePair>& out,
              QueryStatistics& work)
        : pair_(pair), pose_(pose), out_(out), work_(work) {}

    void find(const Bvh8Leaf& a, const Bvh8Leaf& b) {
        ++work_.transform_updates;
        float t[4];
        pose_.offset(a.origin, b.origin, t);
        const float error = pose_.bound(32.0F, a.radius + b.radius + length_of(t));
        if (!slabs_overlap(a, b, t, error)) {
            return;
        }
        const PosedLeaves leaves(pose_, a, b, t, error);
        // Signs suffice for nearly all pairs of leaves; not if a vertex is almost on a plane.
        if (!find<Sides::signs>(leaves)) {
            find<Sides::certain>(leaves);
        }
    }

private:
    /// Four lanes load a vertex's coordinates at once and transpose them; more lanes pick them from tables,
    /// one axis at a time.
    static constexpr bool kByPoint = kLanes == 4;
    using PointTable = float[kByPoint ? kLeafVertices : 1][4];

    template <class Table>
    static HWY_INLINE Real3 load(const Table& vertices, std::size_t c) {
        const Floats d;
        return {hn::Load(d, &vertices[0][c]), hn::Load(d, &vertices[1][c]), hn::Load(d, &vertices[2][c])};
    }

    static HWY_INLINE void store_points(const Real3& p, PointTable& points, std::size_t c) {
        const Floats d;
        hn::StoreInterleaved4(p.x, p.y, p.z, p.z, d, points[c]);
    }

    /// The vertices at `index`, one per lane.
    template <class Table>
    static HWY_INLINE Real3 fetch(const Table& vertices, const PointTable& points,
                                  const std::uint8_t* index) {
        const Floats d;
        if constexpr (kByPoint) {
            const hn::RepartitionToWide<Floats> d2;
            const Real p0 = hn::Load(d, points[index[0]]);
            const Real p1 = hn::Load(d, points[index[1]]);
            const Real p2 = hn::Load(d, points[index[2]]);
            const Real p3 = hn::Load(d, points[index[3]]);
            const auto xy01 = hn::BitCast(d2, hn::InterleaveLower(d, p0, p1));
            const auto xy23 = hn::BitCast(d2, hn::InterleaveLower(d, p2, p3));
            const auto z01 = hn::BitCast(d2, hn::InterleaveUpper(d, p0, p1));
            const auto z23 = hn::BitCast(d2, hn::InterleaveUpper(d, p2, p3));
            return {hn::BitCast(d, hn::ConcatLowerLower(d2, xy23, xy01)),
                    hn::BitCast(d, hn::ConcatUpperUpper(d2, xy23, xy01)),
                    hn::BitCast(d, hn::ConcatLowerLower(d2, z23, z01))};
        } else {
            return {pick(d, &vertices[0][0], index), pick(d, &vertices[1][0], index),
                    pick(d, &vertices[2][0], index)};
        }
    }

    /// Two leaves, each in its own frame and in the other's.
    struct PosedLeaves {
        const Bvh8Leaf& a;
        const Bvh8Leaf& b;
        float error;
        /// The greatest error of the volume of any three edges within and between the two (see
        /// `volume_error`).
        float max_volume_error;
        HWY_ALIGN VertexTable b_in_a;
        HWY_ALIGN VertexTable a_in_b;
        /// By vertex, if they are fetched like that.
        HWY_ALIGN PointTable a_points;
        HWY_ALIGN PointTable b_points;

        HWY_INLINE PosedLeaves(const RelativePose& pose, const Bvh8Leaf& leaf_a, const Bvh8Leaf& leaf_b,
                               const float t[4], float bound)
            : a(leaf_a),
              b(leaf_b),
              error(bound),
              max_volume_error(greatest_volume_error(leaf_a.radius, leaf_b.radius, length_of(t), bound)) {
            const Floats d;
            for (std::size_t c = 0; c < b.vertex_count; c += kLanes) {
                const Real3 p = load(b.vertex, c);
                for (std::size_t k = 0; k < 3; ++k) {
                    Real v = hn::MulAdd(hn::Set(d, pose.column[0][k]), p.x, hn::Set(d, t[k]));
                    v = hn::MulAdd(hn::Set(d, pose.column[1][k]), p.y, v);
                    v = hn::MulAdd(hn::Set(d, pose.column[2][k]), p.z, v);
                    hn::Store(v, d, b_in_a[k] + c);
                }
                if constexpr (kByPoint) {
                    store_points(load(b_in_a, c), b_points, c);
                }
            }
            for (std::size_t c = 0; c < a.vertex_count; c += kLanes) {
                const Real3 p =
                    subtract(load(a.vertex, c), {hn::Set(d, t[0]), hn::Set(d, t[1]), hn::Set(d, t[2])});
                for (std::size_t k = 0; k < 3; ++k) {
                    Real v = hn::Mul(hn::Set(d, pose.column[k][0]), p.x);
                    v = hn::MulAdd(hn::Set(d, pose.column[k][1]), p.y, v);
                    v = hn::MulAdd(hn::Set(d, pose.column[k][2]), p.z, v);
                    hn::Store(v, d, a_in_b[k] + c);
                }
                if constexpr (kByPoint) {
                    store_points(load(a.vertex, c), a_points, c);
                }
            }
        }
    };

    static HWY_INLINE Real along(const float direction[3], const Real3& p) {
        const Floats d;
        return dot({hn::Set(d, direction[0]), hn::Set(d, direction[1]), hn::Set(d, direction[2])}, p);
    }

    /// Whether the leaf's vertices are neither all above `high` nor all below `low` along a direction.
    static HWY_INLINE bool reaches(const float direction[3], float low, float high, const Bvh8Leaf& leaf) {
        const Floats d;
        Real least = along(direction, load(leaf.vertex, 0));
        Real most = least;
        for (std::size_t c = kLanes; c < kLeafVertices; c += kLanes) {
            const Real f = along(direction, load(leaf.vertex, c));
            least = hn::Min(least, f);
            most = hn::Max(most, f);
        }
        const std::uint32_t some_below = bits_of(d, hn::Le(least, hn::Set(d, high)));
        const std::uint32_t some_above = bits_of(d, hn::Ge(most, hn::Set(d, low)));
        // No branch: see slabs_overlap.
        return (static_cast<int>(some_below != 0) & static_cast<int>(some_above != 0)) != 0;
    }

    /// Tests each leaf against the other's slab, perpendicular to its mean normal.
    HWY_INLINE bool slabs_overlap(const Bvh8Leaf& a, const Bvh8Leaf& b, const float t[4], float error) const {
        HWY_ALIGN float a_facing_in_b[4];
        HWY_ALIGN float b_facing_in_a[4];
        rotate(pose_.row, a.facing.data(), a_facing_in_b);
        rotate(pose_.column, b.facing.data(), b_facing_in_a);
        const float shift_a = a.facing[0] * t[0] + a.facing[1] * t[1] + a.facing[2] * t[2];
        const float shift_b = b_facing_in_a[0] * t[0] + b_facing_in_a[1] * t[1] + b_facing_in_a[2] * t[2];
        const bool b_reaches_a = reaches(a_facing_in_b, a.low - shift_a - error, a.high - shift_a + error, b);
        const bool a_reaches_b = reaches(b_facing_in_a, b.low + shift_b - error, b.high + shift_b + error, a);
        // Neither is predictable: one branch instead of two.
        return (static_cast<int>(b_reaches_a) & static_cast<int>(a_reaches_b)) != 0;
    }

    /// False if sides are uncertain that must be certain.
    template <Sides kSides>
    HWY_INLINE bool find(const PosedLeaves& s) {
        SideTable<kSides> of_b;
        SideTable<kSides> of_a;
        const bool certain_b = of_b.fill(s.a, s.b_in_a, s.b.vertex_count, s.error);
        const bool certain_a = of_a.fill(s.b, s.a_in_b, s.a.vertex_count, s.error);
        if (!certain_a || !certain_b) {
            return false;
        }
        OpenPairs open(of_b.may_intersect(s.b, s.a.triangle_count),
                       of_a.may_intersect(s.a, s.b.triangle_count));
        std::size_t count = open.count();
        // So few are decided at once, as quickly as they would be separated along the line.
        constexpr std::size_t kAtOnce = 16;
        if (count > kAtOnce) {
            separate_along_line(s, open);
            count = open.count();
        }
        if (count > 0) {
            decide<kSides>(s, of_a, of_b, open);
        }
        return true;
    }

    /// The span of each triangle along a line, from the positions of its vertices.
    static HWY_INLINE void spans(const Bvh8Leaf& leaf, const float vertices[16], float margin, float low[16],
                                 float high[16]) {
        const Floats d;
        for (std::size_t c = 0; c < leaf.triangle_count; c += kLanes) {
            const Real p = pick(d, vertices, leaf.vertex_of[0].data() + c);
            const Real q = pick(d, vertices, leaf.vertex_of[1].data() + c);
            const Real r = pick(d, vertices, leaf.vertex_of[2].data() + c);
            hn::Store(hn::Sub(hn::Min(p, hn::Min(q, r)), hn::Set(d, margin)), d, low + c);
            hn::Store(hn::Add(hn::Max(p, hn::Max(q, r)), hn::Set(d, margin)), d, high + c);
        }
    }

    /// Two surfaces intersect along a line, where each triangle straddles the planes of all others: separates
    /// pairs that are far from each other along it. Any line would be correct; that of the first open pair's
    /// planes separates most.
    HWY_INLINE void separate_along_line(const PosedLeaves& s, OpenPairs& open) const {
        const Floats d;
        std::uint32_t live = open.live_rows();
        const auto i = static_cast<std::size_t>(std::countr_zero(live));
        const auto j = static_cast<std::size_t>(std::countr_zero(open.rows[i]));
        const float m[3] = {s.a.plane[0][i], s.a.plane[1][i], s.a.plane[2][i]};
        const float m_b[3] = {s.b.plane[0][j], s.b.plane[1][j], s.b.plane[2][j]};
        HWY_ALIGN float n[4];
        rotate(pose_.column, m_b, n);
        const float line[3] = {m[1] * n[2] - m[2] * n[1], m[2] * n[0] - m[0] * n[2],
                               m[0] * n[1] - m[1] * n[0]};
        HWY_ALIGN float vertices_a[16];
        HWY_ALIGN float vertices_b[16];
        for (std::size_t c = 0; c < s.a.vertex_count; c += kLanes) {
            hn::Store(along(line, load(s.a.vertex, c)), d, vertices_a + c);
        }
        for (std::size_t c = 0; c < s.b.vertex_count; c += kLanes) {
            hn::Store(along(line, load(s.b_in_a, c)), d, vertices_b + c);
        }
        HWY_ALIGN float low_a[16];
        HWY_ALIGN float high_a[16];
        HWY_ALIGN float low_b[16];
        HWY_ALIGN float high_b[16];
        spans(s.a, vertices_a, 0.0F, low_a, high_a);
        spans(s.b, vertices_b, s.error, low_b, high_b);
        for (; live != 0; live &= live - 1) {
            const auto at = static_cast<std::size_t>(std::countr_zero(live));
            const Real low = hn::Set(d, low_a[at]);
            const Real high = hn::Set(d, high_a[at]);
            std::uint32_t overlapping = 0;
            for (std::size_t c = 0; c < s.b.triangle_count; c += kLanes) {
                overlapping |= bits_of(d, hn::And(hn::Le(low, hn::Load(d, high_b + c)),
                                                  hn::Ge(high, hn::Load(d, low_b + c))))
                               << c;
            }
            open.rows[at] = static_cast<std::uint16_t>(open.rows[at] & overlapping);
        }
    }

    /// The greatest error of m . (u x v) for three edges with coordinates up to M, A and B. They are off by
    /// at most `error`, and by u of themselves: six products of three move by at most 6 error (AB + MA + MB),
    /// with lengths that include the error, and round by 54 u MAB.
    static HWY_INLINE Real volume_error(Real M, Real A, Real B, Real error) {
        const Floats d;
        M = hn::Add(M, error);
        A = hn::Add(A, error);
        B = hn::Add(B, error);
        const Real AB = hn::Mul(A, B);
        return hn::MulAdd(hn::Mul(hn::Set(d, 64.0F * kFloatUnit), M), AB,
                          hn::MulAdd(hn::Mul(hn::Set(d, 8.0F), error), hn::MulAdd(M, hn::Add(A, B), AB),
                                     hn::Set(d, 0x1p-120F)));
    }

    /// For any edges within two leaves and between them.
    static HWY_INLINE float greatest_volume_error(float radius_a, float radius_b, float apart, float error) {
        const Floats d;
        return hn::GetLane(volume_error(hn::Set(d, radius_a + radius_b + apart), hn::Set(d, 2.0F * radius_a),
                                        hn::Set(d, 2.0F * radius_b), hn::Set(d, error)));
    }

    /// Three edges from one vertex, in every lane.
    struct Edges {
        Real3 m, u, v;

        /// Six times their volume.
        HWY_INLINE Real volume() const { return dot(m, cross(u, v)); }
        HWY_INLINE Real volume_error(Real error) const {
            return LeafPairs::volume_error(largest(m), largest(u), largest(v), error);
        }
    };

    /// What two volumes imply for the triangles, one bit per lane; neither where a volume is uncertain.
    struct Verdict {
        std::uint32_t apart;
        std::uint32_t overlapping;

        HWY_INLINE Verdict(Real first, Real first_error, Real second, Real second_error) {
            const Floats d;
            apart = bits_of(
                d, hn::Or(hn::Lt(first, hn::Neg(first_error)), hn::Lt(second, hn::Neg(second_error))));
            overlapping = bits_of(d, hn::And(hn::Gt(first, first_error), hn::Gt(second, second_error)));
        }
    };

    /// Decides the open pairs, sixteen at a time, and adds those that overlap to the result.
    template <Sides kSides>
    HWY_INLINE void decide(const PosedLeaves& s, const SideTable<kSides>& of_a, const SideTable<kSides>& of_b,
                           const OpenPairs& open) {
        PairList pairs;
        pairs.add_all(open);
        const std::size_t count = pairs.size();
        work_.primitive_tests += count;
        PairList found;
        const ByteTag d8;
        const hn::FixedTag<std::uint16_t, 8> d16;
        for (std::size_t first = 0; first < count; first += 16) {
            const Bytes at = hn::LoadU(d8, pairs + first);
            const Bytes low_bits = hn::Set(d8, 15);
            const Bytes i = hn::And(hn::BitCast(d8, hn::ShiftRight<4>(hn::BitCast(d16, at))), low_bits);
            const Bytes j = hn::And(at, low_bits);
            ArrangedVertices a = of_a.arrange(s.a, i, j);
            ArrangedVertices b = of_b.arrange(s.b, j, i);
            // Seen from a lone vertex below its plane, the other triangle has the opposite winding.
            a.flip(b.lone_below);
            b.flip(a.lone_below);
            const std::uint32_t certain = sign_bits(d8, hn::And(a.certain, b.certain));
            HWY_ALIGN std::uint8_t order[6][16];
            a.store(order);
            b.store(order + 3);
            const std::size_t lanes = std::min<std::size_t>(16, count - first);
            for (std::size_t c = 0; c < lanes; c += kLanes) {
                const std::uint8_t* ij = pairs + first + c;
                const std::uint32_t overlapping =
                    decide_lanes(s, order, c, certain >> c, ij, std::min(kLanes, lanes - c));
                found.add_some(ij, overlapping);
            }
        }
        for (std::size_t k = 0; k < found.size(); ++k) {
            out_.push_back(pair_of(s, (found + k)[0]));
        }
    }

    static HWY_INLINE TrianglePair pair_of(const PosedLeaves& s, std::uint8_t ij) {
        return {s.a.triangle[ij >> 4], s.b.triangle[ij & 15]};
    }

    /// Which pairs overlap, one bit per lane.
    ///
    /// With p the lone vertices and q, r in the same winding, the edges pq and pr of one triangle pass those
    /// of the other on the proper sides if and only if their intervals on the common line overlap.
    HWY_INLINE std::uint32_t decide_lanes(const PosedLeaves& s, const std::uint8_t order[6][16],
                                          std::size_t c, std::uint32_t certain, const std::uint8_t* ij,
                                          std::size_t lanes) {
        const Floats d;
        const auto of_a = [&](std::size_t k) { return fetch(s.a.vertex, s.a_points, order[k] + c); };
        const auto of_b = [&](std::size_t k) { return fetch(s.b_in_a, s.b_points, order[3 + k] + c); };
        const Real3 p = of_a(0);
        const Real3 m = subtract(of_b(0), p);
        const Edges first{m, subtract(of_a(1), p), subtract(of_b(1), p)};
        const Edges second{m, subtract(of_b(2), p), subtract(of_a(2), p)};
        const Real first_volume = first.volume();
        const Real second_volume = second.volume();
        const Real max_error = hn::Set(d, s.max_volume_error);
        const std::uint32_t valid = (1U << lanes) - 1U;
        Verdict verdict(first_volume, max_error, second_volume, max_error);
        if (HWY_UNLIKELY((valid & certain & ~(verdict.apart | verdict.overlapping)) != 0)) {
            const Real error = hn::Set(d, s.error);
            verdict =
                Verdict(first_volume, first.volume_error(error), second_volume, second.volume_error(error));
        }
        std::uint32_t overlapping = valid & certain & verdict.overlapping;
        const std::uint32_t open = valid & (~certain | ~(verdict.apart | verdict.overlapping));
        for (std::uint32_t bits = open; HWY_UNLIKELY(bits != 0); bits &= bits - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
            if (exactly_overlap(pair_of(s, ij[lane]))) {
                overlapping |= 1U << lane;
            }
        }
        return overlapping;
    }

    HWY_NOINLINE bool exactly_overlap(const TrianglePair& pair) const {
        const auto& t = pair_.mesh_b.triangles[pair.b];
        const auto vertex = [&](std::size_t c) {
            return b_vertex_in_a(pair_.X_a_b, pair_.mesh_b.positions[t[c]]);
        };
        return overlap(vertices(pair_.mesh_a, pair.a), {vertex(0), vertex(1), vertex(2)});
    }

    const Bvh8Pair& pair_;
    const RelativePose& pose_;
    std::vector<TrianglePair>& out_;
    QueryStatistics& work_;
};

}  // namespace HWY_NAMESPACE
}  // namespace campuswalk::collision
HWY_AFTER_NAMESPACE();

#endif

#if defined(CAMPUSWALK_COLLISION_KERNELS_RAY_NODE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAMPUSWALK_COLLISION_KERNELS_RAY_NODE_INL_H
#undef CAMPUSWALK_COLLISION_KERNELS_RAY_NODE_INL_H
#else
#define CAMPUSWALK_COLLISION_KERNELS_RAY_NODE_INL_H
#endif

#include <cmath>
#include <limits>

#include "collision/bvh8/bvh8.h"
#include "collision/bvh8/kernels/lanes_inl.h"
#include "collision/geometry/ray.h"

HWY_BEFORE_NAMESPACE();
namespace campuswalk::collision {
namespace HWY_NAMESPACE {

// No multiply-add here nor in ray_leaf_inl.h: with the same distances on all instruction sets, the traversal
// and its statistics are the same.

/// At most 256 bits: a ray has too little work to make up for the lower clock rate of 512.
using RayTag = hn::CappedTag<float, 8>;
using RayReal = hn::Vec<RayTag>;
inline constexpr std::size_t kRayLanes = hn::MaxLanes(RayTag());

/// A ray prepared for all nodes. Positions on it are distances along the axis along which it is longest:
/// `far` at its end.
struct PreparedRay {
    HWY_ALIGN double from[4] = {};
    HWY_ALIGN float along[4] = {};    ///< the farthest component is 1 or -1
    HWY_ALIGN float inverse[4] = {};  ///< see inverse_of, of `along`
    double far = 0.0;

    explicit PreparedRay(const Ray& ray) {
        const Vec3 d = ray.to - ray.from;
        far = d.cwiseAbs().maxCoeff();
        for (std::size_t k = 0; k < 3; ++k) {
            const auto axis = static_cast<Eigen::Index>(k);
            from[k] = ray.from[axis];
            along[k] = static_cast<float>(d[axis] / far);
        }
        const hn::FixedTag<float, 4> d4;
        hn::Store(inverse_of(hn::Load(d4, along)), d4, inverse);
    }

    /// A step that rounding can't distinguish from 0 is replaced by one to divide by.
    template <class V>
    static HWY_INLINE V inverse_of(V step) {
        const hn::FixedTag<float, 4> d;
        return hn::Div(hn::Set(d, 1.0F), hn::CopySign(hn::Max(hn::Abs(step), hn::Set(d, kFloatUnit)), step));
    }

    /// The greatest distance of a fraction up to `limit`. Covers 4 roundings, here and in `along`.
    float reach(double limit) const {
        return static_cast<float>(limit * far) * (1.0F + 8.0F * kFloatUnit) + 0x1p-120F;
    }

    /// `from` less o, in float32; the fourth entry is 0.
    HWY_INLINE void offset(const std::array<float, 4>& o, float out[4]) const {
        const hn::CappedTag<double, 4> d;
        const hn::Rebind<float, decltype(d)> narrow;
        for (std::size_t k = 0; k < 4; k += hn::MaxLanes(d)) {
            const auto origin = hn::PromoteTo(d, hn::LoadU(narrow, o.data() + k));
            hn::StoreU(hn::DemoteTo(narrow, hn::Sub(hn::Load(d, from + k), origin)), narrow, out + k);
        }
    }
};

/// The sum of the columns of a node's axes, weighted by v; the fourth entry is 0.
HWY_INLINE hn::Vec<hn::FixedTag<float, 4>> rotated(const Bvh8Node& node, const float v[4]) {
    const hn::FixedTag<float, 4> d;
    const auto part = [&](std::size_t k) {
        return hn::Mul(hn::Load(d, node.axes[k].data()), hn::Set(d, v[k]));
    };
    return hn::Add(part(0), hn::Add(part(1), part(2)));
}

/// Bit i: the ray may hit child i before `reach`; `entry` is a lower bound of the distance.
///
/// Rounding, in units u = kFloatUnit and lengths S = |offset| + radius, which no compared length exceeds: a
/// ray that hits a box at distance t has gone no farther than S, so that t |along| <= S. Along each axis of
/// the frame,
///  - the offset is rounded (1), and rotated by three products and their sum (3): 4 u S;
///  - so is `along`, by 4 u |along|, which moves the ray by 4 u S before it hits the box;
///  - a step that is replaced (see inverse_of) moves it by 2 u S;
///  - the inverse 1, the difference of positions 1 and its product 1, the half's sum 1 and its product 1, the
///    last sum 1: 6 u S.
/// That is 16 u S; second orders, S's own rounding and what `hit` rounds in double are less than 1 u S, and
/// 24 are added to each box. 2^-120 covers underflow.
HWY_INLINE std::uint32_t children_on_ray(const PreparedRay& ray, const Bvh8Node& node, float reach,
                                         float entry[kBvh8Children]) {
    HWY_ALIGN float from[4];
    ray.offset(node.origin, from);
    const float size = (std::abs(from[0]) + std::abs(from[1])) + (std::abs(from[2]) + node.radius);
    const float* inverse = ray.inverse;
    HWY_ALIGN float rotated_inverse[4];
    if (node.rotated) {
        const hn::FixedTag<float, 4> d4;
        hn::Store(PreparedRay::inverse_of(rotated(node, ray.along)), d4, rotated_inverse);
        hn::Store(rotated(node, from), d4, from);
        inverse = rotated_inverse;
    }
    const RayTag d;
    const RayReal slack = hn::Set(d, 24.0F * kFloatUnit * size + 0x1p-120F);
    std::uint32_t on_ray = 0;
    for (std::size_t c = 0; c < kBvh8Children; c += kRayLanes) {
        RayReal enter = hn::Zero(d);
        RayReal leave = hn::Set(d, reach);
        for (std::size_t k = 0; k < 3; ++k) {
            const RayReal per = hn::Set(d, inverse[k]);
            const RayReal center = hn::Sub(hn::Load(d, node.center[k].data() + c), hn::Set(d, from[k]));
            const RayReal half = hn::Add(hn::Load(d, node.half[k].data() + c), slack);
            const RayReal middle = hn::Mul(center, per);
            const RayReal around = hn::Mul(half, hn::Abs(per));
            enter = hn::Max(enter, hn::Sub(middle, around));
            leave = hn::Min(leave, hn::Add(middle, around));
        }
        hn::Store(hn::Abs(enter), d, entry + c);  // because it may be -0
        on_ray |= bits_of(d, hn::Le(enter, leave)) << c;
    }
    return on_ray & ((1U << node.count) - 1U);
}

}  // namespace HWY_NAMESPACE
}  // namespace campuswalk::collision
HWY_AFTER_NAMESPACE();

#endif

#if defined(CAMPUSWALK_COLLISION_KERNELS_RAY_LEAF_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAMPUSWALK_COLLISION_KERNELS_RAY_LEAF_INL_H
#undef CAMPUSWALK_COLLISION_KERNELS_RAY_LEAF_INL_H
#else
#define CAMPUSWALK_COLLISION_KERNELS_RAY_LEAF_INL_H
#endif

#include "collision/bvh8/kernels/ray_node_inl.h"

HWY_BEFORE_NAMESPACE();
namespace campuswalk::collision {
namespace HWY_NAMESPACE {

/// Shears a ray onto the axis along which it is longest, as `hit` (ray.h) does in double.
class Shear {
public:
    explicit Shear(const Ray& ray) : from_(ray.from) {
        const Vec3 d = ray.to - ray.from;
        Eigen::Index farthest = 0;
        d.cwiseAbs().maxCoeff(&farthest);
        z_ = static_cast<std::size_t>(farthest);
        x_ = (z_ + 1) % 3;
        y_ = (x_ + 1) % 3;
        slope_x_ = d[static_cast<Eigen::Index>(x_)] / d[farthest];
        slope_y_ = d[static_cast<Eigen::Index>(y_)] / d[farthest];
    }

    /// Bit i: `hit` may find a hit on triangle i of the leaf.
    ///
    /// Rounding, in units u = kFloatUnit. Vertices are relative to the point of the ray's line beside the
    /// leaf's origin, which is computed in double: a few 2^-53 of the offset. Vertices are rounded by u r for
    /// each coordinate, with r the leaf's radius; slopes are no steeper than 1. With p the larger coordinate
    /// of that point, the difference of positions is off by 2 u r + 2 u p, the product by 3 u r, their
    /// difference by u (2 r + p): each less than e = 8 u (r + p), where 2^-48 of the offset is added for what
    /// is done in double, here and by `hit`. No sheared coordinate is greater than m = 2 r + p + e. A
    /// triangle's edge u, v or w is a difference of two products of such coordinates: off by 4 e m + 2 e^2
    /// for the coordinates and 4 u m^2 for its own rounding; 5 of each are allowed, and 2^-120 for underflow.
    HWY_INLINE std::uint32_t triangles_on_ray(const Bvh8Leaf& leaf) const {
        const double z = offset(leaf, z_);
        const double x = offset(leaf, x_);
        const double y = offset(leaf, y_);
        const auto at_x = static_cast<float>(x - slope_x_ * z);
        const auto at_y = static_cast<float>(y - slope_y_ * z);
        const float p = std::max(std::abs(at_x), std::abs(at_y));
        const auto outside = static_cast<float>(0x1p-48 * (std::abs(x) + std::abs(y) + std::abs(z)));
        const float e = 8.0F * kFloatUnit * (leaf.radius + p) + outside;
        const float m = 2.0F * leaf.radius + p + e;
        const float error = 5.0F * (e * (m + e) + kFloatUnit * m * m) + 0x1p-120F;

        HWY_ALIGN float xs[kLeafVertices];
        HWY_ALIGN float ys[kLeafVertices];
        const RayTag d;
        for (std::size_t c = 0; c < kLeafVertices; c += kRayLanes) {
            const RayReal along = hn::Load(d, leaf.vertex[z_].data() + c);
            const auto sheared = [&](std::size_t axis, float at, double slope) {
                const RayReal place = hn::Sub(hn::Load(d, leaf.vertex[axis].data() + c), hn::Set(d, at));
                return hn::Sub(place, hn::Mul(hn::Set(d, static_cast<float>(slope)), along));
            };
            hn::Store(sheared(x_, at_x, slope_x_), d, xs + c);
            hn::Store(sheared(y_, at_y, slope_y_), d, ys + c);
        }
        std::uint32_t missed = 0;
        for (std::size_t t = 0; t < kLeafTriangles; t += kRayLanes) {
            const auto of = [&](const float* along, std::size_t vertex) {
                return pick(d, along, leaf.vertex_of[vertex].data() + t);
            };
            const RayReal ax = of(xs, 0), ay = of(ys, 0);
            const RayReal bx = of(xs, 1), by = of(ys, 1);
            const RayReal cx = of(xs, 2), cy = of(ys, 2);
            const RayReal u = hn::Sub(hn::Mul(cx, by), hn::Mul(cy, bx));
            const RayReal v = hn::Sub(hn::Mul(ax, cy), hn::Mul(ay, cx));
            const RayReal w = hn::Sub(hn::Mul(bx, ay), hn::Mul(by, ax));
            const auto left = hn::Lt(hn::Min(u, hn::Min(v, w)), hn::Set(d, -error));
            const auto right = hn::Gt(hn::Max(u, hn::Max(v, w)), hn::Set(d, error));
            missed |= bits_of(d, hn::And(left, right)) << t;
        }
        return ~missed & ((1U << leaf.triangle_count) - 1U);
    }

private:
    HWY_INLINE double offset(const Bvh8Leaf& leaf, std::size_t axis) const {
        return from_[static_cast<Eigen::Index>(axis)] - static_cast<double>(leaf.origin[axis]);
    }

    Vec3 from_;
    std::size_t x_ = 0;
    std::size_t y_ = 0;
    std::size_t z_ = 0;
    double slope_x_ = 0.0;
    double slope_y_ = 0.0;
};

}  // namespace HWY_NAMESPACE
}  // namespace campuswalk::collision
HWY_AFTER_NAMESPACE();

#endif

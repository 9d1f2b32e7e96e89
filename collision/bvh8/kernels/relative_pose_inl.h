#if defined(CAMPUSWALK_COLLISION_KERNELS_RELATIVE_POSE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAMPUSWALK_COLLISION_KERNELS_RELATIVE_POSE_INL_H
#undef CAMPUSWALK_COLLISION_KERNELS_RELATIVE_POSE_INL_H
#else
#define CAMPUSWALK_COLLISION_KERNELS_RELATIVE_POSE_INL_H
#endif

#include <array>
#include <cmath>

#include "collision/bvh8/kernels/bvh8_contacts.h"
#include "collision/bvh8/kernels/lanes_inl.h"

HWY_BEFORE_NAMESPACE();
namespace campuswalk::collision {
namespace HWY_NAMESPACE {

/// The pose of b in a's frame, prepared for float32 about any two origins: the large part of a position is
/// subtracted in double, and the rest is as small as the parts that are compared.
///
/// Bounds below are in units u = kFloatUnit and lengths L = r_a + r_b + |offset|, where r is a part's radius,
/// plus two terms:
/// - `coordinates`: the reference itself (b_vertex_in_a) and `offset` are each rounded in double, by at most
///   4 x 2^-53 times the coordinates' sum along each axis; 2^-49 times that sum is more than both.
/// - `tilt`: transforming to b by the transposed matrix instead of the inverse is off by at most 3 L times
///   the matrix' distance from a rotation.
class RelativePose {
public:
    explicit RelativePose(const Bvh8Pair& pair) {
        for (std::size_t j = 0; j < 3; ++j) {
            for (std::size_t i = 0; i < 3; ++i) {
                rotation_[j][i] =
                    pair.X_a_b.rotation(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
                column[j][i] = static_cast<float>(rotation_[j][i]);
                row[i][j] = column[j][i];
            }
            translation_[j] = pair.X_a_b.translation[static_cast<Eigen::Index>(j)];
        }
        const double sum = static_cast<double>(pair.a.reach) + 3.0 * static_cast<double>(pair.b.reach) +
                           pair.X_a_b.translation.cwiseAbs().maxCoeff();
        coordinates_ = static_cast<float>(sum * 0x1p-48);
        tilt_ = static_cast<float>(4.0 * pair.tilt);
    }

    /// R o_b + t - o_a; the fourth entry is 0.
    template <class Arithmetic = Fused>
    HWY_INLINE void offset(const std::array<float, 4>& o_a, const std::array<float, 4>& o_b,
                           float out[4]) const {
        const hn::CappedTag<double, 4> d;
        const hn::Rebind<float, decltype(d)> narrow;
        const auto x = hn::Set(d, static_cast<double>(o_b[0]));
        const auto y = hn::Set(d, static_cast<double>(o_b[1]));
        const auto z = hn::Set(d, static_cast<double>(o_b[2]));
        for (std::size_t k = 0; k < 4; k += hn::MaxLanes(d)) {
            auto v =
                hn::Sub(hn::Load(d, translation_ + k), hn::PromoteTo(d, hn::LoadU(narrow, o_a.data() + k)));
            v = Arithmetic::multiply_add(hn::Load(d, rotation_[2] + k), z, v);
            v = Arithmetic::multiply_add(hn::Load(d, rotation_[1] + k), y, v);
            v = Arithmetic::multiply_add(hn::Load(d, rotation_[0] + k), x, v);
            hn::StoreU(hn::DemoteTo(narrow, v), narrow, out + k);
        }
    }

    /// `units` u L, plus the two terms. 2^-120 covers products that underflow.
    HWY_INLINE float bound(float units, float length) const {
        return (units * kFloatUnit + tilt_) * length + (2.0F * coordinates_ + 0x1p-120F);
    }

    /// The rotation in float32, by column; the fourth entries are 0.
    HWY_ALIGN float column[3][4] = {};
    /// And by row.
    HWY_ALIGN float row[3][4] = {};

private:
    HWY_ALIGN double rotation_[3][4] = {};  ///< by column
    HWY_ALIGN double translation_[4] = {};
    float coordinates_ = 0.0F;
    float tilt_ = 0.0F;
};

/// The sum of the rows of m, weighted by v; the fourth entry is 0.
HWY_INLINE void rotate(const float m[3][4], const float v[3], float out[4]) {
    const hn::FixedTag<float, 4> d;
    auto sum = hn::Mul(hn::Load(d, m[0]), hn::Set(d, v[0]));
    sum = hn::MulAdd(hn::Load(d, m[1]), hn::Set(d, v[1]), sum);
    sum = hn::MulAdd(hn::Load(d, m[2]), hn::Set(d, v[2]), sum);
    hn::Store(sum, d, out);
}

/// |v|, or a little more.
HWY_INLINE float length_of(const float v[3]) {
    return std::abs(v[0]) + std::abs(v[1]) + std::abs(v[2]);
}

}  // namespace HWY_NAMESPACE
}  // namespace campuswalk::collision
HWY_AFTER_NAMESPACE();

#endif

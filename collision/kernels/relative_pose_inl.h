#if defined(CAMPUSWALK_COLLISION_KERNELS_RELATIVE_POSE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAMPUSWALK_COLLISION_KERNELS_RELATIVE_POSE_INL_H
#undef CAMPUSWALK_COLLISION_KERNELS_RELATIVE_POSE_INL_H
#else
#define CAMPUSWALK_COLLISION_KERNELS_RELATIVE_POSE_INL_H
#endif

#include <array>
#include <cmath>

#include "collision/kernels/lanes_inl.h"
#include "collision/kernels/wide_contacts.h"

HWY_BEFORE_NAMESPACE();
namespace campuswalk::collision {
namespace HWY_NAMESPACE {

/// Where b lies in a's frame, ready for float32 about any two origins: the large part of a position is
/// subtracted in double, what remains is as long as the parts that are held against each other.
///
/// Bounds below are in units u = kFloatUnit and lengths L = r_a + r_b + |offset|, where r is a part's radius.
/// Two terms come on top of them:
/// - `coordinates`: the truth itself (b_corner_in_a) and `offset` are each rounded in double, by at most
///   4 x 2^-53 times the coordinates' sum along each axis; 2^-49 times that sum is more than both.
/// - `tilt`: what is brought to b by the transposed matrix instead of the inverse is off by at most the
/// matrix'
///   distance from a rotation times 3 L.
class RelativePose {
public:
    explicit RelativePose(const WidePair& pair)
        : rotation_(pair.X_a_b.rotation), translation_(pair.X_a_b.translation) {
        for (std::size_t j = 0; j < 3; ++j) {
            for (std::size_t i = 0; i < 3; ++i) {
                column[j][i] =
                    static_cast<float>(rotation_(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
            }
        }
        const double sum = static_cast<double>(pair.a.reach) + 3.0 * static_cast<double>(pair.b.reach) +
                           translation_.cwiseAbs().maxCoeff();
        coordinates_ = static_cast<float>(sum * 0x1p-48);
        tilt_ = static_cast<float>(4.0 * pair.tilt);
    }

    /// R o_b + t - o_a; the fourth entry is 0.
    HWY_INLINE void offset(const std::array<float, 3>& o_a, const std::array<float, 3>& o_b,
                           float out[4]) const {
        const double x = o_b[0];
        const double y = o_b[1];
        const double z = o_b[2];
        for (std::size_t k = 0; k < 3; ++k) {
            const auto i = static_cast<Eigen::Index>(k);
            out[k] = static_cast<float>(rotation_(i, 0) * x + rotation_(i, 1) * y + rotation_(i, 2) * z +
                                        (translation_[i] - static_cast<double>(o_a[k])));
        }
        out[3] = 0.0F;
    }

    /// `units` u L, and what comes on top. The smallest float32 is for products that underflow.
    HWY_INLINE float bound(float units, float length) const {
        return (units * kFloatUnit + tilt_) * length + (2.0F * coordinates_ + 0x1p-120F);
    }

    /// The rotation in float32, by column; the fourth entries are 0.
    HWY_ALIGN float column[3][4] = {};

private:
    Mat3 rotation_;
    Vec3 translation_;
    float coordinates_ = 0.0F;
    float tilt_ = 0.0F;
};

/// |v|, or a little more.
HWY_INLINE float length_of(const float v[3]) {
    return std::abs(v[0]) + std::abs(v[1]) + std::abs(v[2]);
}

}  // namespace HWY_NAMESPACE
}  // namespace campuswalk::collision
HWY_AFTER_NAMESPACE();

#endif

#pragma once

#include <limits>

#include <Eigen/Core>

namespace campuswalk::collision {

/// x, y, z and an unused lane.
using Lanes = Eigen::Array4f;

/// Added to every bound: the error of a product that underflows is less, at any scale.
inline constexpr float kUnderflow = std::numeric_limits<float>::min();

inline Lanes lanes(const Eigen::Vector3f& p) {
    return {p.x(), p.y(), p.z(), 0.0F};
}

inline Eigen::Vector3d exact(const Lanes& p) {
    return p.head<3>().matrix().cast<double>();
}

struct LaneBounds {
    Lanes min = Lanes::Constant(std::numeric_limits<float>::max());
    Lanes max = Lanes::Constant(std::numeric_limits<float>::lowest());

    void extend(const LaneBounds& o) {
        min = min.min(o.min);
        max = max.max(o.max);
    }
    void extend(const Lanes& p) {
        min = min.min(p);
        max = max.max(p);
    }
    Lanes middle() const { return 0.5F * min + 0.5F * max; }
    float half_area() const {
        const Lanes d = max - min;
        return d[0] * d[1] + (d[1] * d[2] + d[2] * d[0]);
    }
};

}  // namespace campuswalk::collision

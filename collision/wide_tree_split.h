#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include <Eigen/Core>

namespace campuswalk::collision {

/// x, y, z and a lane that isn't used.
using Lanes = Eigen::Array4f;

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
    float half_area() const {
        const Lanes d = max - min;
        return d[0] * d[1] + (d[1] * d[2] + d[2] * d[0]);
    }
};

/// A triangle on its way into a wide tree.
struct SplitItem {
    LaneBounds bounds;
    std::uint32_t triangle = 0;
};

/// Reorders at least two items and returns how many go to the left: at least one, and not all. By the
/// surface-area heuristic over sixteen bins of the bounds' centres on each axis (Wald 2007), where a side
/// costs its area times the leaves it will take.
std::size_t split_by_area(std::span<SplitItem> items);

}  // namespace campuswalk::collision

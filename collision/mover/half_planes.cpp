#include "collision/mover/half_planes.h"

#include <algorithm>
#include <cmath>

namespace campuswalk::collision {

namespace {

/// The nearest allowed of the moves offered; of two equally near ones, the lower in x, then in z.
class Nearest {
public:
    Nearest(const Vec3& desired, std::span<const HalfPlane> planes)
        : desired_(desired), planes_(planes), distance_(desired.squaredNorm()) {}

    void offer(double x, double z) {
        const Vec3 move(x, 0, z);
        const double distance = (desired_ - move).squaredNorm();
        const bool ahead = x != best_.x() ? x < best_.x() : z < best_.z();
        if (distance > distance_ || (distance == distance_ && !ahead)) {
            return;
        }
        if (!planes_[forbidding_].allows(move)) {
            return;
        }
        const auto forbids = [&](const HalfPlane& p) { return !p.allows(move); };
        const auto forbidding = std::ranges::find_if(planes_, forbids);
        if (forbidding != planes_.end()) {
            forbidding_ = static_cast<std::size_t>(forbidding - planes_.begin());
            return;
        }
        best_ = move;
        distance_ = distance;
    }
    /// Whether a move at least this far from the desired one can't be it.
    bool is_too_far(double away) const {
        constexpr double kRounding = 1e-6;  // metres: nearly parallel lines intersect inexactly
        return away > kRounding && (away - kRounding) * (away - kRounding) > distance_;
    }
    const Vec3& best() const { return best_; }

private:
    const Vec3& desired_;
    std::span<const HalfPlane> planes_;
    Vec3 best_ = Vec3::Zero();
    double distance_;
    std::size_t forbidding_ = 0;  ///< the last that forbade one: it often forbids the next
};

}  // namespace

/// The desired move itself, its projection onto one line, or the intersection of two lines.
Vec3 nearest_allowed(const Vec3& desired, std::span<const HalfPlane> planes) {
    if (std::all_of(planes.begin(), planes.end(), [&](const HalfPlane& p) { return p.allows(desired); })) {
        return desired;
    }
    const auto short_of = [&](const HalfPlane& p) {
        return -p.room - (p.x * desired.x() + p.z * desired.z());
    };
    Nearest nearest(desired, planes);
    for (const HalfPlane& p : planes) {
        const double away = short_of(p);
        nearest.offer(desired.x() + away * p.x, desired.z() + away * p.z);
    }
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const HalfPlane& p = planes[i];
        if (nearest.is_too_far(std::abs(short_of(p)))) {
            continue;  // and so are all intersections of its line
        }
        for (std::size_t j = i + 1; j < planes.size(); ++j) {
            const HalfPlane& q = planes[j];
            if (nearest.is_too_far(std::abs(short_of(q)))) {
                continue;
            }
            const double determinant = p.x * q.z - p.z * q.x;
            if (std::abs(determinant) > 1e-9) {
                nearest.offer((-p.room * q.z + q.room * p.z) / determinant,
                              (-q.room * p.x + p.room * q.x) / determinant);
            }
        }
    }
    return nearest.best();
}

}  // namespace campuswalk::collision

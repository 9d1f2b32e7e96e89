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
        if (std::all_of(planes_.begin(), planes_.end(), [&](const HalfPlane& p) { return p.allows(move); })) {
            best_ = move;
            distance_ = distance;
        }
    }
    const Vec3& best() const { return best_; }

private:
    const Vec3& desired_;
    std::span<const HalfPlane> planes_;
    Vec3 best_ = Vec3::Zero();
    double distance_;
};

}  // namespace

/// The desired move itself, its projection onto one line, or the intersection of two lines.
Vec3 nearest_allowed(const Vec3& desired, std::span<const HalfPlane> planes) {
    if (std::all_of(planes.begin(), planes.end(), [&](const HalfPlane& p) { return p.allows(desired); })) {
        return desired;
    }
    Nearest nearest(desired, planes);
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const HalfPlane& p = planes[i];
        const double short_of = -p.room - (p.x * desired.x() + p.z * desired.z());
        nearest.offer(desired.x() + short_of * p.x, desired.z() + short_of * p.z);
        for (std::size_t j = i + 1; j < planes.size(); ++j) {
            const HalfPlane& q = planes[j];
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

#include "engine/script/curve_walk.h"

#include "engine/script/smooth_curve.h"

namespace campuswalk::engine {

using Eigen::Vector3d;

namespace {

constexpr double kLead = 0.5;  // metres

double flat_distance(const Vector3d& level, const Vector3d& avatar) {
    return (level - Vector3d(avatar.x(), 0.0, avatar.z())).norm();
}

}  // namespace

void CurveWalk::start(const Vector3d& avatar, const std::vector<Target>& points) {
    points_.assign(1, avatar);
    for (const Target& target : points) {
        points_.push_back(target.point);
    }
    smooth_curve(points_, curve_);
    point_ = curve_.front();
    next_ = 1;
    passed_ = 0.0;
    length_ = 0.0;
    for (std::size_t i = 1; i < curve_.size(); ++i) {
        length_ += (curve_[i] - curve_[i - 1]).norm();
    }
}

const Vector3d& CurveWalk::lead(const Vector3d& avatar, double distance) {
    if (flat_distance(point_, avatar) > kLead) {
        return point_;
    }
    while (!at_end() && distance > 0.0) {
        const Vector3d segment = curve_[next_] - point_;
        const double length = segment.norm();
        if (length > distance) {
            point_ += segment * (distance / length);
            passed_ += distance;
            return point_;
        }
        point_ = curve_[next_];
        passed_ += length;
        distance -= length;
        ++next_;
    }
    return point_;
}

double CurveWalk::remaining(const Vector3d& avatar) const {
    return flat_distance(point_, avatar) + length_ - passed_;
}

}  // namespace campuswalk::engine

#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "engine/script/walk.h"

namespace campuswalk::engine {

/// Leads an avatar along a curve: a point runs ahead on it at the avatar's speed, and waits where the avatar
/// falls behind by more than half a metre. An avatar that nothing holds up is at that point in every tick.
class CurveWalk {
public:
    /// A curve from where the avatar is through the points. Horizontal: heights don't count.
    void start(const Eigen::Vector3d& avatar, const std::vector<Target>& points);

    /// The leading point (y = 0), up to `distance` metres farther along the curve.
    const Eigen::Vector3d& lead(const Eigen::Vector3d& avatar, double distance);

    bool at_end() const { return next_ >= curve_.size(); }
    double length() const { return length_; }
    /// Metres from the avatar to the leading point and along the curve to its end.
    double remaining(const Eigen::Vector3d& avatar) const;

private:
    std::vector<Eigen::Vector3d> points_;
    std::vector<Eigen::Vector3d> curve_;
    std::size_t next_ = 0;  ///< the corner of the curve that the leading point comes to next
    Eigen::Vector3d point_ = Eigen::Vector3d::Zero();
    double length_ = 0.0;
    double passed_ = 0.0;
};

}  // namespace campuswalk::engine

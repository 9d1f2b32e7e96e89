#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "engine/script/walk.h"

namespace campuswalk::engine {

/// Leads an avatar along a curve: a point moves ahead on it at the avatar's speed, and waits while the avatar
/// is more than half a metre behind. An avatar that nothing blocks reaches that point in every tick.
class CurveWalk {
public:
    /// A curve from the avatar through the points. Heights are ignored.
    void start(const Eigen::Vector3d& avatar, const std::vector<Target>& points);

    /// Moves the leading point (y = 0) up to `distance` metres along the curve, and returns it.
    const Eigen::Vector3d& lead(const Eigen::Vector3d& avatar, double distance);

    bool at_end() const { return next_ >= curve_.size(); }
    double length() const { return length_; }
    /// Metres from the avatar to the leading point and along the curve to its end.
    double remaining(const Eigen::Vector3d& avatar) const;

private:
    std::vector<Eigen::Vector3d> points_;
    std::vector<Eigen::Vector3d> curve_;
    std::size_t next_ = 0;  ///< the vertex of the curve that the leading point reaches next
    Eigen::Vector3d point_ = Eigen::Vector3d::Zero();
    double length_ = 0.0;
    double passed_ = 0.0;
};

}  // namespace campuswalk::engine

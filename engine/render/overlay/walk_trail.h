#pragma once

#include <vector>

#include <Eigen/Core>

#include "engine/record/tick_record.h"

namespace campuswalk::engine::render {

/// The path of an avatar, for maps, and the phase of its gait, for its figure.
class WalkTrail {
public:
    void clear();
    /// To be called after each tick.
    void follow(const AvatarState& avatar);

    /// A point every half metre since the last teleport, then the current position.
    std::vector<Eigen::Vector3d> path() const;
    /// Phase in radians; 0 while standing.
    double stride() const;

private:
    std::vector<Eigen::Vector3d> path_;
    Eigen::Vector3d last_position_ = Eigen::Vector3d::Zero();
    double walked_ = 0.0;  // metres
    bool moving_ = false;
    bool started_ = false;
};

}  // namespace campuswalk::engine::render

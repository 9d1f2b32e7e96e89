#pragma once

#include <vector>

#include <Eigen/Core>

#include "engine/record/tick_record.h"

namespace campuswalk::engine::render {

/// The way an avatar has walked, for maps, and the phase of its step, for its figure.
class WalkTrail {
public:
    void clear();
    /// The avatar at the end of a tick.
    void follow(const AvatarState& avatar);

    /// A point every half metre since the last leap, then where the avatar is.
    std::vector<Eigen::Vector3d> path() const;
    /// Radians; 0 while it stands.
    double stride() const;

private:
    std::vector<Eigen::Vector3d> path_;
    Eigen::Vector3d last_position_ = Eigen::Vector3d::Zero();
    double walked_ = 0.0;  // metres
    bool moving_ = false;
    bool started_ = false;
};

}  // namespace campuswalk::engine::render

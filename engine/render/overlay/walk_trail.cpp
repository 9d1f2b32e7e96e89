#include "engine/render/overlay/walk_trail.h"

#include <numbers>

namespace campuswalk::engine::render {
namespace {

constexpr double kPathSpacing = 0.5;  // metres
constexpr double kStepLength = 0.75;  // metres: half a period of the gait
constexpr double kMinTeleport = 2.0;  // metres per tick: more is a teleport

}  // namespace

void WalkTrail::clear() {
    *this = WalkTrail();
}

void WalkTrail::follow(const AvatarState& avatar) {
    const double moved = started_ ? (avatar.position - last_position_).norm() : 0.0;
    if (!started_ || moved > kMinTeleport) {
        path_.clear();
    }
    moving_ = moved > 1e-4 && moved <= kMinTeleport;
    walked_ += moving_ ? moved : 0.0;
    if (path_.empty() || (avatar.position - path_.back()).norm() >= kPathSpacing) {
        path_.push_back(avatar.position);
    }
    last_position_ = avatar.position;
    started_ = true;
}

std::vector<Eigen::Vector3d> WalkTrail::path() const {
    std::vector<Eigen::Vector3d> path = path_;
    path.push_back(last_position_);
    return path;
}

double WalkTrail::stride() const {
    return moving_ ? std::numbers::pi * walked_ / kStepLength : 0.0;
}

}  // namespace campuswalk::engine::render

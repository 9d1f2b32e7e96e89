#include "engine/simulation/stuck_watch.h"

#include <algorithm>

namespace campuswalk::engine {

namespace {

constexpr double kMinProgress = 0.1;  // metres within a second
constexpr double kSlowShare = 0.25;   // of the distance that a slow avatar desires within a second
constexpr double kStandstill =
    1e-3;  // metres per second: below this desired speed the avatar counts as standing

}  // namespace

bool StuckWatch::update(const Eigen::Vector3d& position, double desired) {
    const double speed = desired * ticks_per_second_;
    const double progress = std::min(kMinProgress, kSlowShare * speed);
    if (speed < kStandstill || ticks_ == 0 || (position - from_).norm() > progress) {
        ticks_ = speed < kStandstill ? 0 : 1;
        from_ = position;
        return false;
    }
    ticks_ = std::min(ticks_ + 1, ticks_per_second_ + 2);  // stays above: already reported
    return ticks_ == ticks_per_second_ + 1;
}

}  // namespace campuswalk::engine

#include "engine/simulation/stuck_watch.h"

#include <algorithm>

namespace campuswalk::engine {

namespace {

constexpr double kProgress = 0.1;     // metres in a second
constexpr double kSlowShare = 0.25;   // of what a slow avatar asks for in a second
constexpr double kStandstill = 1e-3;  // metres a second: asking for less is asking to stay

}  // namespace

bool StuckWatch::see(const Eigen::Vector3d& position, double asked) {
    const double speed = asked * ticks_per_second_;
    const double progress = std::min(kProgress, kSlowShare * speed);
    if (speed < kStandstill || ticks_ == 0 || (position - from_).norm() > progress) {
        ticks_ = speed < kStandstill ? 0 : 1;
        from_ = position;
        return false;
    }
    ticks_ = std::min(ticks_ + 1, ticks_per_second_ + 2);  // stays beyond: told already
    return ticks_ == ticks_per_second_ + 1;
}

}  // namespace campuswalk::engine

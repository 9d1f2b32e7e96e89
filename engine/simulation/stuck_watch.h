#pragma once

#include <Eigen/Core>

namespace campuswalk::engine {

/// Detects an avatar that tries to move but makes no progress: for a second it tried to, and in that second
/// it was never 10 cm (if it is slow, a quarter of the desired distance) away from where it was at the start.
/// Sliding along a wall or waiting is not being stuck; running against a wall is, and so is jittering in a
/// corner. Reported once, until the avatar has left the place.
class StuckWatch {
public:
    explicit StuckWatch(int ticks_per_second) : ticks_per_second_(ticks_per_second) {}

    /// After every tick, with the avatar's position and the length of its desired displacement, metres. True
    /// in the tick in which it is found to be stuck.
    bool update(const Eigen::Vector3d& position, double desired);

private:
    int ticks_per_second_;
    int ticks_ = 0;  ///< in which it tried to move, since it was at `from_`
    Eigen::Vector3d from_ = Eigen::Vector3d::Zero();
};

}  // namespace campuswalk::engine

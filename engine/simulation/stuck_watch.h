#pragma once

#include <Eigen/Core>

namespace campuswalk::engine {

/// Tells when an avatar that wants to go on makes no progress: for a second it asked to move, and never in
/// that second was it 10 cm (a quarter of what it asked for, if it is slow) from where it was at its start.
/// Sliding along a wall or waiting is not being stuck; running against one is, and so is trembling in a
/// corner. Told once, until the avatar has come away from the place.
class StuckWatch {
public:
    explicit StuckWatch(int ticks_per_second) : ticks_per_second_(ticks_per_second) {}

    /// After every tick: where the avatar is now and how far it asked to move, metres. True in the tick in
    /// which it turns out to be stuck.
    bool see(const Eigen::Vector3d& position, double asked);

private:
    int ticks_per_second_;
    int ticks_ = 0;  ///< since it was at `from_`, as far as it asked to move
    Eigen::Vector3d from_ = Eigen::Vector3d::Zero();
};

}  // namespace campuswalk::engine

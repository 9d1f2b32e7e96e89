#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/walkspace/explore/explore.h"

namespace campuswalk::tools::bench {

/// Random walks that try to get to where an exploration hasn't been.
struct AdversarySettings {
    std::size_t walks = 0;
    double seconds = 60.0;
    bool steers_in_falls = false;  ///< else it goes straight on in the air
    std::uint64_t first_seed = 1;  ///< of the first walk; the next one's is one more
};

/// A walk that stood where no node is: none in the cells around, within a step's height.
struct Escape {
    std::uint64_t seed = 0;
    collision::Vec3 start = collision::Vec3::Zero();
    std::size_t tick = 0;  ///< the first outside
    collision::Vec3 at = collision::Vec3::Zero();
    collision::Vec3 left_ground = collision::Vec3::Zero();  ///< where it last did so before
    double apart = 0.0;             ///< metres from the nearest node at that height, horizontally
    std::size_t ticks_outside = 0;  ///< on the ground
};

struct AdversaryResult {
    std::size_t walks = 0;
    std::uint64_t ticks = 0;
    std::uint64_t falls = 0;      ///< of more than 2 m
    std::vector<Escape> escapes;  ///< the farthest first
};

/// Walks with the mover, one thread for each world: at the profile's pace, with turns by any angle
/// at random times, and runs and jumps where the exploration did. Half of the walks start at the spawn, half
/// at any node.
AdversaryResult attack(const engine::WalkSpace& space, const engine::WorkerWorlds& worlds,
                       const engine::ExploreSettings& explored, const AdversarySettings& settings);

}  // namespace campuswalk::tools::bench

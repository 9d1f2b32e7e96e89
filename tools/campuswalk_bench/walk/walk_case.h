#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "tools/campuswalk_bench/walk/walk_run.h"

namespace campuswalk::tools::bench {

/// The scores on one campus.
struct WalkedCampus {
    std::size_t triangles = 0;
    std::vector<WalkScore> scores;   ///< `ours` first; then `bullet`, if built: the better of the others
    std::size_t working_memory = 0;  ///< our mover's, bytes
    /// The least mean of Bullet's configurations, which ours is compared with.
    std::optional<double> fastest_peer;  ///< microseconds per tick
};

/// Our controller and Bullet's, with its defaults and tuned, on the same triangles and paths of a campus with
/// `lots` lots per side (tools/campuswalk_bench/procedural/walkable_campus.h). Prints one line per
/// controller.
WalkedCampus walk_campus(int lots, int rounds);

/// The better of two configurations of a controller: the one with more correct goals, or else with less time.
const WalkScore& better(const WalkScore& a, const WalkScore& b);

}  // namespace campuswalk::tools::bench

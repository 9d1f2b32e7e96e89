#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "tools/campuswalk_bench/walk/walk_run.h"

namespace campuswalk::tools::bench {

/// What was found on one campus.
struct WalkedCampus {
    std::size_t triangles = 0;
    std::vector<WalkScore>
        scores;  ///< `ours` first; `bullet` second, if it is built: the better of the others
    std::size_t working_memory = 0;  ///< our mover's own, bytes
    /// The least mean of Bullet's ways to be set up: what ours is held against.
    std::optional<double> fastest_peer;  ///< microseconds a tick
};

/// A campus of `lots` a side (tools/campuswalk_bench/procedural/walkable_campus.h): ours and Bullet's
/// controller, as its defaults have it and tuned, on the same triangles and paths. Prints a line each.
WalkedCampus walk_campus(int lots, int rounds);

/// Of two ways to set the same controller up: more goals right, then less time.
const WalkScore& better(const WalkScore& a, const WalkScore& b);

}  // namespace campuswalk::tools::bench

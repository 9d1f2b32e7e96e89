#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tools/campuswalk_bench/engine/engine.h"
#include "tools/campuswalk_bench/procedural/walk_course.h"
#include "tools/campuswalk_bench/walk/walk_score.h"

namespace campuswalk::tools::bench {

struct Walker {
    std::string name;
    WalkEngine* engine = nullptr;  ///< not owned
};

/// The score of one controller on all paths.
struct WalkScore {
    std::string controller;
    std::size_t ticks = 0;
    // Microseconds per tick; the least of all rounds for each tick.
    double us_mean = 0.0;
    double us_p50 = 0.0;
    double us_p99 = 0.0;
    double us_max = 0.0;
    std::size_t goals = 0;    ///< without the forbidden ones
    std::size_t reached = 0;  ///< of `goals`
    std::size_t forbidden_goals = 0;
    std::size_t forbidden_reached = 0;  ///< of `forbidden_goals`
    double max_penetration = 0.0;       ///< metres, at the end of a tick
    std::size_t crossings = 0;          ///< ticks on which the middle of the body went through a triangle
    std::size_t differing_paths = 0;    ///< paths that weren't bit for bit the same in all rounds
    /// Bytes, in ticks from the third round on: the first two rounds start a path after different ones, and
    /// buffers have their final size after them. None with fewer rounds.
    std::optional<std::size_t> heap_growth;
    std::vector<std::string> failures;  ///< goals missed, and forbidden goals reached
};

/// Every controller walks every path `rounds` times, in turns. A round is a whole walk, so that each tick
/// finds in the caches what earlier ticks left there; a tick that is replayed by itself would find everything
/// cached, and hide what new surroundings cost. Where a walk differs between rounds, the first one and its
/// times count.
std::vector<WalkScore> run_walks(const std::vector<Walker>& walkers, const std::vector<WalkPath>& paths,
                                 const WalkBody& body, const WalkScorer& scorer, int rounds);

}  // namespace campuswalk::tools::bench

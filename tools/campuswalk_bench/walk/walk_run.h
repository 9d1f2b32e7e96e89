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
    WalkEngine* engine = nullptr;  ///< not its own
};

/// How one controller fared on all paths.
struct WalkScore {
    std::string controller;
    std::size_t ticks = 0;
    // Microseconds a tick; of each tick the least of all rounds.
    double us_mean = 0.0;
    double us_p50 = 0.0;
    double us_p99 = 0.0;
    double us_max = 0.0;
    std::size_t goals = 0;         ///< that it is to get to
    std::size_t reached = 0;       ///< of these
    std::size_t walled_off = 0;    ///< that it mustn't get to
    std::size_t forbidden = 0;     ///< of these it got to
    double max_penetration = 0.0;  ///< metres, at the end of a tick
    std::size_t crossings = 0;     ///< ticks on which the middle of the body went through a triangle
    std::size_t unrepeated = 0;    ///< paths that weren't the same, to the bit, each time
    /// Bytes, in ticks of the third round and later: the first two come to a path from two different places,
    /// and by then buffers are as large as they must be. None with fewer rounds.
    std::optional<std::size_t> heap_growth;
    std::vector<std::string> failures;  ///< goals missed or wrongly got to
};

/// Everybody walks every path `rounds` times, by turns. A round is a walk from the start, so that each tick
/// finds in the caches what the ticks before it left there: replaying a tick by itself would find all it
/// needs, and hide what a new neighbourhood costs. Where a walk isn't the same each time it is the first that
/// counts, and its times.
std::vector<WalkScore> run_walks(const std::vector<Walker>& walkers, const std::vector<WalkPath>& paths,
                                 const WalkBody& body, const WalkEvaluator& evaluator, int rounds);

}  // namespace campuswalk::tools::bench

#pragma once

#include <optional>
#include <vector>

#include "tools/campuswalk_bench/measure/verdict.h"
#include "tools/campuswalk_bench/walk/walk_case.h"

namespace campuswalk::tools::bench {

/// Verdicts on quality and speed. `tour_ms` is the time of the demo campus' tour.
std::vector<Verdict> walk_verdicts(const std::vector<WalkedCampus>& campuses, std::optional<double> tour_ms);

/// Whether our mover reached all goals and no forbidden one, was never inside anything, and walked the same
/// each time.
bool is_correct(const WalkScore& ours);

}  // namespace campuswalk::tools::bench

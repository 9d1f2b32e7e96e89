#pragma once

#include <vector>

#include "tools/campuswalk_bench/explore/explore_case.h"
#include "tools/campuswalk_bench/measure/verdict.h"

namespace campuswalk::tools::bench {

/// Time against Recast's (geometric mean of all campuses), memory, walks that got outside; routes against
/// Detour's.
std::vector<Verdict> explore_verdicts(const std::vector<ExploreScore>& scores);

/// Whether the exploration is the same for any number of threads, no walk got outside that went straight on
/// in falls, and routes lead wherever strides do; speed has no influence.
bool is_correct(const ExploreScore& score);

}  // namespace campuswalk::tools::bench

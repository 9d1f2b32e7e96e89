#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/campuswalk_bench/walk/walk_case.h"

namespace campuswalk::tools::bench {

/// One thing that is asked of the mover, and what it does.
struct WalkVerdict {
    std::string what;
    std::optional<double> value;  ///< none: not measured
    const char* unit = "";
    bool more_is_better = false;
    double must = 0.0;
    std::optional<double> aim;
    bool holds = true;  ///< at least `must`; false without a value
};

/// Quality and speed. `tour_ms` is what the demo campus' tour took.
std::vector<WalkVerdict> walk_verdicts(const std::vector<WalkedCampus>& campuses,
                                       std::optional<double> tour_ms);

void print_verdicts(const std::vector<WalkVerdict>& verdicts);

/// Whether our mover got to all it should and to nothing else, never in anything, and the same each time.
bool walks_right(const WalkScore& ours);

}  // namespace campuswalk::tools::bench

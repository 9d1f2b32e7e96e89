#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/campuswalk_bench/walk/walk_case.h"

namespace campuswalk::tools::bench {

/// One target of the mover, and what was measured.
struct WalkVerdict {
    std::string what;
    std::optional<double> value;  ///< none if it wasn't measured
    const char* unit = "";
    bool more_is_better = false;
    double must = 0.0;
    std::optional<double> aim;
    bool holds = true;  ///< at least `must`; false without a value
};

/// Verdicts on quality and speed. `tour_ms` is the time of the demo campus' tour.
std::vector<WalkVerdict> walk_verdicts(const std::vector<WalkedCampus>& campuses,
                                       std::optional<double> tour_ms);

void print_verdicts(const std::vector<WalkVerdict>& verdicts);

/// Whether our mover reached all goals and no forbidden one, was never inside anything, and walked the same
/// each time.
bool is_correct(const WalkScore& ours);

}  // namespace campuswalk::tools::bench

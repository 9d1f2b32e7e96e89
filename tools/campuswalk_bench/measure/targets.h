#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "tools/campuswalk_bench/measure/row.h"

namespace campuswalk::tools::bench {

/// How rows are reduced to one figure.
enum class Measure : std::uint8_t {
    mean_ratio,   ///< the peer's least time over ours, the geometric mean of all placements
    worst_ratio,  ///< the least ratio of all placements
    figure,       ///< our figure itself; less is better
};

/// A target for one of our engines.
struct Target {
    const char* what = "";
    const char* case_name = "";
    const char* query = "";
    const char* ours = "";
    const char* peer = "";
    Measure measure = Measure::mean_ratio;
    double must = 0.0;
    double aim = 0.0;  ///< 0: none
};

std::span<const Target> targets();

/// Empty if one of the engines wasn't measured.
std::optional<double> measured(const Target& target, const std::vector<Row>& rows);

/// Whether the figure is as good as `bound`.
bool reaches(const Target& target, double figure, double bound);

}  // namespace campuswalk::tools::bench

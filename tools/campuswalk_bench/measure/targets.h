#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "tools/campuswalk_bench/measure/row.h"
#include "tools/campuswalk_bench/measure/verdict.h"

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
    std::optional<double> aim;
};

std::span<const Target> targets();

/// Without a value if one of the engines wasn't measured.
Verdict verdict_on(const Target& target, const std::vector<Row>& rows);

}  // namespace campuswalk::tools::bench

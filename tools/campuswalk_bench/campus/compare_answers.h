#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tools/campuswalk_bench/measure/row.h"

namespace campuswalk::tools::bench {

// How an answer differs from the expected one, bit by bit, with both taken as sets of what was found.

/// The fraction of a first hit.
Difference compare_answers(const std::optional<double>& answer, const std::optional<double>& expected);

/// Whether there is any hit.
Difference compare_answers(char answer, char expected);

/// A distance.
Difference compare_answers(double answer, double expected);

/// The touched triangles, ascending.
Difference compare_answers(const std::vector<std::uint32_t>& answer,
                           const std::vector<std::uint32_t>& expected);

}  // namespace campuswalk::tools::bench

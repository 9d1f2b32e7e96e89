#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tools/campuswalk_bench/measure/row.h"

namespace campuswalk::tools::bench {

// How an answer differs from the right one, to the last bit, taken as sets of what was found.

/// Where something is met first.
Difference differ(const std::optional<double>& answer, const std::optional<double>& right);

/// Whether anything is met.
Difference differ(char answer, char right);

/// A distance.
Difference differ(double answer, double right);

/// Which triangles, ascending.
Difference differ(const std::vector<std::uint32_t>& answer, const std::vector<std::uint32_t>& right);

}  // namespace campuswalk::tools::bench

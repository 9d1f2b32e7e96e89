#pragma once

#include "tools/campuswalk_bench/measure/measurement.h"

namespace campuswalk::tools::bench {

/// Prints our measurements of Table I, the costs of eq. (4), the effect of the sphere test, and how the
/// engines' pairs differ.
void print_table1(const Results& results);

}  // namespace campuswalk::tools::bench

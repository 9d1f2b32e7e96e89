#pragma once

#include "tools/campuswalk_bench/measure/measurement.h"

namespace campuswalk::tools::bench {

/// Table I anew, the costs of eq. (4), what the sphere test does, and who reports which pairs: to standard
/// output.
void print_table1(const Results& results);

}  // namespace campuswalk::tools::bench

#pragma once

#include <vector>

#include "tools/campuswalk_bench/measure/row.h"

namespace campuswalk::tools::bench {

/// Prints the targets whose cases are among the rows, one per line: what was measured, and whether it reaches
/// them.
void print_summary(const std::vector<Row>& rows);

}  // namespace campuswalk::tools::bench

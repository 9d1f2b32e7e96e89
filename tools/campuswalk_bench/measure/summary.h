#pragma once

#include <vector>

#include "tools/campuswalk_bench/measure/row.h"

namespace campuswalk::tools::bench {

/// How fast ours is beside others, against what it is to reach: a line for every target whose case is among
/// the rows, to standard output.
void print_summary(const std::vector<Row>& rows);

}  // namespace campuswalk::tools::bench

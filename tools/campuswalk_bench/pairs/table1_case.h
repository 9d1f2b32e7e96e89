#pragma once

#include <filesystem>

#include "tools/campuswalk_bench/measure/row.h"

namespace campuswalk::tools::bench {

/// Measures the paper's Table I and prints it. `mixed`: with the paper's mixed reading as another engine.
/// `plot`: a file for the paper's figure 4, *.svg or *.png, or empty.
CaseResult run_table1(int rounds, bool mixed, const std::filesystem::path& plot);

}  // namespace campuswalk::tools::bench

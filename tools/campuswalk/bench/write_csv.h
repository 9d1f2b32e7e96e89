#pragma once

#include <filesystem>

#include "tools/campuswalk/bench/measurement.h"

namespace campuswalk::tools::bench {

/// A line a measurement: case,pairs,engine,query,us_min,us_median,nv,np,set_equal. The case is `table1`; nv
/// and np are empty where nobody counts; set_equal is `yes` or +EXTRA/-MISSING. Throws std::runtime_error.
void write_csv(const Results& results, const std::filesystem::path& file);

}  // namespace campuswalk::tools::bench

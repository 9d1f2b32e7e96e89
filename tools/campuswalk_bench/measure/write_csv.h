#pragma once

#include <filesystem>
#include <vector>

#include "tools/campuswalk_bench/measure/row.h"

namespace campuswalk::tools::bench {

/// case,pairs,engine,query,us_min,us_median,nv,np,set_equal: one line per row. `pairs` is empty for queries
/// that don't find overlapping pairs, nv and np where they aren't counted, and set_equal where nothing is
/// compared; else set_equal is `yes` or +EXTRA/-MISSING. In case `memory`, us_min and us_median are bytes per
/// triangle, as the query's name says. Throws std::runtime_error.
void write_csv(const std::vector<Row>& rows, const std::filesystem::path& file);

}  // namespace campuswalk::tools::bench

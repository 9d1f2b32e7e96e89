#pragma once

#include <filesystem>
#include <vector>

#include "tools/campuswalk_bench/measure/row.h"

namespace campuswalk::tools::bench {

/// case,pairs,engine,query,us_min,us_median,nv,np,set_equal: a line a row. Where there are no overlapping
/// pairs to be found, nobody counts nv and np, or nothing is compared, the field is empty. set_equal is `yes`
/// or +EXTRA/-MISSING. In case `memory` us_min and us_median hold bytes a triangle, as the query's name says.
/// Throws std::runtime_error.
void write_csv(const std::vector<Row>& rows, const std::filesystem::path& file);

}  // namespace campuswalk::tools::bench

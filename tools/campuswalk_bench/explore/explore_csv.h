#pragma once

#include <filesystem>
#include <vector>

#include "tools/campuswalk_bench/explore/explore_case.h"

namespace campuswalk::tools::bench {

/// One line per campus, engine and number of threads. Throws std::runtime_error if it can't be written.
void write_explore_csv(const std::vector<ExploreScore>& scores, const std::filesystem::path& file);

}  // namespace campuswalk::tools::bench

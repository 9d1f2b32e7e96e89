#pragma once

#include <filesystem>

#include "tools/campuswalk_bench/measure/measurement.h"

namespace campuswalk::tools::bench {

/// Plots the paper's figure 4 for our engines, the time to find all pairs over their number, to *.svg or
/// *.png. Throws std::runtime_error if it can't be written. A build without rendering (see can_draw) never
/// calls it.
void plot_figure4(const Results& results, const std::filesystem::path& file);

}  // namespace campuswalk::tools::bench

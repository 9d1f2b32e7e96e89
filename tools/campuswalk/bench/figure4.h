#pragma once

#include <filesystem>

#include "tools/campuswalk/bench/measurement.h"

namespace campuswalk::tools::bench {

/// False in a build without rendering, which can't call the other.
bool can_plot();

/// The paper's figure 4 for our engines: time of all pairs over their number. *.svg or *.png. Throws
/// std::runtime_error if it can't be written.
void plot_figure4(const Results& results, const std::filesystem::path& file);

}  // namespace campuswalk::tools::bench

#include <stdexcept>

#include "tools/campuswalk/bench/figure4.h"

namespace campuswalk::tools::bench {

bool can_plot() {
    return false;
}

void plot_figure4(const Results& /*results*/, const std::filesystem::path& /*file*/) {
    throw std::logic_error("a build without rendering was asked for a plot");
}

}  // namespace campuswalk::tools::bench

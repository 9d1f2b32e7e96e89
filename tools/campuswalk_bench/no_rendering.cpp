// A build without rendering (CAMPUSWALK_RENDER=OFF): can_draw() is false, and the rest is never called.
#include <stdexcept>

#include "tools/campuswalk_bench/draw/draw_bench.h"
#include "tools/campuswalk_bench/pairs/figure4.h"

namespace campuswalk::tools::bench {

bool can_draw() {
    return false;
}

void run_draw_bench(int /*rounds*/, bool /*quick*/, const std::filesystem::path& /*csv*/,
                    const DrawBench& /*bench*/) {
    throw std::logic_error("a build without rendering was asked to draw");
}

void plot_figure4(const Results& /*results*/, const std::filesystem::path& /*file*/) {
    throw std::logic_error("a build without rendering was asked for a plot");
}

}  // namespace campuswalk::tools::bench

#include <stdexcept>

#include "tools/campuswalk/bench/draw/draw_bench.h"

namespace campuswalk::tools::bench {

bool can_draw() {
    return false;
}

void run_draw_bench(const DrawBench& /*bench*/) {
    throw std::logic_error("a build without rendering was asked to draw");
}

}  // namespace campuswalk::tools::bench

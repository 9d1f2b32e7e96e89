#pragma once

#include <filesystem>
#include <vector>

#include "tools/campuswalk_bench/draw/draw_peers.h"

namespace campuswalk::tools::bench {

struct DrawBench {
    int rounds = 1;
    bool quick = false;            ///< one small campus
    std::filesystem::path csv;     ///< empty: none
    std::filesystem::path folder;  ///< where the campus and an image of each look are saved; empty: nowhere
    std::vector<DrawPeer> peers;
};

/// False in a build without rendering, which must not call run_draw_bench.
bool can_draw();

/// Times images of campuses of half a million and two million triangles, on hills and among houses, drawn by
/// us and by the peers, and prints the times and how they compare with the targets.
void run_draw_bench(const DrawBench& bench);

}  // namespace campuswalk::tools::bench

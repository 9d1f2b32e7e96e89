#pragma once

#include <filesystem>
#include <vector>

#include "tools/campuswalk_bench/draw/draw_peers.h"

namespace campuswalk::tools::bench {

struct DrawBench {
    int rounds = 1;
    bool quick = false;            ///< one small campus
    std::filesystem::path csv;     ///< empty: none
    std::filesystem::path folder;  ///< where the campus and an image of each look are left; empty: nowhere
    std::vector<DrawPeer> peers;
};

/// False in a build without rendering, which can't call the other.
bool can_draw();

/// Measures how long images take of campuses of half a million and two million triangles, on hills and
/// among houses, beside the peers, and prints it with verdicts.
void run_draw_bench(const DrawBench& bench);

}  // namespace campuswalk::tools::bench

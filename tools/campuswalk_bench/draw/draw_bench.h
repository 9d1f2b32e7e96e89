#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace campuswalk::tools::bench {

struct DrawBench {
    std::filesystem::path folder;    ///< where the campus and an image of each look are saved; empty: nowhere
    std::vector<std::string> peers;  ///< other programs that draw: NAME=COMMAND
};

/// False in a build without rendering, which must not call run_draw_bench.
bool can_draw();

/// Times images of campuses of half a million and two million triangles, on hills and among houses, drawn by
/// us and by the peers, or of a small one if `quick`, and prints the times and how they compare with the
/// targets. `csv` may be empty.
void run_draw_bench(int rounds, bool quick, const std::filesystem::path& csv, const DrawBench& bench);

}  // namespace campuswalk::tools::bench

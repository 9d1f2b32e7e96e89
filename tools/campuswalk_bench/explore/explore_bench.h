#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace campuswalk::tools::bench {

struct ExploreBench {
    std::filesystem::path data;         ///< of the models of others; empty: without them
    std::vector<std::string> campuses;  ///< only these; empty: all
    std::vector<std::string> allow;     ///< run, jump: what visitors do besides walking
    int walks = 10'000;                 ///< of the adversary on each campus
    int steered_walks = 100'000;        ///< likewise, steering in falls, on `dungeon`
    int routes = 1'000;                 ///< between random pairs of places on each campus
};

/// Explores campuses beside Recast, or a small one made in code if `quick`, sends random walkers out, and
/// prints scores and verdicts. `csv` may be empty. False if ours did anything wrong, whatever its speed.
bool run_explore_bench(int rounds, bool quick, const std::filesystem::path& csv, const ExploreBench& bench);

}  // namespace campuswalk::tools::bench

#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace campuswalk::tools::bench {

struct ExploreBench {
    int rounds = 5;
    bool quick = false;                   ///< a small campus made in code, few walks
    std::filesystem::path csv;            ///< empty: none
    std::filesystem::path data;           ///< of the models of others; empty: without them
    std::vector<std::string> campuses;    ///< only these; empty: all
    std::vector<std::string> allow;       ///< run, jump: what visitors do besides walking
    std::size_t walks = 10'000;           ///< of the adversary on each campus
    std::size_t steered_walks = 100'000;  ///< likewise, steering in falls, on `dungeon`
    std::size_t routes = 1'000;           ///< between random pairs of places on each campus
};

/// Explores campuses beside Recast, sends random walkers out, and prints scores and verdicts. False if ours
/// did anything wrong, whatever its speed.
bool run_explore_bench(const ExploreBench& bench);

}  // namespace campuswalk::tools::bench

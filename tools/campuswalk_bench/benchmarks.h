#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "tools/campuswalk_bench/draw/draw_bench.h"
#include "tools/campuswalk_bench/explore/explore_bench.h"

namespace campuswalk::tools {

struct BenchOptions {
    std::string which;           ///< one of bench_commands(), or kBenchAll
    std::filesystem::path csv;   ///< empty: none
    std::filesystem::path plot;  ///< of table1: *.svg or *.png; empty: none
    int rounds = 0;              ///< how often each query or tick is timed; 0: the case's default
    bench::DrawBench draw;
    bench::ExploreBench explore;
    std::vector<std::filesystem::path> models;  ///< of import: more files to read
    bool mixed = false;                         ///< of table1: include the paper's mixed reading
    bool quick = false;                         ///< small scenes, one round: to see that it works
};

struct BenchCommand {
    const char* name = "";
    const char* description = "";
};

inline constexpr const char* kBenchAll = "all";  ///< except for the three below
inline constexpr const char* kBenchDraw = "draw";
inline constexpr const char* kBenchExplore = "explore";
inline constexpr const char* kBenchWalk = "walk";

/// The benchmarks, without kBenchAll.
std::span<const BenchCommand> bench_commands();

/// Measures, prints, writes the CSV. Returns the exit code: kExpectationFailed if one of our own engines
/// returned a wrong answer.
int run_bench(const BenchOptions& options);

}  // namespace campuswalk::tools

#pragma once

#include <filesystem>

namespace campuswalk::tools {

struct Table1Options {
    std::filesystem::path csv;   ///< empty: none
    std::filesystem::path plot;  ///< *.svg or *.png; empty: none
    int rounds = 25;             ///< how often each query is timed
};

/// Measures the paper's Table I anew and prints it. Returns the exit code: kExpectationFailed when our own
/// engines don't agree on the pairs, or find another number of them than the table says.
int bench_table1(const Table1Options& options);

}  // namespace campuswalk::tools

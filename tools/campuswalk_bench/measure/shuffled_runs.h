#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <vector>

namespace campuswalk::tools::bench {

/// Microseconds.
struct Spread {
    double least = 0.0;
    double median = 0.0;
};

/// Times `count` things `rounds` times each, in one thread. Each round has an order of its own (from a fixed
/// seed), so that a machine that slows down slows all. A run is timed right after one that isn't, with what
/// it needs in the caches. `run(i)` does the i-th thing and says how long it took, microseconds.
std::vector<Spread> shuffled_runs(std::size_t count, int rounds,
                                  const std::function<double(std::size_t)>& run);

template <typename Work>
double microseconds_of(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace campuswalk::tools::bench

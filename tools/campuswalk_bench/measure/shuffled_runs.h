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

/// Times `count` tasks `rounds` times each, in one thread. Each round has its own order (from a fixed seed),
/// so that a slowdown of the machine affects all tasks. Each timed run follows an untimed one, so that the
/// caches are warm. `run(i)` runs task i and returns its microseconds.
std::vector<Spread> shuffled_runs(std::size_t count, int rounds,
                                  const std::function<double(std::size_t)>& run);

template <typename Work>
double microseconds_of(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace campuswalk::tools::bench

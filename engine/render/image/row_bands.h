#pragma once

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace campuswalk::engine::render {

/// Calls `work(first, end)` for bands of rows that together are 0 to `rows`, beside each other on the
/// machine's processors, and returns when all are done. For work that makes each row by itself: then it is
/// the same by any number of bands. `work` must not throw.
template <typename Work>
void for_row_bands(int rows, const Work& work) {
    // Whoever is free takes the next band: halves would be unequal, as most images have sky above.
    constexpr int kRows = 32;
    constexpr int kMostThreads = 8;
    std::atomic<int> next = 0;
    const auto work_on = [&] {
        for (int first = 0; (first = next.fetch_add(kRows)) < rows;) {
            work(first, std::min(first + kRows, rows));
        }
    };
    const int threads = std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1,
                                   std::clamp(rows / (2 * kRows), 1, kMostThreads));
    std::vector<std::jthread> others;
    for (int i = 1; i < threads; ++i) {
        others.emplace_back(work_on);
    }
    work_on();
}

}  // namespace campuswalk::engine::render

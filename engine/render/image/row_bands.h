#pragma once

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace campuswalk::engine::render {

/// Calls `work(first, end)` in parallel for bands that partition rows 0 to `rows`, and waits for all. If rows
/// are independent, the result doesn't depend on the number of threads. `work` must not throw.
template <typename Work>
void for_row_bands(int rows, const Work& work) {
    // Bands are assigned dynamically: equal shares would take unequal time, as most images have sky at the
    // top.
    constexpr int kRows = 32;
    constexpr int kMaxThreads = 8;
    std::atomic<int> next = 0;
    const auto work_on = [&] {
        for (int first = 0; (first = next.fetch_add(kRows)) < rows;) {
            work(first, std::min(first + kRows, rows));
        }
    };
    const int threads = std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1,
                                   std::clamp(rows / (2 * kRows), 1, kMaxThreads));
    std::vector<std::jthread> others;
    for (int i = 1; i < threads; ++i) {
        others.emplace_back(work_on);
    }
    work_on();
}

}  // namespace campuswalk::engine::render

#pragma once

#include <algorithm>
#include <thread>
#include <vector>

namespace campuswalk::engine::render {

/// Calls `work(first, end)` for bands of rows that together are 0 to `rows`, beside each other on the
/// machine's processors, and returns when all are done. For work that makes each row by itself: then it is
/// the same by any number of bands. `work` must not throw.
template <typename Work>
void for_row_bands(int rows, const Work& work) {
    constexpr int kLeastRows = 64;  // that are worth a thread
    constexpr int kMostBands = 8;
    const int bands = std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1,
                                 std::clamp(rows / kLeastRows, 1, kMostBands));
    std::vector<std::jthread> others;
    for (int band = 1; band < bands; ++band) {
        others.emplace_back(
            [&work, first = rows * band / bands, end = rows * (band + 1) / bands] { work(first, end); });
    }
    work(0, rows / bands);
}

}  // namespace campuswalk::engine::render

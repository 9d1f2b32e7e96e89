#include "scene/import/source/parallel_for.h"

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace campuswalk::scene {
namespace {

TEST(ParallelFor, CallsEachIndexOnce) {
    for (const std::size_t most : {0U, 1U, 3U, 100U}) {
        std::vector<int> done(20);
        parallel_for(done.size(), most, [&](std::size_t i) { ++done[i]; });
        EXPECT_EQ(done, std::vector<int>(20, 1)) << most;
    }
    parallel_for(0, 4, [](std::size_t) { FAIL(); });
}

TEST(ParallelFor, LimitsTheNumberOfThreads) {
    std::atomic<int> now = 0;
    std::atomic<int> highest = 0;
    parallel_for(12, 3, [&](std::size_t) {
        const int others = now++;
        for (int seen = highest; others + 1 > seen && !highest.compare_exchange_weak(seen, others + 1);) {
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        --now;
    });
    EXPECT_LE(highest, 3);
    EXPECT_GE(highest, 2) << "the threads wait concurrently";
}

}  // namespace
}  // namespace campuswalk::scene

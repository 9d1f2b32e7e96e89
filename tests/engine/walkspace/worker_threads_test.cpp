#include "engine/walkspace/worker_threads.h"

#include <atomic>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace campuswalk::engine {
namespace {

TEST(ForEachItem, WorksOnEachItemOnce) {
    for (const std::size_t workers : {1U, 2U, 3U, 8U}) {
        std::vector<std::atomic<int>> times(100);
        std::atomic<std::size_t> wrong_workers = 0;
        for_each_item(times.size(), workers, [&](std::size_t worker, std::size_t item) {
            ++times[item];
            wrong_workers += worker < workers ? 0 : 1;
        });
        for (const std::atomic<int>& count : times) {
            EXPECT_EQ(count, 1);
        }
        EXPECT_EQ(wrong_workers, 0U);
    }
}

TEST(ForEachItem, GivesEachThreadANumberOfItsOwn) {
    constexpr std::size_t kWorkers = 4;
    std::vector<std::atomic<int>> active(kWorkers);
    std::atomic<int> shared = 0;
    for_each_item(1000, kWorkers, [&](std::size_t worker, std::size_t) {
        shared += active[worker]++ == 0 ? 0 : 1;
        --active[worker];
    });
    EXPECT_EQ(shared, 0);
}

TEST(ForEachItem, DoesNothingWithoutItems) {
    for_each_item(0, 3, [](std::size_t, std::size_t) { FAIL(); });
}

TEST(ForEachItem, ThrowsWhatTheWorkThrows) {
    for (const std::size_t workers : {1U, 3U}) {
        EXPECT_THROW(for_each_item(10, workers,
                                   [](std::size_t, std::size_t item) {
                                       if (item == 7) {
                                           throw std::runtime_error("broken");
                                       }
                                   }),
                     std::runtime_error);
    }
}

}  // namespace
}  // namespace campuswalk::engine

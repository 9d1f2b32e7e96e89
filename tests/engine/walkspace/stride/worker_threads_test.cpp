#include "engine/walkspace/stride/worker_threads.h"

#include <atomic>
#include <chrono>
#include <future>
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

/// Each item comes after the two before it in its row, and the one above it.
std::vector<std::vector<std::size_t>> items_of_rows(std::size_t rows, std::size_t columns) {
    std::vector<std::vector<std::size_t>> after(rows * columns);
    for (std::size_t item = 0; item < after.size(); ++item) {
        for (const std::size_t back : {std::size_t{1}, std::size_t{2}}) {
            if (item % columns >= back) {
                after[item].push_back(item - back);
            }
        }
        if (item >= columns) {
            after[item].push_back(item - columns);
        }
    }
    return after;
}

TEST(ForEachItemInOrder, WorksOnEachItemOnceAfterThoseBeforeIt) {
    const auto after = items_of_rows(20, 30);
    for (const std::size_t workers : {1U, 2U, 5U}) {
        std::vector<int> times(after.size(), 0);  // not atomic: what an item reads is done
        std::atomic<int> too_early = 0;
        for_each_item_in_order(after, workers, [&](std::size_t, std::size_t item) {
            for (const std::size_t earlier : after[item]) {
                too_early += times[earlier] == 1 ? 0 : 1;
            }
            ++times[item];
        });
        EXPECT_EQ(too_early, 0);
        EXPECT_EQ(times, std::vector<int>(after.size(), 1));
    }
}

TEST(ForEachItemInOrder, WaitsForOneItemAloneWhereOthersMayGoOn) {
    // 1 and 3 come after 0, which isn't done until 2 is.
    const std::vector<std::vector<std::size_t>> after{{}, {0}, {}, {0}};
    std::atomic<bool> two_is_done = false;
    std::atomic<int> done = 0;
    for_each_item_in_order(after, 2, [&](std::size_t, std::size_t item) {
        if (item == 0) {
            two_is_done.wait(false);
        } else if (item == 2) {
            two_is_done = true;
            two_is_done.notify_all();
        }
        ++done;
    });
    EXPECT_EQ(done, 4);
}

TEST(ForEachItemInOrder, ThrowsThoughOthersWait) {
    for (const std::size_t workers : {1U, 3U}) {
        std::atomic<int> later = 0;
        EXPECT_THROW(for_each_item_in_order({{}, {0}, {0}, {1, 2}}, workers,
                                            [&](std::size_t, std::size_t item) {
                                                if (item == 0) {
                                                    throw std::runtime_error("broken");
                                                }
                                                ++later;
                                            }),
                     std::runtime_error);
        EXPECT_EQ(later, 0);
    }
}

/// Item 3 comes after item 2: that is taken before the two that nothing waits for, which wait for it here.
TEST(ForEachItemInOrder, BeginsWithWhatOthersWaitFor) {
    std::promise<void> has_begun;
    const std::shared_future<void> begun = has_begun.get_future().share();
    std::atomic<int> waited_in_vain = 0;
    for_each_item_in_order({{}, {}, {}, {2}}, 2, [&](std::size_t, std::size_t item) {
        if (item == 2) {
            has_begun.set_value();
        } else if (begun.wait_for(std::chrono::seconds(5)) != std::future_status::ready) {
            ++waited_in_vain;
        }
    });
    EXPECT_EQ(waited_in_vain, 0);
}

}  // namespace
}  // namespace campuswalk::engine

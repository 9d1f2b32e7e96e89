#include "engine/walkspace/worker_threads.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <vector>

namespace campuswalk::engine {

void for_each_item(std::size_t items, std::size_t workers,
                   const std::function<void(std::size_t worker, std::size_t item)>& work) {
    const std::size_t threads = std::min(items, workers);
    std::atomic<std::size_t> next = 0;
    std::vector<std::exception_ptr> failures(std::max<std::size_t>(threads, 1));
    const auto run = [&](std::size_t worker) {
        try {
            for (std::size_t i = next++; i < items; i = next++) {
                work(worker, i);
            }
        } catch (...) {
            failures[worker] = std::current_exception();
        }
    };
    {
        std::vector<std::jthread> others;
        for (std::size_t worker = 1; worker < threads; ++worker) {
            others.emplace_back(run, worker);
        }
        run(0);
    }
    for (const std::exception_ptr& failure : failures) {
        if (failure) {
            std::rethrow_exception(failure);
        }
    }
}

}  // namespace campuswalk::engine

#include "scene/import/source/parallel_for.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace campuswalk::scene {

void parallel_for(std::size_t count, std::size_t max_threads, const std::function<void(std::size_t)>& work) {
    std::atomic<std::size_t> next = 0;
    const auto run = [&] {
        for (std::size_t i = next++; i < count; i = next++) {
            work(i);
        }
    };
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < std::min(count, max_threads); ++i) {
        others.emplace_back(run);
    }
    run();
}

}  // namespace campuswalk::scene

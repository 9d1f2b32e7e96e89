#include "tools/campuswalk_bench/measure/shuffled_runs.h"

#include <algorithm>
#include <random>
#include <utility>

namespace campuswalk::tools::bench {

namespace {

/// Fisher-Yates; the order of std::shuffle depends on the standard library.
void shuffle(std::vector<std::size_t>& order, std::mt19937& random) {
    for (std::size_t i = order.size(); i > 1; --i) {
        std::swap(order[i - 1], order[random() % i]);
    }
}

}  // namespace

std::vector<Spread> shuffled_runs(std::size_t count, int rounds,
                                  const std::function<double(std::size_t)>& run) {
    std::vector<std::size_t> order(count);
    for (std::size_t i = 0; i < count; ++i) {
        order[i] = i;
    }
    std::vector<std::vector<double>> times(count);
    std::mt19937 random(1975);
    for (int round = 0; round < rounds; ++round) {
        shuffle(order, random);
        for (const std::size_t i : order) {
            run(i);
            times[i].push_back(run(i));
        }
    }
    std::vector<Spread> spreads;
    for (std::vector<double>& of_one : times) {
        std::sort(of_one.begin(), of_one.end());
        spreads.push_back({of_one.front(), of_one[of_one.size() / 2]});
    }
    return spreads;
}

}  // namespace campuswalk::tools::bench

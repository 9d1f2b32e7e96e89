#include "tools/campuswalk/run/plan/balance.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <queue>
#include <utility>

#include "tools/campuswalk/run/plan/shard.h"

namespace campuswalk::tools {

namespace {

std::vector<int> consecutive(std::size_t items, int shards) {
    std::vector<int> shard_of(items, 0);
    for (int index = 0; index < shards; ++index) {
        const Slice slice = slice_of(items, {index, shards, "", ""});
        std::fill(shard_of.begin() + static_cast<std::ptrdiff_t>(slice.first),
                  shard_of.begin() + static_cast<std::ptrdiff_t>(slice.last), index);
    }
    return shard_of;
}

}  // namespace

std::vector<int> balanced(const std::vector<std::optional<std::uint64_t>>& times, int shards) {
    std::uint64_t sum = 0;
    std::uint64_t known = 0;
    for (const std::optional<std::uint64_t>& time : times) {
        sum += time.value_or(0);
        known += time ? 1U : 0U;
    }
    if (known == 0) {
        return consecutive(times.size(), shards);
    }
    const std::uint64_t mean = sum / known;
    std::vector<std::size_t> longest_first(times.size());
    std::iota(longest_first.begin(), longest_first.end(), std::size_t{0});
    std::ranges::stable_sort(longest_first, std::greater<>(),
                             [&](std::size_t item) { return times[item].value_or(mean); });
    using Load = std::pair<std::uint64_t, int>;
    std::priority_queue<Load, std::vector<Load>, std::greater<>> least_loaded;
    for (int shard = 0; shard < shards; ++shard) {
        least_loaded.emplace(0U, shard);
    }
    std::vector<int> shard_of(times.size(), 0);
    for (const std::size_t item : longest_first) {
        const auto [load, shard] = least_loaded.top();
        least_loaded.pop();
        shard_of[item] = shard;
        least_loaded.emplace(load + std::max<std::uint64_t>(1, times[item].value_or(mean)), shard);
    }
    return shard_of;
}

}  // namespace campuswalk::tools

// Components of random graphs against what can be reached from where, by brute force.

#include "engine/walkspace/space/strong_components.h"

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace campuswalk::engine {
namespace {

using Edges = std::vector<std::vector<std::uint32_t>>;

/// By Warshall's algorithm.
std::vector<std::vector<bool>> reachable(const Edges& targets) {
    std::vector<std::vector<bool>> leads(targets.size(), std::vector<bool>(targets.size(), false));
    for (std::size_t from = 0; from < targets.size(); ++from) {
        leads[from][from] = true;
        for (const std::uint32_t to : targets[from]) {
            leads[from][to] = true;
        }
    }
    for (std::size_t by = 0; by < targets.size(); ++by) {
        for (std::size_t from = 0; from < targets.size(); ++from) {
            for (std::size_t to = 0; leads[from][by] && to < targets.size(); ++to) {
                leads[from][to] = leads[from][to] || leads[by][to];
            }
        }
    }
    return leads;
}

TEST(StrongComponents, AreWhatLeadsThereAndBack) {
    std::mt19937 random(7);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same in every run
    for (int round = 0; round < 300; ++round) {
        const std::size_t count = 1 + random() % 30;
        Edges targets(count);
        for (std::size_t edge = 0; edge < random() % (3 * count); ++edge) {
            targets[random() % count].push_back(static_cast<std::uint32_t>(random() % count));
        }
        const std::vector<std::uint32_t> found = strong_components(targets);
        const auto leads = reachable(targets);
        ASSERT_EQ(found.size(), count);
        for (std::size_t a = 0; a < count; ++a) {
            std::uint32_t least = 0;
            while (!leads[a][least] || !leads[least][a]) {
                ++least;
            }
            EXPECT_EQ(found[a], least);
        }
    }
}

TEST(StrongComponents, MayHaveLongPaths) {
    constexpr std::uint32_t kLength = 1'000'000;
    Edges ring(kLength);
    for (std::uint32_t i = 0; i < kLength; ++i) {
        ring[i].push_back((i + 1) % kLength);
    }
    EXPECT_EQ(strong_components(ring), std::vector<std::uint32_t>(kLength, 0));
    ring.back().clear();
    EXPECT_EQ(strong_components(ring)[kLength - 1], kLength - 1);
    EXPECT_TRUE(strong_components({}).empty());
}

}  // namespace
}  // namespace campuswalk::engine

#include "engine/observers/key_frames.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/dice.h"

namespace campuswalk::engine {
namespace {

std::vector<KeyFrame> thinned(const std::vector<PathSample>& samples, const std::vector<Tick>& cuts = {}) {
    std::vector<KeyFrame> keys;
    KeyFrames frames([&](const KeyFrame& key) { keys.push_back(key); });
    for (const PathSample& sample : samples) {
        frames.add(sample, std::ranges::find(cuts, sample.tick) != cuts.end());
    }
    frames.finish();
    return keys;
}

/// What a reader computes at a tick.
double shown(const std::vector<KeyFrame>& keys, Tick tick, std::size_t i) {
    std::size_t k = 0;
    while (k + 1 < keys.size() && keys[k + 1].tick <= tick) {
        ++k;
    }
    const auto from = static_cast<double>(keys[k].values[i]);
    if (k + 1 == keys.size() || keys[k + 1].cut) {
        return from;
    }
    const double share =
        static_cast<double>(tick - keys[k].tick) / static_cast<double>(keys[k + 1].tick - keys[k].tick);
    return from + share * (static_cast<double>(keys[k + 1].values[i]) - from);
}

void expect_close(const std::vector<PathSample>& samples, const std::vector<KeyFrame>& keys) {
    for (const PathSample& sample : samples) {
        for (std::size_t i = 0; i < PathSample::kSize; ++i) {
            ASSERT_NEAR(shown(keys, sample.tick, i), sample.values[i], i < 3 ? 0.501 : 1.001)
                << "tick " << sample.tick << ", value " << i;
        }
    }
}

using support::Dice;

TEST(KeyFrames, KeepTheEndsOfAStraightPath) {
    std::vector<PathSample> samples;
    for (Tick tick = 0; tick < 1000; ++tick) {
        const auto t = static_cast<double>(tick);
        samples.push_back({tick, {0.3 + 23.3333 * t, -7.77, 5.5 - 1.234 * t, 45.0, 0.0}});
    }
    const std::vector<KeyFrame> keys = thinned(samples);
    ASSERT_EQ(keys.size(), 2U);
    EXPECT_EQ(keys[0].tick, 0);
    EXPECT_EQ(keys[1].tick, 999);
    expect_close(samples, keys);
}

TEST(KeyFrames, StayCloseOnAnyPath) {
    Dice dice(7);
    std::vector<PathSample> samples;
    std::array<double, PathSample::kSize> at = {1e5, -3e3, -2e5, 0.0, 0.0};
    std::array<double, PathSample::kSize> speed = {};
    for (Tick tick = 0; tick < 20'000; ++tick) {
        if (dice.below(31) == 0) {
            for (double& each : speed) {
                each = dice.below(4) == 0 ? 0.0 : dice.between(-30.0, 30.0);
            }
        }
        for (std::size_t i = 0; i < at.size(); ++i) {
            at[i] += speed[i] + (dice.below(51) == 0 ? dice.between(-1.0, 1.0) : 0.0);
        }
        samples.push_back({tick, at});
    }
    const std::vector<KeyFrame> keys = thinned(samples);
    EXPECT_LT(keys.size(), samples.size() / 2);
    expect_close(samples, keys);
}

TEST(KeyFrames, FollowAFallWithinHalfAMillimetre) {
    std::vector<PathSample> samples;
    for (Tick tick = 0; tick < 120; ++tick) {
        const double seconds = static_cast<double>(tick) / 60.0;
        samples.push_back({tick, {0.0, 10'000.0 - 4905.0 * seconds * seconds, 0.0, 0.0, 0.0}});
    }
    expect_close(samples, thinned(samples));
}

TEST(KeyFrames, HoldUntilACut) {
    std::vector<PathSample> samples;
    for (Tick tick = 0; tick < 20; ++tick) {
        samples.push_back({tick, {tick < 10 ? 10.0 * static_cast<double>(tick) : 9000.0, 0, 0, 0, 0}});
    }
    const std::vector<KeyFrame> keys = thinned(samples, {0, 10});
    ASSERT_EQ(keys.size(), 4U);
    EXPECT_TRUE(keys[0].cut);
    EXPECT_EQ(keys[1].tick, 9);
    EXPECT_FALSE(keys[1].cut);
    EXPECT_EQ(keys[2].tick, 10);
    EXPECT_TRUE(keys[2].cut);
    expect_close(samples, keys);
}

TEST(KeyFrames, TwoCutsInARow) {
    const std::vector<PathSample> samples = {
        {0, {0, 0, 0, 0, 0}}, {1, {5, 0, 0, 0, 0}}, {2, {9, 0, 0, 0, 0}}};
    const std::vector<KeyFrame> keys = thinned(samples, {0, 1, 2});
    ASSERT_EQ(keys.size(), 3U);
    EXPECT_TRUE(keys[0].cut && keys[1].cut && keys[2].cut);
}

}  // namespace
}  // namespace campuswalk::engine

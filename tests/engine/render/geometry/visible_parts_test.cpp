#include "engine/render/geometry/visible_parts.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace campuswalk::engine::render::test {
namespace {

std::size_t at(int x, int y, int width) {
    const int number = y * width + x;
    return static_cast<std::size_t>(number);
}

/// Brute force over all pixels of other owners and a border around the image.
int depth_at(const std::vector<std::uint32_t>& owners, int width, int x, int y) {
    const int height = static_cast<int>(owners.size()) / width;
    const auto owner = [&](int u, int v) {
        const bool inside = u >= 0 && v >= 0 && u < width && v < height;
        return inside ? static_cast<int>(owners[at(u, v, width)]) : -1;
    };
    int nearest = std::numeric_limits<int>::max();
    for (int v = -1; v <= height; ++v) {
        for (int u = -1; u <= width; ++u) {
            if (owner(u, v) != owner(x, y)) {
                nearest = std::min(nearest, std::abs(u - x) + 4 * std::abs(v - y));
            }
        }
    }
    return nearest;
}

TEST(VisibleParts, DeepestPixelIsFarthestFromOtherOwners) {
    std::mt19937 random(5);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same in every run
    constexpr int kWidth = 40;
    constexpr int kHeight = 20;
    for (int round = 0; round < 40; ++round) {
        std::vector<std::uint32_t> owners(std::size_t{kWidth} * kHeight,
                                          3);                // 3 is not one of the requested owners
        for (std::uint32_t owner = 0; owner < 3; ++owner) {  // boxes over each other
            const int left = static_cast<int>(random() % 30);
            const int top = static_cast<int>(random() % 15);
            for (int y = top; y < std::min(kHeight, top + 3 + static_cast<int>(random() % 9)); ++y) {
                for (int x = left; x < std::min(kWidth, left + 4 + static_cast<int>(random() % 25)); ++x) {
                    owners[at(x, y, kWidth)] = owner;
                }
            }
        }
        for (const VisiblePart& part : visible_parts(owners, kWidth, 3)) {
            int deepest = 0;
            std::size_t pixels = 0;
            for (int y = 0; y < kHeight; ++y) {
                for (int x = 0; x < kWidth; ++x) {
                    if (owners[at(x, y, kWidth)] == part.owner) {
                        ++pixels;
                        deepest = std::max(deepest, depth_at(owners, kWidth, x, y));
                    }
                }
            }
            EXPECT_EQ(part.pixels, pixels);
            const int x = static_cast<int>(part.deepest.x());
            const int y = static_cast<int>(part.deepest.y());
            EXPECT_EQ(owners[at(x, y, kWidth)], part.owner);
            EXPECT_EQ(depth_at(owners, kWidth, x, y), deepest);
        }
    }
}

TEST(VisibleParts, ListVisibleOwnersOnly) {
    const std::vector<std::uint32_t> owners = {0, 0, 7, 2};
    const auto parts = visible_parts(owners, 4, 3);
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_EQ(parts[0].owner, 0U);
    EXPECT_EQ(parts[0].pixels, 2U);
    EXPECT_EQ(parts[1].owner, 2U);
    EXPECT_TRUE(visible_parts({}, 4, 3).empty());
}

}  // namespace
}  // namespace campuswalk::engine::render::test

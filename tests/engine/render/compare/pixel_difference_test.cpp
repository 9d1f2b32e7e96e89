#include "engine/render/compare/pixel_difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tests/engine/render/color_names.h"
#include "tests/engine/render/compare/synthetic_images.h"

namespace campuswalk::engine::render::test {
namespace {

using Rgb = std::array<std::uint8_t, 3>;

PixelDifference difference_of(const Image& a, const Image& b, double threshold = 0.2) {
    return pixel_difference(a, b, threshold, ImageMask(a.width, a.height, {}));
}

std::size_t count(const PixelDifference& difference, PixelVerdict verdict) {
    return static_cast<std::size_t>(std::ranges::count(difference.verdicts, verdict));
}

void put(Image& image, int x, int y, const Rgb& color) {
    std::ranges::copy(color, image.rgba.begin() + static_cast<std::ptrdiff_t>(image.offset(x, y)));
}

double distance(const Rgb& a, const Rgb& b) {
    return color_distance(a.data(), b.data());
}

TEST(ColorDistance, MatchesThePapersMatrix) {
    EXPECT_EQ(distance({12, 34, 56}, {12, 34, 56}), 0.0);
    // Greys differ only in Y: sqrt(0.5053 / 35215) * levels.
    for (const int levels : {1, 15, 100, 255}) {
        const auto grey = static_cast<std::uint8_t>(levels);
        EXPECT_NEAR(distance({0, 0, 0}, {grey, grey, grey}), levels * std::sqrt(0.5053 / 35215.0), 1e-7);
    }
    const double red = 255 * std::sqrt((0.5053 * 0.29889531 * 0.29889531 + 0.299 * 0.59597799 * 0.59597799 +
                                        0.1957 * 0.21147017 * 0.21147017) /
                                       35215.0);
    EXPECT_NEAR(distance({0, 9, 200}, {255, 9, 200}), red, 1e-9);
    EXPECT_EQ(distance({1, 2, 3}, {40, 5, 6}), distance({40, 5, 6}, {1, 2, 3}));
}

TEST(ColorDistance, IsAtMostOne) {
    double farthest = 0.0;
    for (unsigned mask = 0; mask < 64; ++mask) {
        const auto channel = [&](unsigned bit) {
            return static_cast<std::uint8_t>((mask >> bit) % 2 == 0 ? 0 : 255);
        };
        farthest = std::max(
            farthest, distance({channel(0), channel(1), channel(2)}, {channel(3), channel(4), channel(5)}));
    }
    EXPECT_NEAR(farthest, 1.0, 1e-4);
    EXPECT_LE(farthest, 1.0);
}

TEST(PixelDifference, CountsPixelsBeyondTheThreshold) {
    const Image a = plain_image(20, 10, {100, 100, 100});
    Image b = a;
    put(b, 3, 4, {101, 100, 100});  // close
    put(b, 9, 4, {200, 200, 200});
    put(b, 0, 0, {0, 0, 0});
    put(b, 19, 9, {255, 0, 0});
    const PixelDifference difference = difference_of(a, b);
    EXPECT_EQ(difference.different, 3U);
    EXPECT_EQ(count(difference, PixelVerdict::different), 3U);
    EXPECT_EQ(count(difference, PixelVerdict::close), 1U);
    EXPECT_EQ(count(difference, PixelVerdict::same), 196U);
    EXPECT_EQ(difference.verdicts[4 * 20 + 9], PixelVerdict::different);
}

TEST(PixelDifference, TheThresholdItselfIsWithin) {
    const Image a = plain_image(3, 3, {0, 0, 0});
    const Image b = plain_image(3, 3, {50, 50, 50});
    const double apart = distance({0, 0, 0}, {50, 50, 50});
    EXPECT_EQ(difference_of(a, b, apart + 1e-9).different, 0U);
    EXPECT_EQ(difference_of(a, b, apart - 1e-9).different, 9U);
    EXPECT_EQ(difference_of(a, a, 0.0).different, 0U);
    EXPECT_EQ(difference_of(a, plain_image(3, 3, {0, 0, 1}), 0.0).different, 9U);
}

/// Black above and white below a slanted line, anti-aliased by coverage.
Image slanted_edge(double offset) {
    Image image = plain_image(40, 40, {0, 0, 0});
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 40; ++x) {
            const double below = std::clamp(y + 1.0 - (10.3 + 0.4 * x + offset), 0.0, 1.0);
            const auto grey = static_cast<std::uint8_t>(std::lround(255.0 * below));
            put(image, x, y, {grey, grey, grey});
        }
    }
    return image;
}

TEST(PixelDifference, AcceptsDifferentlyAntialiasedEdges) {
    const PixelDifference difference = difference_of(slanted_edge(0.0), slanted_edge(0.45));
    EXPECT_EQ(difference.different, 0U);
    EXPECT_GT(count(difference, PixelVerdict::antialiased), 15U);
}

TEST(PixelDifference, RejectsMovedEdges) {
    EXPECT_GT(difference_of(slanted_edge(0.0), slanted_edge(3.0)).different, 40U);
}

TEST(PixelDifference, RejectsDifferencesWithinAnArea) {
    const Image a = plain_image(9, 9, {128, 128, 128});
    Image b = a;
    put(b, 4, 4, {255, 255, 255});
    EXPECT_EQ(difference_of(a, b).different, 1U) << "brighter than all its neighbours";
}

TEST(PixelDifference, IsSymmetric) {
    std::mt19937 random(7);
    for (const Image& a : {noise(60, 40, random), slanted_edge(0.0)}) {
        const Image b = disturbed(a, 0.4, 120, random);
        const PixelDifference there = difference_of(a, b);
        const PixelDifference back = difference_of(b, a);
        EXPECT_EQ(there.verdicts, back.verdicts);
        EXPECT_EQ(there.different, back.different);
        EXPECT_GT(there.different, 0U);
    }
}

TEST(PixelDifference, IgnoresMaskedPixels) {
    const Image a = plain_image(10, 10, {0, 0, 0});
    const Image b = plain_image(10, 10, {255, 255, 255});
    const std::vector<PixelBox> boxes = {{2, 3, 4, 5}, {8, 8, 100, 100}, {5, 5, -1, 3}};
    const PixelDifference difference = pixel_difference(a, b, 0.2, ImageMask(10, 10, boxes));
    EXPECT_EQ(difference.different, 100U - 20U - 4U);
    EXPECT_EQ(count(difference, PixelVerdict::masked), 24U);
    EXPECT_EQ(difference.verdicts[3 * 10 + 2], PixelVerdict::masked);
    EXPECT_EQ(difference.verdicts[3 * 10 + 6], PixelVerdict::different);
}

TEST(PixelDifference, AcceptsImagesOfOnePixel) {
    EXPECT_EQ(difference_of(plain_image(1, 1, {0, 0, 0}), plain_image(1, 1, {255, 255, 255})).different, 1U);
}

}  // namespace
}  // namespace campuswalk::engine::render::test

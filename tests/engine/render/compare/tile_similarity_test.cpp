#include "engine/render/compare/tile_similarity.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tests/engine/render/color_names.h"
#include "tests/engine/render/compare/synthetic_images.h"

namespace campuswalk::engine::render::test {
namespace {

constexpr double kC1 = 6.5025;
constexpr double kC2 = 58.5225;

std::vector<TileSimilarity> tiles_of(const Image& a, const Image& b, std::span<const PixelBox> masks = {}) {
    return tile_similarities(a, b, ImageMask(a.width, a.height, masks));
}

double worst_of(const Image& a, const Image& b, std::span<const PixelBox> masks = {}) {
    return std::ranges::min(tiles_of(a, b, masks), {}, &TileSimilarity::ssim).ssim;
}

double brightness(const Image& image, int x, int y) {
    const auto [r, g, b] = image.pixel(x, y);
    return std::floor((77.0 * r + 150.0 * g + 29.0 * b + 128.0) / 256.0);
}

/// SSIM by the paper's formula: two passes over the window's pixels, means first.
double plain_window(const Image& a, const Image& b, const ImageMask& mask, int left, int top, int* pixels) {
    double n = 0.0;
    double mean_a = 0.0;
    double mean_b = 0.0;
    const auto each = [&](const auto& visit) {
        for (int y = top; y < std::min(top + 8, a.height); ++y) {
            for (int x = left; x < std::min(left + 8, a.width); ++x) {
                if (!mask.hides(x, y)) {
                    visit(brightness(a, x, y), brightness(b, x, y));
                }
            }
        }
    };
    each([&](double value_a, double value_b) {
        n += 1.0;
        mean_a += value_a;
        mean_b += value_b;
    });
    *pixels = static_cast<int>(n);
    if (n == 0.0) {
        return 1.0;
    }
    mean_a /= n;
    mean_b /= n;
    double variance_a = 0.0;
    double variance_b = 0.0;
    double covariance = 0.0;
    each([&](double value_a, double value_b) {
        variance_a += (value_a - mean_a) * (value_a - mean_a) / n;
        variance_b += (value_b - mean_b) * (value_b - mean_b) / n;
        covariance += (value_a - mean_a) * (value_b - mean_b) / n;
    });
    return (2 * mean_a * mean_b + kC1) * (2 * covariance + kC2) /
           ((mean_a * mean_a + mean_b * mean_b + kC1) * (variance_a + variance_b + kC2));
}

/// Window positions along a side: every 4 pixels while they add pixels.
std::vector<int> starts(int side) {
    std::vector<int> at = {0};
    while (at.back() + 8 < side) {
        at.push_back(at.back() + 4);
    }
    return at;
}

/// Mean of the windows that start in the tile, weighted by their size within the image; masked pixels count
/// as equal.
double plain_tile(const Image& a, const Image& b, const ImageMask& mask, const PixelBox& box) {
    double sum = 0.0;
    double weight = 0.0;
    for (const int y : starts(a.height)) {
        for (const int x : starts(a.width)) {
            if (x < box.x || y < box.y || x >= box.x + 64 || y >= box.y + 64) {
                continue;
            }
            int pixels = 0;
            const double ssim = plain_window(a, b, mask, x, y, &pixels);
            const double whole = std::min(8, a.width - x) * std::min(8, a.height - y);
            sum += pixels * ssim + (whole - pixels);
            weight += whole;
        }
    }
    return sum / weight;
}

TEST(TileSimilarity, MatchesAPlainImplementation) {
    std::mt19937 random(1);
    const std::vector<PixelBox> masks = {{10, 5, 30, 20}, {60, 60, 200, 3}, {-5, -5, 7, 7}};
    for (const auto& [width, height] :
         {std::pair(200, 150), std::pair(131, 67), std::pair(64, 64), std::pair(9, 7), std::pair(1, 1),
          std::pair(300, 2), std::pair(68, 69)}) {
        const Image a = noise(width, height, random);
        const Image b = disturbed(a, 0.5, 60, random);
        for (const std::span<const PixelBox> hidden : {std::span<const PixelBox>(), std::span(masks)}) {
            const ImageMask mask(width, height, hidden);
            const std::vector<TileSimilarity> tiles = tile_similarities(a, b, mask);
            for (const TileSimilarity& tile : tiles) {
                EXPECT_NEAR(tile.ssim, plain_tile(a, b, mask, tile.box), 1e-9)
                    << width << "x" << height << " at " << tile.box.x << "," << tile.box.y;
            }
        }
    }
}

TEST(TileSimilarity, TilesCoverTheImage) {
    for (const int side : {1, 8, 63, 64, 65, 68, 69, 128, 180, 720}) {
        const Image image = plain_image(side, 64, {9, 9, 9});
        int covered = 0;
        for (const TileSimilarity& tile : tiles_of(image, image)) {
            EXPECT_LE(tile.box.x, covered) << "no gap";
            EXPECT_LE(tile.box.x + tile.box.width, side);
            EXPECT_EQ(tile.box.width, std::min(side, 64));
            covered = tile.box.x + tile.box.width;
        }
        // The windows that begin in the last tile reach four pixels beyond it.
        EXPECT_GE(covered + 4, side);
    }
}

TEST(TileSimilarity, MatchesTheFormulaForUniformImages) {
    for (const auto& [a, b] :
         {std::pair(0, 255), std::pair(100, 110), std::pair(200, 200), std::pair(3, 1)}) {
        const auto grey = [](int value) {
            const auto byte = static_cast<std::uint8_t>(value);
            return plain_image(100, 80, {byte, byte, byte});
        };
        const double expected = (2.0 * a * b + kC1) / (1.0 * a * a + 1.0 * b * b + kC1);
        for (const TileSimilarity& tile : tiles_of(grey(a), grey(b))) {
            EXPECT_NEAR(tile.ssim, expected, 1e-12);
        }
    }
}

TEST(TileSimilarity, IsNegativeForANegativeImage) {
    std::mt19937 random(2);
    const Image image = noise(64, 64, random);
    Image negative = image;
    for (std::size_t i = 0; i < negative.rgba.size(); ++i) {
        if (i % 4 != 3) {
            negative.rgba[i] = static_cast<std::uint8_t>(255 - negative.rgba[i]);
        }
    }
    EXPECT_LT(worst_of(image, negative), -0.8);
}

TEST(TileSimilarity, IsExactlyOneForEqualImagesAndSymmetric) {
    std::mt19937 random(3);
    const Image a = noise(150, 90, random);
    const Image b = disturbed(a, 0.3, 40, random);
    for (const TileSimilarity& tile : tiles_of(a, a)) {
        EXPECT_EQ(tile.ssim, 1.0);
    }
    const auto there = tiles_of(a, b);
    const auto back = tiles_of(b, a);
    ASSERT_EQ(there.size(), back.size());
    for (std::size_t i = 0; i < there.size(); ++i) {
        EXPECT_EQ(there[i].ssim, back[i].ssim);
    }
}

TEST(TileSimilarity, DecreasesWithNoise) {
    std::mt19937 random(4);
    const Image a = noise(64, 64, random);
    double before = 1.0;
    for (const double share : {0.1, 0.3, 0.9}) {
        const double now = worst_of(a, disturbed(a, share, 80, random));
        EXPECT_LT(now, before);
        before = now;
    }
}

TEST(TileSimilarity, IgnoresMaskedPixels) {
    std::mt19937 random(5);
    const Image a = noise(200, 100, random);
    Image b = a;
    for (int y = 20; y < 40; ++y) {
        for (int x = 50; x < 90; ++x) {
            b.rgba[b.offset(x, y)] ^= 0x80U;
        }
    }
    const std::vector<PixelBox> whole = {{50, 20, 40, 20}};
    const std::vector<PixelBox> half = {{50, 20, 40, 10}};
    EXPECT_EQ(worst_of(a, b, whole), 1.0);
    EXPECT_LT(worst_of(a, b, half), 0.99);
    EXPECT_GT(worst_of(a, b, half), worst_of(a, b));
    const std::vector<PixelBox> all = {{0, 0, 1'000'000'000, 1'000'000'000}};
    EXPECT_EQ(worst_of(a, noise(200, 100, random), all), 1.0);
}

}  // namespace
}  // namespace campuswalk::engine::render::test

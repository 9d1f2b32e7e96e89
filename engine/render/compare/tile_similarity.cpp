#include "engine/render/compare/tile_similarity.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "engine/render/image/row_bands.h"

namespace campuswalk::engine::render {
namespace {

constexpr int kBlock = 4;         ///< pixels per side; a window is 2 x 2 blocks
constexpr int kTileWindows = 16;  ///< per side
constexpr double kC1 = 0.01 * 255 * 0.01 * 255;
constexpr double kC2 = 0.03 * 255 * 0.03 * 255;

/// Integers, so that windows can be summed from blocks in any order without rounding.
struct Sums {
    std::uint32_t pixels = 0;
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    std::uint32_t squares = 0;  ///< of both
    std::uint32_t products = 0;

    void add(std::uint32_t value_a, std::uint32_t value_b) {
        ++pixels;
        a += value_a;
        b += value_b;
        squares += value_a * value_a + value_b * value_b;
        products += value_a * value_b;
    }
    Sums& operator+=(const Sums& other) {
        pixels += other.pixels;
        a += other.a;
        b += other.b;
        squares += other.squares;
        products += other.products;
        return *this;
    }
};

std::uint32_t brightness(const std::uint8_t* rgb) {
    return (77U * rgb[0] + 150U * rgb[1] + 29U * rgb[2] + 128U) >> 8U;
}

double ssim(const Sums& window) {
    const double n = window.pixels;
    const double mean_a = window.a / n;
    const double mean_b = window.b / n;
    const double squared_means = mean_a * mean_a + mean_b * mean_b;
    const double variances = window.squares / n - squared_means;
    const double covariance = window.products / n - mean_a * mean_b;
    // Exactly 1 for equal images: both fractions have bitwise equal factors.
    return (2 * mean_a * mean_b + kC1) * (2 * covariance + kC2) / ((squared_means + kC1) * (variances + kC2));
}

/// The sums of all blocks, row-major; blocks at the right and lower border may be smaller.
class Blocks {
public:
    Blocks(const Image& a, const Image& b, const ImageMask& mask)
        : columns_(blocks_along(a.width)), rows_(blocks_along(a.height)) {
        sums_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
        for_row_bands(rows_, [&](int first, int end) {
            for (int y = first * kBlock; y < std::min(end * kBlock, a.height); ++y) {
                add_row(a, b, mask, y);
            }
        });
    }

    int columns() const { return columns_; }
    int rows() const { return rows_; }

    /// The window whose upper left block this is.
    Sums window(int column, int row) const {
        Sums sums;
        for (int y = row; y < std::min(row + 2, rows_); ++y) {
            for (int x = column; x < std::min(column + 2, columns_); ++x) {
                sums += sums_[index(x, y)];
            }
        }
        return sums;
    }

private:
    static int blocks_along(int pixels) { return (pixels + kBlock - 1) / kBlock; }
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column);
    }

    void add_row(const Image& a, const Image& b, const ImageMask& mask, int y) {
        const std::uint8_t* from_a = &a.rgba[a.offset(0, y)];
        const std::uint8_t* from_b = &b.rgba[b.offset(0, y)];
        for (int column = 0; column < columns_; ++column) {
            Sums sums = sums_[index(column, y / kBlock)];
            for (int x = column * kBlock; x < std::min((column + 1) * kBlock, a.width); ++x) {
                if (!mask.hides(x, y)) {
                    const std::ptrdiff_t at = std::ptrdiff_t{4} * x;
                    sums.add(brightness(from_a + at), brightness(from_b + at));
                }
            }
            sums_[index(column, y / kBlock)] = sums;
        }
    }

    int columns_;
    int rows_;
    std::vector<Sums> sums_;
};

/// First windows of the tiles in a row.
std::vector<int> tile_starts(int windows) {
    std::vector<int> starts;
    for (int at = 0; at < windows; at += kTileWindows) {
        starts.push_back(std::max(0, std::min(at, windows - kTileWindows)));
    }
    return starts;
}

/// Side length of an unmasked window, pixels.
int window_length(int first_block, int pixels) {
    return std::min(2 * kBlock, pixels - first_block * kBlock);
}

struct Windows {
    int columns = 0;
    int rows = 0;
};

double tile_ssim(const Blocks& blocks, const Windows& windows, const Image& image, int column, int row) {
    double lost = 0.0;
    double weight = 0.0;
    for (int y = row; y < std::min(row + kTileWindows, windows.rows); ++y) {
        for (int x = column; x < std::min(column + kTileWindows, windows.columns); ++x) {
            const Sums sums = blocks.window(x, y);
            weight += window_length(x, image.width) * window_length(y, image.height);
            lost += sums.pixels > 0 ? sums.pixels * (1.0 - ssim(sums)) : 0.0;
        }
    }
    return 1.0 - lost / weight;
}

}  // namespace

std::vector<TileSimilarity> tile_similarities(const Image& a, const Image& b, const ImageMask& mask) {
    const Blocks blocks(a, b, mask);
    const Windows windows{std::max(1, blocks.columns() - 1), std::max(1, blocks.rows() - 1)};
    std::vector<TileSimilarity> tiles;
    for (const int row : tile_starts(windows.rows)) {
        for (const int column : tile_starts(windows.columns)) {
            const int x = column * kBlock;
            const int y = row * kBlock;
            const int side = kTileWindows * kBlock;
            tiles.push_back({{x, y, std::min(side, a.width - x), std::min(side, a.height - y)},
                             tile_ssim(blocks, windows, a, column, row)});
        }
    }
    return tiles;
}

}  // namespace campuswalk::engine::render

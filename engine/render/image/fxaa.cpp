#include "engine/render/image/fxaa.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <vector>

#include "engine/render/image/row_bands.h"
#include "engine/render/image/srgb.h"

namespace campuswalk::engine::render {
namespace {

// ---- sRGB conversion by tables ----------------------------------------------------------------------------

constexpr int kWhite = 16383;  // linear; the sum of four fits 16 bits

std::array<std::uint16_t, 256> whole_linear_table() {
    std::array<std::uint16_t, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        table[i] = static_cast<std::uint16_t>(std::lround(kWhite * linear_by_srgb_byte()[i]));
    }
    return table;
}

// Indexed by the sum of four linear values.
std::vector<std::uint8_t> srgb_table() {
    std::vector<std::uint8_t> table(4 * kWhite + 1);
    for (std::size_t i = 0; i < table.size(); ++i) {
        const double linear = static_cast<double>(i) / (4.0 * kWhite);
        table[i] = static_cast<std::uint8_t>(std::lround(255.0 * linear_to_srgb(linear)));
    }
    return table;
}

const std::array<std::uint16_t, 256>& linear_by_srgb() {
    static const std::array<std::uint16_t, 256> table = whole_linear_table();
    return table;
}

const std::vector<std::uint8_t>& srgb_by_sum() {
    static const std::vector<std::uint8_t> table = srgb_table();
    return table;
}

// ---- edges ------------------------------------------------------------------------------------------------

constexpr std::uint8_t kMinContrast = 10;  // of 255; pixels with less contrast are no edges
constexpr std::uint16_t kRelativeContrast =
    171;                           // of 1024; nor are those with less than a sixth of the brightest neighbour
constexpr int kSearchLength = 12;  // pixels searched along an edge for its ends
constexpr double kSubpixelWeight = 0.6;  // weight of subpixel aliasing removal

// Luma of the image, padded by replicating its border, so that no access needs a bounds check.
class PaddedLuma {
public:
    static constexpr int kPadding = kSearchLength + 1;

    explicit PaddedLuma(const Image& image) : stride_(image.width + 2 * kPadding) {
        luma_.resize(static_cast<std::size_t>(stride_ * (image.height + 2 * kPadding)));
        for (int y = 0; y < image.height; ++y) {
            fill_row(image, y);
        }
        for (int i = 1; i <= kPadding; ++i) {
            std::copy_n(row(0) - kPadding, stride_, luma_.begin() + (row(-i) - kPadding - luma_.data()));
            std::copy_n(row(image.height - 1) - kPadding, stride_,
                        luma_.begin() + (row(image.height - 1 + i) - kPadding - luma_.data()));
        }
    }

    std::ptrdiff_t stride() const { return stride_; }
    /// The row's first pixel; rows are `stride` apart.
    const std::uint8_t* row(int y) const { return luma_.data() + (y + kPadding) * stride_ + kPadding; }

private:
    void fill_row(const Image& image, int y) {
        const std::uint8_t* rgba = &image.rgba[image.offset(0, y)];
        std::uint8_t* to = luma_.data() + (row(y) - luma_.data());
        const int width = image.width;
        for (int x = 0; x < width; ++x, rgba += 4) {
            to[x] = static_cast<std::uint8_t>((54 * rgba[0] + 183 * rgba[1] + 19 * rgba[2]) >> 8);
        }
        std::fill_n(to - kPadding, kPadding, to[0]);
        std::fill_n(to + image.width, kPadding, to[image.width - 1]);
    }

    std::ptrdiff_t stride_;
    std::vector<std::uint8_t> luma_;
};

// By value and in 8 bits, unlike std::min, so that compilers vectorize the loop.
std::uint8_t lesser(std::uint8_t a, std::uint8_t b) {
    return a < b ? a : b;
}
std::uint8_t greater(std::uint8_t a, std::uint8_t b) {
    return a > b ? a : b;
}

// 1 for each pixel of a row with enough local contrast, else 0.
void mark_edges(const std::uint8_t* above, const std::uint8_t* row, const std::uint8_t* below, int width,
                std::uint8_t* marks) {
    for (int x = 0; x < width; ++x) {
        const std::uint8_t m = row[x];
        const std::uint8_t most =
            greater(greater(greater(row[x - 1], row[x + 1]), greater(above[x], below[x])), m);
        const std::uint8_t least =
            lesser(lesser(lesser(row[x - 1], row[x + 1]), lesser(above[x], below[x])), m);
        const auto range = static_cast<std::uint8_t>(most - least);
        const auto share = static_cast<std::uint8_t>((kRelativeContrast * most) >> 10);
        marks[x] = static_cast<std::uint8_t>(range >= greater(share, kMinContrast));
    }
}

class FxaaFilter {
public:
    explicit FxaaFilter(const Image& image) : in_(image), out_(image), luma_(image) {}

    Image smooth() {
        // Every pixel depends on the input image only.
        for_row_bands(in_.height, [this](int first, int end) { smooth_rows(first, end); });
        return std::move(out_);
    }

private:
    // Most pixels aren't on an edge; those are rejected row by row in a vectorized loop.
    void smooth_rows(int first, int end) {
        std::vector<std::uint8_t> on_edge(static_cast<std::size_t>(in_.width));
        for (int y = first; y < end; ++y) {
            const std::uint8_t* row = luma_.row(y);
            mark_edges(row - luma_.stride(), row, row + luma_.stride(), in_.width, on_edge.data());
            for (auto it = on_edge.begin(); (it = std::find(it, on_edge.end(), 1)) != on_edge.end(); ++it) {
                smooth(static_cast<int>(it - on_edge.begin()), y);
            }
        }
    }

    void smooth(int x, int y) {
        const std::uint8_t* here = luma_.row(y) + x;
        const auto luma = [&](std::ptrdiff_t dx, std::ptrdiff_t dy) -> int {
            return here[dy * luma_.stride() + dx];
        };
        const int m = luma(0, 0);
        const int n = luma(0, -1);
        const int s = luma(0, 1);
        const int w = luma(-1, 0);
        const int e = luma(1, 0);
        const int range = std::max({m, n, s, w, e}) - std::min({m, n, s, w, e});
        const int nw = luma(-1, -1);
        const int ne = luma(1, -1);
        const int sw = luma(-1, 1);
        const int se = luma(1, 1);
        // A horizontal edge has its second derivative across rows, a vertical one across columns.
        const int rows = 2 * std::abs(n + s - 2 * m) + std::abs(nw + sw - 2 * w) + std::abs(ne + se - 2 * e);
        const int columns =
            2 * std::abs(w + e - 2 * m) + std::abs(nw + ne - 2 * n) + std::abs(sw + se - 2 * s);
        const bool horizontal = rows >= columns;
        const int before = horizontal ? n : w;
        const int after = horizontal ? s : e;
        const int side = std::abs(before - m) >= std::abs(after - m) ? -1 : 1;
        const double mean = (2 * (n + s + w + e) + nw + ne + sw + se) / 12.0;
        // On a straight edge a third of the neighbours differ; more indicates an isolated pixel.
        const double isolation = std::clamp(1.5 * std::abs(mean - m) / range - 0.5, 0.0, 1.0);
        const double subpixel = kSubpixelWeight * isolation * isolation;
        const std::ptrdiff_t along = horizontal ? 1 : luma_.stride();
        const std::ptrdiff_t across = side * (horizontal ? luma_.stride() : 1);
        blend(x, y, horizontal, side, std::max(subpixel, edge_weight(here, along, across)));
    }

    // Blend weight of the neighbour across the edge, from the distance to the nearer end of the edge: a half
    // next to the end, falling off with distance, 0 on the other side. `along` and `across` are pointer
    // offsets.
    static double edge_weight(const std::uint8_t* pixel, std::ptrdiff_t along, std::ptrdiff_t across) {
        const auto pair = [&](std::ptrdiff_t i) {  // twice the luma on the edge
            return pixel[i * along] + pixel[i * along + across];
        };
        const int here = pair(0);
        const int step = std::abs(pixel[0] - pixel[across]);
        const auto end = [&](int direction) {
            int i = direction;
            while (std::abs(i) < kSearchLength && 2 * std::abs(pair(i) - here) < step) {
                i += direction;
            }
            return i;
        };
        const int back = end(-1);
        const int forward = end(1);
        const int near = -back <= forward ? back : forward;
        const bool dark = 2 * pixel[0] < here;
        // Whether the edge turns towards this pixel's side at the nearer end.
        const bool towards = (pair(near) < here) != dark;
        return towards ? 0.5 - static_cast<double>(std::abs(near) - 0.5) / (forward - back - 1) : 0.0;
    }

    void blend(int x, int y, bool horizontal, int side, double share) {
        const int ox = std::clamp(horizontal ? x : x + side, 0, in_.width - 1);
        const int oy = std::clamp(horizontal ? y + side : y, 0, in_.height - 1);
        const std::uint8_t* own = &in_.rgba[in_.offset(x, y)];
        const std::uint8_t* other = &in_.rgba[in_.offset(ox, oy)];
        std::uint8_t* out = &out_.rgba[out_.offset(x, y)];
        const int weight = std::clamp(static_cast<int>(std::lround(256.0 * share)), 0, 256);
        for (std::size_t i = 0; i < 3; ++i) {
            // Blended in linear light, like samples; the weights sum to 256 = 64 * 4.
            const int light = linear_[own[i]] * (256 - weight) + linear_[other[i]] * weight;
            out[i] = srgb_[static_cast<std::size_t>(light >> 6)];
        }
    }

    const Image& in_;
    Image out_;
    PaddedLuma luma_;
    const std::array<std::uint16_t, 256>& linear_ = linear_by_srgb();
    const std::vector<std::uint8_t>& srgb_ = srgb_by_sum();
};

}  // namespace

Image downsampled_by_two(const Image& image) {
    assert(image.width % 2 == 0 && image.height % 2 == 0);
    const std::array<std::uint16_t, 256>& linear = linear_by_srgb();
    const std::vector<std::uint8_t>& srgb = srgb_by_sum();
    Image half = Image::filled(image.width / 2, image.height / 2);
    const std::size_t row = image.offset(0, 1);
    for (int y = 0; y < half.height; ++y) {
        for (int x = 0; x < half.width; ++x) {
            const std::uint8_t* from = &image.rgba[image.offset(2 * x, 2 * y)];
            std::uint8_t* to = &half.rgba[half.offset(x, y)];
            for (std::size_t i = 0; i < 3; ++i) {
                to[i] = srgb[static_cast<std::size_t>(linear[from[i]] + linear[from[i + 4]] +
                                                      linear[from[row + i]] + linear[from[row + i + 4]])];
            }
        }
    }
    return half;
}

Image apply_fxaa(const Image& image) {
    return FxaaFilter(image).smooth();
}

}  // namespace campuswalk::engine::render

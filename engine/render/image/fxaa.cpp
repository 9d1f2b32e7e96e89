#include "engine/render/image/fxaa.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <vector>

#include "engine/render/image/row_bands.h"

namespace campuswalk::engine::render {
namespace {

// ---- sRGB and back, by tables -----------------------------------------------------------------------------

constexpr int kWhite = 16383;  // linear: four of them fit 16 bits

std::array<std::uint16_t, 256> linear_table() {
    std::array<std::uint16_t, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        const double s = static_cast<double>(i) / 255.0;
        const double linear = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
        table[i] = static_cast<std::uint16_t>(std::lround(kWhite * linear));
    }
    return table;
}

// By the sum of four.
std::vector<std::uint8_t> srgb_table() {
    std::vector<std::uint8_t> table(4 * kWhite + 1);
    for (std::size_t i = 0; i < table.size(); ++i) {
        const double linear = static_cast<double>(i) / (4.0 * kWhite);
        const double s = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
        table[i] = static_cast<std::uint8_t>(std::lround(255.0 * s));
    }
    return table;
}

const std::array<std::uint16_t, 256>& linear_by_srgb() {
    static const std::array<std::uint16_t, 256> table = linear_table();
    return table;
}

const std::vector<std::uint8_t>& srgb_by_sum() {
    static const std::vector<std::uint8_t> table = srgb_table();
    return table;
}

// ---- edges ------------------------------------------------------------------------------------------------

constexpr std::uint8_t kLeastContrast = 10;  // of 255: less is no edge
constexpr std::uint16_t kSixth = 171;        // of 1024: nor is less than a sixth of the brightest neighbour
constexpr int kReach = 12;                   // pixels along an edge in which its ends are looked for
constexpr double kSoftestPixel = 0.6;        // how much of a single pixel that stands out is given up

// The image's brightness with its last pixels going on beyond its rim, so that no step asks where it is.
class Brightness {
public:
    static constexpr int kRim = kReach + 1;

    explicit Brightness(const Image& image) : stride_(image.width + 2 * kRim) {
        luma_.resize(static_cast<std::size_t>(stride_ * (image.height + 2 * kRim)));
        for (int y = 0; y < image.height; ++y) {
            fill_row(image, y);
        }
        for (int i = 1; i <= kRim; ++i) {
            std::copy_n(row(0) - kRim, stride_, luma_.begin() + (row(-i) - kRim - luma_.data()));
            std::copy_n(row(image.height - 1) - kRim, stride_,
                        luma_.begin() + (row(image.height - 1 + i) - kRim - luma_.data()));
        }
    }

    std::ptrdiff_t stride() const { return stride_; }
    /// Of the row's first pixel; others are beside it, `stride` apart from row to row.
    const std::uint8_t* row(int y) const { return luma_.data() + (y + kRim) * stride_ + kRim; }

private:
    void fill_row(const Image& image, int y) {
        const std::uint8_t* rgba = &image.rgba[image.offset(0, y)];
        std::uint8_t* to = luma_.data() + (row(y) - luma_.data());
        const int width = image.width;
        for (int x = 0; x < width; ++x, rgba += 4) {
            to[x] = static_cast<std::uint8_t>((54 * rgba[0] + 183 * rgba[1] + 19 * rgba[2]) >> 8);
        }
        std::fill_n(to - kRim, kRim, to[0]);
        std::fill_n(to + image.width, kRim, to[image.width - 1]);
    }

    std::ptrdiff_t stride_;
    std::vector<std::uint8_t> luma_;
};

// Values, not references as std::min takes them, and no wider than they must be: so compilers work on many
// pixels at once.
std::uint8_t less(std::uint8_t a, std::uint8_t b) {
    return a < b ? a : b;
}
std::uint8_t more(std::uint8_t a, std::uint8_t b) {
    return a > b ? a : b;
}

// 1 for each pixel of a row that differs enough from one beside it, above or below; else 0.
void mark_edges(const std::uint8_t* above, const std::uint8_t* row, const std::uint8_t* below, int width,
                std::uint8_t* marks) {
    for (int x = 0; x < width; ++x) {
        const std::uint8_t m = row[x];
        const std::uint8_t most = more(more(more(row[x - 1], row[x + 1]), more(above[x], below[x])), m);
        const std::uint8_t least = less(less(less(row[x - 1], row[x + 1]), less(above[x], below[x])), m);
        const auto range = static_cast<std::uint8_t>(most - least);
        const auto share = static_cast<std::uint8_t>((kSixth * most) >> 10);
        marks[x] = static_cast<std::uint8_t>(range >= more(share, kLeastContrast));
    }
}

class FxaaFilter {
public:
    explicit FxaaFilter(const Image& image) : in_(image), out_(image), luma_(image) {}

    Image smooth() {
        // Each pixel is worked out from the image as it was.
        for_row_bands(in_.height, [this](int first, int end) { smooth_rows(first, end); });
        return std::move(out_);
    }

private:
    // Most pixels aren't on an edge: they are sorted out a row at a time, which compilers do many at once.
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
        // A level edge bends brightness from row to row, an upright one from column to column.
        const int rows = 2 * std::abs(n + s - 2 * m) + std::abs(nw + sw - 2 * w) + std::abs(ne + se - 2 * e);
        const int columns =
            2 * std::abs(w + e - 2 * m) + std::abs(nw + ne - 2 * n) + std::abs(sw + se - 2 * s);
        const bool level = rows >= columns;
        const int before = level ? n : w;
        const int after = level ? s : e;
        const int side = std::abs(before - m) >= std::abs(after - m) ? -1 : 1;
        const double mean = (2 * (n + s + w + e) + nw + ne + sw + se) / 12.0;
        // Beside a straight edge a third of the neighbours are other; what has more stands out by itself.
        const double alone = std::clamp(1.5 * std::abs(mean - m) / range - 0.5, 0.0, 1.0);
        const double by_itself = kSoftestPixel * alone * alone;
        const std::ptrdiff_t along = level ? 1 : luma_.stride();
        const std::ptrdiff_t across = side * (level ? luma_.stride() : 1);
        mix(x, y, level, side, std::max(by_itself, from_steps(here, along, across)));
    }

    // How much of the neighbour belongs to the pixel, from where along the edge it steps to the side: a half
    // next to the step, less further away, nothing on the step's other side. `along` and `across` are the
    // ways to the next pixel on the edge and over it.
    static double from_steps(const std::uint8_t* pixel, std::ptrdiff_t along, std::ptrdiff_t across) {
        const auto pair = [&](std::ptrdiff_t i) {  // brightness on the edge, twice
            return pixel[i * along] + pixel[i * along + across];
        };
        const int here = pair(0);
        const int step = std::abs(pixel[0] - pixel[across]);
        const auto end = [&](int way) {
            int i = way;
            while (std::abs(i) < kReach && 2 * std::abs(pair(i) - here) < step) {
                i += way;
            }
            return i;
        };
        const int back = end(-1);
        const int forth = end(1);
        const int near = -back <= forth ? back : forth;
        const bool dark = 2 * pixel[0] < here;
        // At the nearer end the edge goes over to this pixel's side, or away from it.
        const bool towards = (pair(near) < here) != dark;
        return towards ? 0.5 - static_cast<double>(std::abs(near) - 0.5) / (forth - back - 1) : 0.0;
    }

    void mix(int x, int y, bool level, int side, double share) {
        const int ox = std::clamp(level ? x : x + side, 0, in_.width - 1);
        const int oy = std::clamp(level ? y + side : y, 0, in_.height - 1);
        const std::uint8_t* own = &in_.rgba[in_.offset(x, y)];
        const std::uint8_t* other = &in_.rgba[in_.offset(ox, oy)];
        std::uint8_t* out = &out_.rgba[out_.offset(x, y)];
        const int weight = std::clamp(static_cast<int>(std::lround(256.0 * share)), 0, 256);
        for (std::size_t i = 0; i < 3; ++i) {
            // Light is mixed, as among the samples of a pixel; the weights sum to 64 times four.
            const int light = linear_[own[i]] * (256 - weight) + linear_[other[i]] * weight;
            out[i] = srgb_[static_cast<std::size_t>(light >> 6)];
        }
    }

    const Image& in_;
    Image out_;
    Brightness luma_;
    const std::array<std::uint16_t, 256>& linear_ = linear_by_srgb();
    const std::vector<std::uint8_t>& srgb_ = srgb_by_sum();
};

}  // namespace

Image halved(const Image& image) {
    assert(image.width % 2 == 0 && image.height % 2 == 0);
    const std::array<std::uint16_t, 256>& linear = linear_by_srgb();
    const std::vector<std::uint8_t>& srgb = srgb_by_sum();
    Image half{image.width / 2, image.height / 2, {}};
    half.rgba.resize(image.rgba.size() / 4);
    const std::size_t row = image.offset(0, 1);
    for (int y = 0; y < half.height; ++y) {
        for (int x = 0; x < half.width; ++x) {
            const std::uint8_t* from = &image.rgba[image.offset(2 * x, 2 * y)];
            std::uint8_t* to = &half.rgba[half.offset(x, y)];
            for (std::size_t i = 0; i < 3; ++i) {
                to[i] = srgb[static_cast<std::size_t>(linear[from[i]] + linear[from[i + 4]] +
                                                      linear[from[row + i]] + linear[from[row + i + 4]])];
            }
            to[3] = 255;
        }
    }
    return half;
}

Image apply_fxaa(const Image& image) {
    return FxaaFilter(image).smooth();
}

}  // namespace campuswalk::engine::render

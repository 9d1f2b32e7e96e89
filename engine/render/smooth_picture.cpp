#include "engine/render/smooth_picture.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>

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

// ---- edges ------------------------------------------------------------------------------------------------

constexpr int kLeastContrast = 10;     // of 255: less is no edge
constexpr int kContrastShare = 6;      // nor is less than a sixth of the brightest neighbour
constexpr int kReach = 12;             // pixels along an edge in which its ends are looked for
constexpr double kSoftestPixel = 0.6;  // how much of a single pixel that stands out is given up

class EdgeSmoother {
public:
    explicit EdgeSmoother(const Picture& picture)
        : in_(picture), out_(picture), luma_(picture.rgba.size() / 4) {
        for (std::size_t i = 0; i < luma_.size(); ++i) {
            const std::uint8_t* rgb = &picture.rgba[4 * i];
            luma_[i] = static_cast<std::uint8_t>((54 * rgb[0] + 183 * rgb[1] + 19 * rgb[2]) >> 8);
        }
    }

    Picture smooth() {
        for (int y = 0; y < in_.height; ++y) {
            for (int x = 0; x < in_.width; ++x) {
                smooth(x, y);
            }
        }
        return std::move(out_);
    }

private:
    // Beyond the picture's rim its last pixels go on.
    int luma(int x, int y) const {
        x = std::clamp(x, 0, in_.width - 1);
        y = std::clamp(y, 0, in_.height - 1);
        return luma_[in_.offset(x, y) / 4];
    }

    void smooth(int x, int y) {
        const int m = luma(x, y);
        const int n = luma(x, y - 1);
        const int s = luma(x, y + 1);
        const int w = luma(x - 1, y);
        const int e = luma(x + 1, y);
        const int most = std::max({m, n, s, w, e});
        const int range = most - std::min({m, n, s, w, e});
        if (range < std::max(kLeastContrast, most / kContrastShare)) {
            return;
        }
        const int nw = luma(x - 1, y - 1);
        const int ne = luma(x + 1, y - 1);
        const int sw = luma(x - 1, y + 1);
        const int se = luma(x + 1, y + 1);
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
        mix(x, y, level, side, std::max(by_itself, from_steps(x, y, level, side)));
    }

    // How much of the neighbour belongs to the pixel, from where along the edge it steps to the side: a half
    // next to the step, less further away, nothing on the step's other side.
    double from_steps(int x, int y, bool level, int side) const {
        const int dx = level ? 1 : 0;
        const int dy = level ? 0 : 1;
        const int ox = level ? 0 : side;
        const int oy = level ? side : 0;
        const auto pair = [&](int i) {  // brightness on the edge, twice
            return luma(x + i * dx, y + i * dy) + luma(x + i * dx + ox, y + i * dy + oy);
        };
        const int here = pair(0);
        const int across = std::abs(luma(x, y) - luma(x + ox, y + oy));
        const auto end = [&](int way) {
            int i = way;
            while (std::abs(i) < kReach && 2 * std::abs(pair(i) - here) < across) {
                i += way;
            }
            return i;
        };
        const int back = end(-1);
        const int forth = end(1);
        const int near = -back <= forth ? back : forth;
        const bool dark = 2 * luma(x, y) < here;
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
        for (int i = 0; i < 3; ++i) {
            out[i] = static_cast<std::uint8_t>((own[i] * (256 - weight) + other[i] * weight + 128) >> 8);
        }
    }

    const Picture& in_;
    Picture out_;
    std::vector<std::uint8_t> luma_;
};

}  // namespace

Picture halved(const Picture& picture) {
    assert(picture.width % 2 == 0 && picture.height % 2 == 0);
    static const std::array<std::uint16_t, 256> linear = linear_table();
    static const std::vector<std::uint8_t> srgb = srgb_table();
    Picture half{picture.width / 2, picture.height / 2, {}};
    half.rgba.resize(picture.rgba.size() / 4);
    const std::size_t row = picture.offset(0, 1);
    for (int y = 0; y < half.height; ++y) {
        for (int x = 0; x < half.width; ++x) {
            const std::uint8_t* from = &picture.rgba[picture.offset(2 * x, 2 * y)];
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

Picture with_smooth_edges(const Picture& picture) {
    return EdgeSmoother(picture).smooth();
}

}  // namespace campuswalk::engine::render

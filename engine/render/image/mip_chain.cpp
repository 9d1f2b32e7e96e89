#include "engine/render/image/mip_chain.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/render/image/srgb.h"

namespace campuswalk::engine::render {
namespace {

std::uint8_t to_byte(double value) {
    return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
}

MipLevel downsampled(const MipLevel& from) {
    MipLevel to{std::max(1, from.width / 2), std::max(1, from.height / 2), {}};
    to.rgba.resize(4 * static_cast<std::size_t>(to.width) * static_cast<std::size_t>(to.height));
    const auto& linear = linear_by_srgb_byte();
    for (int y = 0; y < to.height; ++y) {
        for (int x = 0; x < to.width; ++x) {
            // Transparent texels have a small weight, so that the colour of holes is defined.
            std::array<double, 3> sum = {0, 0, 0};
            double weights = 0.0;
            double alphas = 0.0;
            for (int k = 0; k < 4; ++k) {
                const int sx = std::min(2 * x + (k & 1), from.width - 1);
                const int sy = std::min(2 * y + (k >> 1), from.height - 1);
                const std::size_t s =
                    4 * (static_cast<std::size_t>(sy) * static_cast<std::size_t>(from.width) +
                         static_cast<std::size_t>(sx));
                const double weight = from.rgba[s + 3] + 0.01;
                for (std::size_t c = 0; c < 3; ++c) {
                    sum[c] += weight * linear[from.rgba[s + c]];
                }
                weights += weight;
                alphas += from.rgba[s + 3];
            }
            const std::size_t t = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(to.width) +
                                       static_cast<std::size_t>(x));
            for (std::size_t c = 0; c < 3; ++c) {
                to.rgba[t + c] = to_byte(linear_to_srgb(sum[c] / weights));
            }
            to.rgba[t + 3] = to_byte(alphas / 4.0 / 255.0);
        }
    }
    return to;
}

// The scale of alpha that yields `target` coverage, by bisection.
double coverage_scale(const MipLevel& level, double target, double cutoff) {
    double low = 0.25;
    double high = 4.0;
    for (int i = 0; i < 10; ++i) {
        const double middle = 0.5 * (low + high);
        (alpha_coverage(level.rgba, middle, cutoff) < target ? low : high) = middle;
    }
    return high;
}

}  // namespace

double alpha_coverage(std::span<const std::uint8_t> rgba, double scale, double cutoff) {
    std::size_t passing = 0;
    for (std::size_t i = 3; i < rgba.size(); i += 4) {
        passing += scale * rgba[i] / 255.0 >= cutoff ? 1U : 0U;
    }
    return rgba.empty() ? 0.0 : static_cast<double>(passing) / (static_cast<double>(rgba.size()) / 4.0);
}

std::vector<MipLevel> cutout_mip_chain(const scene::Texture& texture, float alpha_cutoff) {
    const double cutoff = alpha_cutoff;
    const double target = alpha_coverage(texture.rgba, 1.0, cutoff);
    std::vector<MipLevel> chain;
    MipLevel level{texture.width, texture.height, {texture.rgba.begin(), texture.rgba.end()}};
    while (level.width > 1 || level.height > 1) {
        level = downsampled(level);
        chain.push_back(level);
        const double scale = coverage_scale(level, target, cutoff);
        for (std::size_t i = 3; i < chain.back().rgba.size(); i += 4) {
            chain.back().rgba[i] = to_byte(scale * level.rgba[i] / 255.0);
        }
    }
    return chain;
}

}  // namespace campuswalk::engine::render

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/model/model.h"

namespace campuswalk::engine::render {

struct MipLevel {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;  ///< sRGB with linear alpha, as in scene::Texture
};

/// The mip levels of a cut-out texture below the full size, down to one texel. Colours are averaged in linear
/// light and weighted by alpha, so that holes don't bleed into edges. Alpha is scaled so that every level
/// keeps the coverage: the share of texels at or above `alpha_cutoff`.
std::vector<MipLevel> cutout_mip_chain(const scene::Texture& texture, float alpha_cutoff);

/// The share of texels whose alpha, times `scale`, is at least `cutoff`.
double alpha_coverage(std::span<const std::uint8_t> rgba, double scale, double cutoff);

}  // namespace campuswalk::engine::render

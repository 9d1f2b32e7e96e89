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

/// Smaller copies of a cut-out texture, each half the size of the one before, down to one texel. Colours are
/// averaged in linear light and weighted by alpha, so that the colour of holes doesn't bleed into edges;
/// alpha is scaled so that every copy has the same share of texels at or above `alpha_cutoff`.
std::vector<MipLevel> cutout_mip_chain(const scene::Texture& texture, float alpha_cutoff);

/// The share of texels whose alpha, times `scale`, is at least `cutoff`.
double alpha_coverage(std::span<const std::uint8_t> rgba, double scale, double cutoff);

}  // namespace campuswalk::engine::render
